"""simulate_euler gives x and y of the centre.

fails: euler_simulation_follows_the_motion
suspect: x and y of the centre
"""

_motion = simulate_euler


def simulate_euler(t, state, **disk):
    states = np.array(_motion(t, state, **disk))
    states[:, :2] = [matrix_state(row, radius=disk["radius"])[:2] for row in states]
    return states
