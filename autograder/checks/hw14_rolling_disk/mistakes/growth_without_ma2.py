"""The growth rate has A where A + m a^2 belongs, the inertia about the contact.

fails: growth_rate_is_that_of_a_small_lean
"""


_growth = growth_rate_squared


def growth_rate_squared(speed, **disk):
    return _growth(speed, **disk) * (disk["inertia"][0] + disk["mass"] * disk["radius"] ** 2) / disk["inertia"][0]
