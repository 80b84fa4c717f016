"""The force has components along e1, e2, e3; they should be along x, y, z.

fails: contact_force_moves_the_centre
"""


_force = contact_force


def contact_force(state, **disk):
    return _frame(state) @ _force(state, **disk)
