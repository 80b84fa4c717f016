"""The rates are difference quotients to one side.

fails: rate_about_a_fixed_point, rate_with_the_velocity_in_F, rate_with_the_velocity_relative_to_C
names: is it a difference quotient
numerics: a difference of first order
"""

_right_rate = rate


def rate(definition, r_p, v_p, a_p, r_c, v_c, a_c, *, mass):
    def momentum(h):
        held = r_c if definition == "a" else r_c + h * v_c + h**2 / 2 * a_c
        moved = r_p + h * v_p + h**2 / 2 * a_p
        return angular_momentum(definition, moved, v_p + h * a_p, held, v_c + h * a_c, mass=mass)

    return (momentum(1e-6) - momentum(0.0)) / 1e-6
