"""The weight's moment has sin(phi - slope) where sin(phi + slope) belongs.

fails: acceleration_balances_momentum_about_G, naive_acceleration_is_the_moment_over_the_inertia, contact_force_accelerates_G, simulate_rolls_and_rocks
"""


def _weight_moment(phi, mass, radius, offset, slope, gravity):
    return mass * gravity * (radius * math.sin(slope) - offset * math.sin(phi - slope))
