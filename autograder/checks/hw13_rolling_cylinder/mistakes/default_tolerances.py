"""solve_ivp runs at its default tolerances, which are too loose.

fails: simulate_rolls_and_rocks
numerics: solve_ivp's own rtol of 1e-3
"""


def simulate(t, phi, phi_dot, **c):
    from scipy.integrate import solve_ivp

    return solve_ivp(lambda s, y: (y[1], acceleration(*y, **c)), (t[0], t[-1]), (phi, phi_dot), t_eval=t).y.T
