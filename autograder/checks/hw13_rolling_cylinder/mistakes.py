"""Known mistakes of hw13."""

import math

import numpy as np

from tam570_grader.diagnosis.fixed_steps import runge_kutta
from tam570_grader.diagnosis.mistakes import mistake

from . import checks


def in_steps(t, start, steps, cylinder):
    return runge_kutta(lambda y: (y[1], acceleration(*y, **cylinder)), t, start, steps)


def rocks(t, phi, rate):
    """The linear motion from rest at phi."""
    return np.column_stack([phi * np.cos(rate * (t - t[0])), -phi * rate * np.sin(rate * (t - t[0]))])


# The diagram


@mistake(first_fails=checks.forces_on_the_cylinder, compared=False)
def free_body_diagram(reference, phi, **cylinder):
    """You drew the normal force along the vertical; it is normal to the ramp."""
    (G, (x, y)), (contact, _), friction = reference(phi, **cylinder)
    return [(G, (x, y)), (contact, (-x, -y)), friction]


@mistake(first_fails=checks.forces_on_the_cylinder, compared=False)
def free_body_diagram(reference, phi, **cylinder):
    """You drew the weight at the centre; it acts at G."""
    (_, down), *contact = reference(phi, **cylinder)
    return [((0.0, 0.0), down), *contact]


# The acceleration


@mistake(first_fails=checks.centred_cylinder_rolls_by_both_methods, compared=False)
def naive_contact_acceleration(reference, phi, *, offset, **rest):
    """You divide by the offset; for a centred cylinder that is 0."""
    return offset * (reference(phi, offset=offset, **rest) / offset)


@mistake(first_fails=checks.acceleration_balances_momentum_about_G)
def acceleration(reference, phi, phi_dot, **cylinder):
    """You used M_C = I^C phi''; it leaves out the acceleration of the cylinder's point at C."""
    return naive_contact_acceleration(phi, **cylinder)


@mistake(first_fails=checks.acceleration_balances_momentum_about_G)
def acceleration(reference, phi, phi_dot, **cylinder):
    """You use half of the missing moment; it is m r e sin(phi) phi_dot^2."""
    return reference(phi, phi_dot / math.sqrt(2), **cylinder)


@mistake(first_fails=checks.acceleration_balances_momentum_about_G)
def acceleration(reference, phi, phi_dot, *, mass, radius, offset, inertia, slope, gravity):
    """You give the friction the lever r about G; its lever is r - e cos(phi)."""
    s, c = math.sin(phi), math.cos(phi)
    total = inertia + mass * (offset * s) ** 2 + mass * radius * (radius - offset * c)
    moment = -mass * offset * s * (offset * c * phi_dot**2 + gravity * math.cos(slope))
    return (moment - mass * radius * (offset * s * phi_dot**2 - gravity * math.sin(slope))) / total


@mistake(first_fails=checks.acceleration_balances_momentum_about_G)
def acceleration(reference, phi, phi_dot, **c):
    """You balance moments about the centre O, which accelerates; add r_{G/O} x m a_O, or balance them about G."""
    about_contact = contact_inertia(phi, **{name: c[name] for name in ("mass", "radius", "offset", "inertia")})
    forgotten = c["mass"] * c["radius"] * c["offset"] * math.cos(phi)
    return reference(phi, phi_dot, **c) * about_contact / (about_contact + forgotten)


@mistake(first_fails=checks.acceleration_level_and_without_gravity)
def acceleration(reference, phi, phi_dot, **cylinder):
    """You return 0 without gravity; phi_dot still changes unless G is at the centre."""
    return reference(phi, phi_dot, **cylinder) if cylinder["gravity"] else 0.0


@mistake(first_fails=checks.acceleration_level_and_without_gravity, compared=False)
def acceleration(reference, phi, phi_dot, **cylinder):
    """You divide by sin(slope); on level ground that is 0."""
    return math.sin(cylinder["slope"]) * (reference(phi, phi_dot, **cylinder) / math.sin(cylinder["slope"]))


# The equation about C


@mistake(first_fails=checks.acceleration_balances_momentum_about_G)
def _distance_squared(reference, phi, radius, offset):
    """You use r^2 + e^2 as the distance from C to G squared; it depends on phi."""
    return radius**2 + offset**2


@mistake(first_fails=checks.acceleration_balances_momentum_about_G)
def _distance_squared(reference, phi, radius, offset):
    """You use the height of G above the ramp; use its distance from C."""
    return (radius - offset * math.cos(phi)) ** 2


@mistake(first_fails=checks.missing_moment_makes_it_right)
def missing_moment(reference, phi, phi_dot, *, mass, radius, offset):
    """You use the dot product of r_{G/C} and m a_C; use their cross product."""
    return mass * (radius - offset * math.cos(phi)) * radius * phi_dot**2


@mistake(first_fails=checks.missing_moment_makes_it_right)
def missing_moment(reference, phi, phi_dot, **body):
    """You use phi_dot |phi_dot|; phi_dot^2 has no sign."""
    return math.copysign(1.0, phi_dot) * reference(phi, phi_dot, **body)


# Forces and the energy


@mistake(first_fails=checks.contact_force_accelerates_G)
def contact_force(reference, phi, phi_dot, **c):
    """You balance only the weight along the ramp; G accelerates."""
    return -c["mass"] * c["gravity"] * math.sin(c["slope"]), reference(phi, phi_dot, **c)[1]


@mistake(first_fails=checks.contact_force_accelerates_G)
def contact_force(reference, phi, phi_dot, **c):
    """You use r phi'', the acceleration of the centre along the ramp; use that of G."""
    x_ddot = c["radius"] * acceleration(phi, phi_dot, **c)
    return c["mass"] * (x_ddot - c["gravity"] * math.sin(c["slope"])), reference(phi, phi_dot, **c)[1]


@mistake(first_fails=checks.contact_force_accelerates_G)
def contact_force(reference, phi, phi_dot, **c):
    """You forget alpha x r in the acceleration of G; G turns about the centre."""
    along, normal = reference(phi, phi_dot, **c)
    turning = c["mass"] * c["offset"] * acceleration(phi, phi_dot, **c)
    return along + turning * math.cos(phi), normal - turning * math.sin(phi)


@mistake(first_fails=checks.contact_force_accelerates_G)
def contact_force(reference, phi, phi_dot, **c):
    """You forget the terms in phi_dot^2 of the acceleration of G."""
    along, normal = reference(phi, phi_dot, **c)
    turning = c["mass"] * c["offset"] * phi_dot**2
    return along - turning * math.sin(phi), normal - turning * math.cos(phi)


@mistake(first_fails=checks.contact_force_may_pull)
def contact_force(reference, phi, phi_dot, **cylinder):
    """You cut a negative normal force to 0; assume that the cylinder never lifts off."""
    along, normal = reference(phi, phi_dot, **cylinder)
    return along, max(normal, 0.0)


@mistake(first_fails=checks.energy_of_G_and_of_turning)
def energy(reference, phi, phi_dot, **c):
    """You use the speed of the centre; use that of G."""
    return reference(phi, 0.0, **c) + (c["inertia"] + c["mass"] * c["radius"] ** 2) * phi_dot**2 / 2


@mistake(first_fails=checks.energy_of_G_and_of_turning)
def energy(reference, phi, phi_dot, **c):
    """You use e cos(phi) cos(slope) in the height of G; it is e cos(phi + slope)."""
    more = math.cos(phi + c["slope"]) - math.cos(phi) * math.cos(c["slope"])
    return reference(phi, phi_dot, **c) + c["mass"] * c["gravity"] * c["offset"] * more


@mistake(first_fails=checks.energy_of_G_and_of_turning)
def energy(reference, phi, phi_dot, **c):
    """You set the potential to zero with G where it is at phi = 0; it is zero with G where the centre is at phi = 0."""
    return reference(phi, phi_dot, **c) - reference(0.0, 0.0, **c)


@mistake(first_fails=checks.energy_of_G_and_of_turning)
def energy(reference, phi, phi_dot, **c):
    """You measure the height of G from the contact at phi = 0; measure it from the centre there."""
    return reference(phi, phi_dot, **c) + c["mass"] * c["gravity"] * c["radius"] * math.cos(c["slope"])


@mistake(first_fails=checks.acceleration_balances_momentum_about_G)
def _distance_squared(reference, phi, radius, offset):  # after the energy, which has the same numbers
    """You use I^G + m r^2; I^C is that only with G at the centre."""
    return radius**2


# The motion


@mistake(first_fails=checks.simulate_rolls_and_rocks, name="even_times")
def simulate(reference, t, phi, phi_dot, **cylinder):
    """You return the states at evenly spaced times; row i is the state at t[i]."""
    return reference(np.linspace(t[0], t[-1], len(t)), phi, phi_dot, **cylinder)


@mistake(first_fails=checks.simulate_rolls_and_rocks)
def simulate(reference, t, phi, phi_dot, **cylinder):
    """You stop where the normal force is zero; contact is kept."""
    states = reference(t, phi, phi_dot, **cylinder)
    lifted = [i for i, state in enumerate(states) if contact_force(*state, **cylinder)[1] < 0]
    if lifted:
        states[lifted[0] :] = states[max(lifted[0] - 1, 0)]
    return states


@mistake(first_fails=checks.simulate_needs_no_dense_times, compared=False, numerics=True)
def simulate(reference, t, phi, phi_dot, **cylinder):
    """You take a hundred Runge-Kutta steps to each time, however far; limit the size of a step."""
    return in_steps(t, (phi, phi_dot), 100, cylinder)


@mistake(first_fails=checks.simulate_needs_no_dense_times, compared=False)
def simulate(reference, t, phi, phi_dot, **c):
    """You use the linear equation near the lowest place; the other terms are small there, not 0."""
    if c["slope"] or phi_dot or abs(phi) >= 0.5 or not c["gravity"]:
        return reference(t, phi, phi_dot, **c)
    body = {name: c[name] for name in ("mass", "radius", "offset", "inertia")}
    stiffness = c["mass"] * c["gravity"] * c["offset"]
    return rocks(t, phi, math.sqrt(stiffness / contact_inertia(0.0, **body)))


@mistake(first_fails=checks.simulate_rocks_at_the_linear_frequency)
def simulate(reference, t, phi, phi_dot, **c):
    """You use I^G in the frequency of small rocking; use I^C at phi = 0."""
    if c["slope"] or phi_dot or abs(phi) >= 0.01 or not c["gravity"]:
        return reference(t, phi, phi_dot, **c)
    return rocks(t, phi, math.sqrt(c["mass"] * c["gravity"] * c["offset"] / c["inertia"]))


@mistake(first_fails=checks.simulate_keeps_the_energy, compared=False, numerics=True)
def simulate(reference, t, phi, phi_dot, **cylinder):
    """You take longer steps in a long motion; its error grows."""
    rate = math.sqrt((cylinder["gravity"] or 5.0) / cylinder["radius"])
    step = (0.005 if (t[-1] - t[0]) * rate < 15 else 0.1) / rate
    return in_steps(t, (phi, phi_dot), [math.ceil(span / step) for span in np.diff(t)], cylinder)
