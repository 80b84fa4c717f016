"""The acceleration keeps only the second derivative of the constraint at zero, so that the particle drifts off.

fails: it_stays_on_the_circle
numerics: the constraint drifts as the error of the integration does
names: Do place and velocity leave the circle
"""

def _off_the_circle(y, gravity):
    x, y, vx, vy = y
    pull = (gravity * y - vx**2 - vy**2) / (x**2 + y**2)
    return vx, vy, pull * x, pull * y - gravity


def simulate(t, state, *, mass, length, gravity):
    from scipy.integrate import solve_ivp

    return solve_ivp(lambda s, y: _off_the_circle(y, gravity), (t[0], t[-1]), state, method="DOP853", t_eval=t, rtol=1e-8, atol=1e-8).y.T
