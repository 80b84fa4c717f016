"""The free bars are given a thousandth of the total mass at least.

fails: free_bars_with_a_nearly_massless_one
names: Is anything added to the masses
"""

as_given = on_the_fly


def on_the_fly(theta, omega, *, masses, lengths, gravity):
    masses = np.maximum(masses, 1e-3 * np.sum(masses))
    return as_given(theta, omega, masses=masses, lengths=lengths, gravity=gravity)
