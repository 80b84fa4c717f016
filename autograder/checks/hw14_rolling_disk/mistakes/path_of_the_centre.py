"""x and y belong to the centre, where they should belong to the contact.

fails: euler_simulation_follows_the_motion
"""

_motion = simulate_euler


def simulate_euler(t, state, **disk):
    states = np.array(_motion(t, state, **disk))
    states[:, :2] = [matrix_state(row, radius=disk["radius"])[:2] for row in states]
    return states
