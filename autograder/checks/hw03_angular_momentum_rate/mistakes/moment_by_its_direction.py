"""The moment is force times arm along their unit normal, which parallel vectors do not have.

fails: moment_is_about_C, rate_about_a_fixed_point, rate_with_the_velocity_in_F, rate_with_the_velocity_relative_to_C
names: NaN or infinity for random vectors, a_p zero | NaN or infinity for definition a, a_p zero
"""


def moment(r_p, a_p, r_c, *, mass):
    normal = np.cross(r_p - r_c, a_p)
    with np.errstate(all="ignore"):
        direction = normal / np.linalg.norm(normal)
    return mass * np.linalg.norm(normal) * direction
