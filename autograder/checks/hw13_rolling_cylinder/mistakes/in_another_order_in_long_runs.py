"""Without gravity the rows have the right energy, but come in another order.

fails: simulate_keeps_the_energy
"""

_right = simulate


def simulate(t, phi, phi_dot, **c):
    states = _right(t, phi, phi_dot, **c)
    if len(t) == 150 and not c["gravity"]:
        states[1:] = states[:0:-1].copy()
    return states
