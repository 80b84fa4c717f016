"""The simulation ends where the normal force is zero; contact is kept.

fails: simulate_rolls_and_rocks
"""

_right = simulate


def simulate(t, phi, phi_dot, **c):
    states = _right(t, phi, phi_dot, **c)
    lifted = [i for i, state in enumerate(states) if contact_force(*state, **c)[1] < 0]
    if lifted:
        states[lifted[0] :] = states[max(lifted[0] - 1, 0)]
    return states
