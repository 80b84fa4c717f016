"""Speeds are divided by the terminal speed m g/c, which is infinite without drag, and zero without gravity.

fails: rates_without_drag_or_gravity
names: NaN or infinity for zero gravity
"""


def state_derivative(t, state, *, mass, drag, gravity):
    _, _, vx, vy = state
    with np.errstate(all="ignore"):
        terminal = np.float64(mass * gravity) / drag
        return np.array([vx, vy, -gravity * vx / terminal, -gravity * (vy / terminal + 1)])
