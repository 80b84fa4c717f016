"""The place is put back onto the circle, but the velocity is not made tangent.

fails: it_stays_on_the_circle
numerics: the constraint drifts as the error of the integration does
names: is the velocity made tangent
"""

def _off_the_circle(y, gravity):
    x, y, vx, vy = y
    pull = (gravity * y - vx**2 - vy**2) / (x**2 + y**2)
    return vx, vy, pull * x, pull * y - gravity


def _drifting(t, state, *, mass, length, gravity):
    from scipy.integrate import solve_ivp

    return solve_ivp(lambda s, y: _off_the_circle(y, gravity), (t[0], t[-1]), state, method="DOP853", t_eval=t, rtol=1e-8, atol=1e-8).y.T


def simulate(t, state, *, mass, length, gravity):
    states = _drifting(t, state, mass=mass, length=length, gravity=gravity).copy()
    states[:, :2] *= length / np.hypot(states[:, 0], states[:, 1])[:, None]
    return states
