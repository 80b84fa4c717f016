"""Known mistakes of hw03."""

import numpy as np

from tam570_grader.diagnosis.mistakes import mistake

from . import checks

# Moment


@mistake(first_fails=checks.moment_is_about_C, name="moment_of_a_unit_mass")
def moment(reference, *vectors, mass):
    """You do not multiply the acceleration by the mass."""
    return reference(*vectors, mass=1.0)


@mistake(first_fails=checks.moment_is_about_C, compared=False)
def moment(reference, *vectors, mass):
    """You multiply by the unit normal of the two vectors; parallel vectors have none."""
    result = reference(*vectors, mass=mass)
    with np.errstate(all="ignore"):
        return np.linalg.norm(result) * (result / np.linalg.norm(result))


# Angular momentum


@mistake(first_fails=checks.momentum_with_the_velocity_in_F)
def angular_momentum(reference, definition, *vectors, mass):
    """You use the velocity relative to C in all three definitions; use it in c alone."""
    _check(definition)
    return reference("c", *vectors, mass=mass)


@mistake(first_fails=checks.momentum_with_the_velocity_in_F)
def angular_momentum(reference, definition, *vectors, mass):
    """In definition a you use the velocity relative to C; C' does not move."""
    return reference("c" if definition == "a" else definition, *vectors, mass=mass)


@mistake(first_fails=checks.momentum_with_the_velocity_in_F)
def angular_momentum(reference, definition, *vectors, mass):
    """In definition b you use the velocity relative to C; that is definition c."""
    return reference("c" if definition == "b" else definition, *vectors, mass=mass)


@mistake(first_fails=checks.momentum_with_the_velocity_relative_to_C)
def angular_momentum(reference, definition, *vectors, mass):
    """In definition c you use the velocity of P in F; that is definition b."""
    return reference("b" if definition == "c" else definition, *vectors, mass=mass)


@mistake(first_fails=checks.momentum_with_the_velocity_in_F, compared=False)
def angular_momentum(reference, definition, r_p, v_p, r_c, v_c, *, mass):
    """You write the lever arm into the array r_p; work on a copy."""
    result = reference(definition, r_p, v_p, r_c, v_c, mass=mass)
    r_p -= r_c
    return result


@mistake(first_fails=checks.momentum_refuses_other_definitions, compared=False)
def _check(reference, definition, letters="abc"):
    """You accept capital letters; raise ValueError for them."""
    reference(definition.lower(), letters)


@mistake(first_fails=checks.momentum_refuses_other_definitions, compared=False)
def _check(reference, definition, letters="abc"):
    """You ask whether the definition is part of a string, and so are 'ab' and ''; compare it with single letters."""
    if definition not in letters:
        reference(definition, letters)


# Rate and discrepancy: what is wrong in one is wrong in both


@mistake(first_fails=checks.rate_about_a_fixed_point)
def rate(reference, definition, *vectors, mass):
    """In definition a you use the rate of b; C' does not move."""
    return reference("b" if definition == "a" else definition, *vectors, mass=mass)


@mistake(first_fails=checks.rate_about_a_fixed_point, compared=False, numerics=True)
def rate(reference, definition, r_p, v_p, a_p, r_c, v_c, a_c, *, mass):
    """You compute the rates as one-sided difference quotients; differentiate the product."""

    def momentum(h):
        c = r_c if definition == "a" else r_c + h * v_c + h**2 / 2 * a_c
        p = r_p + h * v_p + h**2 / 2 * a_p
        return angular_momentum(definition, p, v_p + h * a_p, c, v_c + h * a_c, mass=mass)

    return (momentum(1e-6) - momentum(0.0)) / 1e-6


@mistake(first_fails=checks.rate_with_the_velocity_in_F)
def rate(reference, definition, *vectors, mass):
    """In definition b you use the term of c, -r_{P/C} x m a_C."""
    return reference("c" if definition == "b" else definition, *vectors, mass=mass)


@mistake(first_fails=checks.rate_with_the_velocity_relative_to_C)
def rate(reference, definition, *vectors, mass):
    """In definition c you use the term of b, -v_C x m v_P."""
    return reference("b" if definition == "c" else definition, *vectors, mass=mass)


@mistake(first_fails=checks.rate_with_the_velocity_relative_to_C)
def rate(reference, definition, *vectors, mass):
    """In definition c you add the term of b, -v_C x m v_P."""
    result = reference(definition, *vectors, mass=mass)
    return result - np.cross(vectors[4], mass * vectors[1]) if definition == "c" else result


@mistake(first_fails=checks.rate_refuses_other_definitions, compared=False)
def rate(reference, definition, *vectors, mass):
    """You treat any other letter as a; raise ValueError for it."""
    return reference(definition if definition in ("b", "c") else "a", *vectors, mass=mass)


# Special motions


@mistake(first_fails=checks.special_motion_of_b, compared=False)
def special_motion(reference, definition):
    """Your rate is the moment at t = 0 alone; it should be at every t."""
    p, c = reference(definition)
    return np.array([*p[:1], [0, 0, 0], [0, 1, 0]]), c


@mistake(first_fails=checks.special_motion_of_b, compared=False)
def special_motion(reference, definition):
    """You return the motion of C first; return that of P first."""
    return reference(definition)[::-1]


@mistake(first_fails=checks.special_motion_of_b, compared=False)
def special_motion(reference, definition):
    """You list the coefficients from the highest power; list them from the constant."""
    p, c = reference(definition)
    return p[::-1], c[::-1]


@mistake(first_fails=checks.special_motion_of_b, compared=False)
def special_motion(reference, definition):
    """You swap the motions of b and c."""
    return reference({"b": "c", "c": "b"}.get(definition, definition))


@mistake(first_fails=checks.special_motion_of_b, compared=False)
def special_motion(reference, definition):
    """You let P and C meet at t = 0.5; they should be apart."""
    return (np.array([[0.75, 0, 0]]), reference("b")[1]) if definition == "b" else reference(definition)


@mistake(first_fails=checks.special_motion_of_b, compared=False)
def special_motion(reference, definition):
    """You let P move along with C; it should not."""
    _, c = reference(definition)
    return c + [[0, 1, 0], [0, 0, 0], [0, 0, 0]], c


@mistake(first_fails=checks.special_motion_of_b, compared=False)
def special_motion(reference, definition):
    """You move both points along one line, and both definitions have rate = moment; only one should."""
    _check(definition, "bc")
    return np.array([[5, 0, 0], [2, 0, 0]]), reference("b")[1]


@mistake(first_fails=checks.special_motion_of_c, compared=False)
def special_motion(reference, definition):
    """In your motion of c, C moves uniformly; it should accelerate."""
    if definition == "b":
        return reference("b")
    _check(definition, "bc")
    return np.array([[0, 0, 1], [1, 2, 0]]), np.array([[0, 0, 0], [3, 0, 0]])


@mistake(first_fails=checks.special_motion_refuses_other_definitions, compared=False)
def special_motion(reference, definition):
    """You return a motion for definition a, too; raise ValueError for it."""
    return reference("b" if definition == "a" else definition)
