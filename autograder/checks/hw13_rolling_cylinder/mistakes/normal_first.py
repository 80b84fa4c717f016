"""The result is (normal, along); it should be (along, normal).

fails: contact_force_accelerates_G
"""

_right = contact_force


def contact_force(phi, phi_dot, **cylinder):
    return _right(phi, phi_dot, **cylinder)[::-1]
