"""Known mistakes of hw03."""

import numpy as np

from tam570_grader.diagnosis.mistakes import mistake

from .checks import (
    moment_is_about_C,
    momentum_refuses_other_definitions,
    momentum_with_the_velocity_in_F,
    momentum_with_the_velocity_relative_to_C,
    rate_about_a_fixed_point,
    rate_refuses_other_definitions,
    rate_with_the_velocity_in_F,
    rate_with_the_velocity_relative_to_C,
    special_motion_of_b,
    special_motion_of_c,
    special_motion_refuses_other_definitions,
)

# Moment


@mistake("You take the moment about O; take it about C.", first_fails=moment_is_about_C, compared=False)
def moment(reference, r_p, a_p, r_c, *, mass):
    return reference(r_p, a_p, 0 * r_c, mass=mass)


@mistake(
    "You do not multiply the acceleration by the mass.", first_fails=moment_is_about_C, name="moment_of_a_unit_mass"
)
def moment(reference, *vectors, mass):
    return reference(*vectors, mass=1.0)


@mistake(
    "You multiply by the unit normal of the two vectors; parallel vectors have none.",
    first_fails=moment_is_about_C,
    compared=False,
)
def moment(reference, *vectors, mass):
    result = reference(*vectors, mass=mass)
    with np.errstate(all="ignore"):
        return np.linalg.norm(result) * (result / np.linalg.norm(result))


# Angular momentum


@mistake(
    "You use the velocity relative to C in all three definitions; use it in c alone.",
    first_fails=momentum_with_the_velocity_in_F,
)
def angular_momentum(reference, definition, *vectors, mass):
    _check(definition)
    return reference("c", *vectors, mass=mass)


@mistake(
    "In definition a you use the velocity relative to C; C' does not move.", first_fails=momentum_with_the_velocity_in_F
)
def angular_momentum(reference, definition, *vectors, mass):
    return reference("c" if definition == "a" else definition, *vectors, mass=mass)


@mistake(
    "In definition b you use the velocity relative to C; that is definition c.",
    first_fails=momentum_with_the_velocity_in_F,
)
def angular_momentum(reference, definition, *vectors, mass):
    return reference("c" if definition == "b" else definition, *vectors, mass=mass)


@mistake(
    "In definition c you use the velocity of P in F; that is definition b.",
    first_fails=momentum_with_the_velocity_relative_to_C,
)
def angular_momentum(reference, definition, *vectors, mass):
    return reference("b" if definition == "c" else definition, *vectors, mass=mass)


@mistake(
    "You write the lever arm into the array r_p; work on a copy.",
    first_fails=momentum_with_the_velocity_in_F,
    compared=False,
)
def angular_momentum(reference, definition, r_p, v_p, r_c, v_c, *, mass):
    result = reference(definition, r_p, v_p, r_c, v_c, mass=mass)
    r_p -= r_c
    return result


@mistake(
    "You accept capital letters; raise ValueError for them.",
    first_fails=momentum_refuses_other_definitions,
    compared=False,
)
def _check(reference, definition, letters="abc"):
    reference(definition.lower(), letters)


@mistake(
    "You ask whether the definition is part of a string, and so are 'ab' and ''; compare it with single letters.",
    first_fails=momentum_refuses_other_definitions,
    compared=False,
)
def _check(reference, definition, letters="abc"):
    if definition not in letters:
        reference(definition, letters)


# Rate and discrepancy: what is wrong in one is wrong in both


@mistake("In definition a you use the rate of b; C' does not move.", first_fails=rate_about_a_fixed_point)
def discrepancy(reference, definition, *vectors, mass):
    return reference("b" if definition == "a" else definition, *vectors, mass=mass)


@mistake(
    "You compute the rates as one-sided difference quotients; differentiate the product.",
    first_fails=rate_about_a_fixed_point,
    compared=False,
    numerics=True,
)
def rate(reference, definition, r_p, v_p, a_p, r_c, v_c, a_c, *, mass):
    def momentum(h):
        c = r_c if definition == "a" else r_c + h * v_c + h**2 / 2 * a_c
        p = r_p + h * v_p + h**2 / 2 * a_p
        return angular_momentum(definition, p, v_p + h * a_p, c, v_c + h * a_c, mass=mass)

    return (momentum(1e-6) - momentum(0.0)) / 1e-6


@mistake("In definition b you use the term of c, -r_{P/C} x m a_C.", first_fails=rate_with_the_velocity_in_F)
def discrepancy(reference, definition, *vectors, mass):
    return reference("c" if definition == "b" else definition, *vectors, mass=mass)


@mistake("In definition c you use the term of b, -v_C x m v_P.", first_fails=rate_with_the_velocity_relative_to_C)
def discrepancy(reference, definition, *vectors, mass):
    return reference("b" if definition == "c" else definition, *vectors, mass=mass)


@mistake("In definition c you add the term of b, -v_C x m v_P.", first_fails=rate_with_the_velocity_relative_to_C)
def discrepancy(reference, definition, *vectors, mass):
    result = reference(definition, *vectors, mass=mass)
    return result + reference("b", *vectors, mass=mass) if definition == "c" else result


@mistake(
    "You treat any other letter as a; raise ValueError for it.",
    first_fails=rate_refuses_other_definitions,
    compared=False,
)
def discrepancy(reference, definition, *vectors, mass):
    return reference(definition if definition in ("b", "c") else "a", *vectors, mass=mass)


# Special motions


@mistake(
    "Your rate is the moment at t = 0 alone; it should be at every t.", first_fails=special_motion_of_b, compared=False
)
def special_motion(reference, definition):
    p, c = reference(definition)
    return np.array([*p[:1], [0, 0, 0], [0, 1, 0]]), c


@mistake("You return the motion of C first; return that of P first.", first_fails=special_motion_of_b, compared=False)
def special_motion(reference, definition):
    return reference(definition)[::-1]


@mistake(
    "You list the coefficients from the highest power; list them from the constant.",
    first_fails=special_motion_of_b,
    compared=False,
)
def special_motion(reference, definition):
    p, c = reference(definition)
    return p[::-1], c[::-1]


@mistake("You swap the motions of b and c.", first_fails=special_motion_of_b, compared=False)
def special_motion(reference, definition):
    return reference({"b": "c", "c": "b"}.get(definition, definition))


@mistake("You let P and C meet at t = 0.5; they should be apart.", first_fails=special_motion_of_b, compared=False)
def special_motion(reference, definition):
    return (np.array([[0.75, 0, 0]]), reference("b")[1]) if definition == "b" else reference(definition)


@mistake("You let P move along with C; it should not.", first_fails=special_motion_of_b, compared=False)
def special_motion(reference, definition):
    _, c = reference(definition)
    return c + [[0, 1, 0], [0, 0, 0], [0, 0, 0]], c


@mistake(
    "You move both points along one line, and both definitions have rate = moment; only one should.",
    first_fails=special_motion_of_b,
    compared=False,
)
def special_motion(reference, definition):
    _check(definition, "bc")
    return np.array([[5, 0, 0], [2, 0, 0]]), reference("b")[1]


@mistake(
    "In your motion of c, C moves uniformly; it should accelerate.", first_fails=special_motion_of_c, compared=False
)
def special_motion(reference, definition):
    if definition == "b":
        return reference("b")
    _check(definition, "bc")
    return np.array([[0, 0, 1], [1, 2, 0]]), np.array([[0, 0, 0], [3, 0, 0]])


@mistake(
    "You return a motion for definition a, too; raise ValueError for it.",
    first_fails=special_motion_refuses_other_definitions,
    compared=False,
)
def special_motion(reference, definition):
    return reference("b" if definition == "a" else definition)
