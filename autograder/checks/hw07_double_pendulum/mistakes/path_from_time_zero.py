"""The path is drawn from t = 0 on, not from t[0].

fails: tip_path_is_drawn
names: does it run from t[0] to t[-1]
"""

_right_plot = plot_tip_path


def plot_tip_path(ax, t, theta, omega, **known):
    _right_plot(ax, np.linspace(0.0, abs(t[-1]), len(t)), theta, omega, **known)
