"""The product of the differences of inertias is not divided by the other two inertias.

fails: small_deviations_grow_at_this_rate
"""


def growth_rate_squared(axis, spin, *, inertia):
    about, following, last = (inertia[(axis + k) % 3] for k in range(3))
    return (last - about) * (about - following) * spin**2
