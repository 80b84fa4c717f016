"""The force has components along axes that roll with the disk; they should be along x, y, z.

fails: contact_force_moves_the_centre
"""


_force = contact_force


def contact_force(state, **disk):
    R = np.reshape(matrix_state(state, radius=disk["radius"])[3:12], (3, 3))
    return R.T @ _force(state, **disk)
