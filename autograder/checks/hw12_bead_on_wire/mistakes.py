"""Known mistakes of hw12."""

import math

import numpy as np
import sympy

from tam570_grader.diagnosis.fixed_steps import runge_kutta
from tam570_grader.diagnosis.mistakes import mistake

from . import checks

KEPT = {}  # between calls
SYMBOLS = sympy.symbols("x v m c g")


def in_steps(t, x, v, steps, wire):
    return runge_kutta(lambda y: (y[1], acceleration_newton(*y, **wire)), t, (x, v), steps)


def in_longer_steps(t, x, v, wire, limit, longer):
    """By short steps up to a duration, and by longer ones beyond it, in units of 1/sqrt(2 g c)."""
    rate = np.sqrt(2 * wire["curvature"] * (wire["gravity"] or 10.0))
    step = (0.002 if (t[-1] - t[0]) * rate < limit else longer) / rate
    return in_steps(t, x, v, [math.ceil(span / step) for span in np.diff(t)], wire)


# Lagrange


@mistake(first_fails=checks.forces_on_the_bead, compared=False)
def free_body_diagram(reference, x, **wire):
    """You drew the force of the wire along the vertical; it is normal to the wire."""
    weight, (bead, _) = reference(x, **wire)
    return [weight, (bead, (0.0, 1.0))]


@mistake(first_fails=checks.lagrangian_is_kinetic_less_potential)
def lagrangian(reference):
    """You use v as the speed in the kinetic energy; the speed squared is (1 + 4 c^2 x^2) v^2."""
    x, v, m, c, g = SYMBOLS
    return m * v**2 / 2 - m * g * c * x**2


@mistake(first_fails=checks.lagrangian_is_kinetic_less_potential)
def lagrangian(reference):
    """You add the potential energy; the Lagrangian is T - V."""
    return reference().subs(SYMBOLS[-1], -SYMBOLS[-1])


@mistake(first_fails=checks.lagrange_gives_the_acceleration)
def lagrange_equation(reference):
    """Your term 4 c^2 x v^2 has the wrong sign; dL/dv contains 1 + 4 c^2 x^2, so its rate has a term with v^2 as
    well.
    """
    x, v, m, c, g = SYMBOLS
    return -2 * c * x * (g - 2 * c * v**2) / (1 + 4 * c**2 * x**2)


@mistake(first_fails=checks.lagrange_gives_the_acceleration)
def lagrange_equation(reference):
    """You forget dT/dx, which cancels half of your term with v^2."""
    x, v, m, c, g = SYMBOLS
    return -2 * c * x * (g + 4 * c * v**2) / (1 + 4 * c**2 * x**2)


@mistake(first_fails=checks.lagrange_gives_the_acceleration)
def lagrange_equation(reference):
    """You forget the term 4 c^2 x v^2."""
    return reference().subs(SYMBOLS[1], 0)


@mistake(first_fails=checks.lagrange_gives_the_acceleration, compared=False)
def lagrange_equation(reference):
    """You leave the mass in x''; it cancels."""
    return reference() * SYMBOLS[2]


@mistake(first_fails=checks.lagrange_gives_the_acceleration, compared=False)
def lagrange_equation(reference):
    """You return x as a function of time; return the symbol x."""
    return reference().subs(SYMBOLS[0], sympy.Function("x")(sympy.Symbol("t")))


# Newton


@mistake(first_fails=checks.newton_gives_the_acceleration)
def acceleration_newton(reference, x, v, *, curvature, gravity):
    """You return the rate of the speed along the wire; x'' is the rate of v = x'."""
    slope = 2 * curvature * x
    return -gravity * slope / np.hypot(1, slope)


@mistake(first_fails=checks.force_has_the_right_size)
def constraint_force(reference, x, v, *, mass, gravity, **wire):
    """You return m a, the sum of all forces; subtract the weight."""
    return reference(x, v, mass=mass, gravity=gravity, **wire) - [0.0, mass * gravity]


@mistake(first_fails=checks.force_has_the_right_size)
def constraint_force(reference, x, v, *, mass, gravity, **wire):
    """You subtract m g j from m a; the force is m a + m g j."""
    return reference(x, v, mass=mass, gravity=gravity, **wire) - [0.0, 2 * mass * gravity]


@mistake(first_fails=checks.force_has_the_right_size)
def constraint_force(reference, x, v, *, curvature, **bead):
    """You use v as the speed along the wire; v is the rate of x."""
    return reference(x, v / np.hypot(1, 2 * curvature * x), curvature=curvature, **bead)


@mistake(first_fails=checks.force_has_the_right_size)
def constraint_force(reference, x, v, *, mass, curvature, gravity):
    """You use the radius of curvature 1/(2 c) everywhere; it is right only at the bottom."""
    slope = 2 * curvature * x
    stretch = np.hypot(1, slope)
    size = mass * (gravity / stretch + 2 * curvature * (stretch * v) ** 2)
    return size * np.array([-slope, 1.0]) / stretch


@mistake(first_fails=checks.force_and_weight_make_the_acceleration)
def constraint_force(reference, x, v, **bead):
    """You point the force straight up; it is normal to the wire."""
    return np.array([0.0, np.hypot(*reference(x, v, **bead))])


@mistake(first_fails=checks.energy_is_kinetic_and_potential)
def energy(reference, x, v, *, curvature, **bead):
    """You use v as the speed in the kinetic energy; the speed squared is (1 + 4 c^2 x^2) v^2."""
    return reference(x, v / np.hypot(1, 2 * curvature * x), curvature=curvature, **bead)


# The motion


@mistake(first_fails=checks.simulate_slides)
def simulate(reference, t, x, v, *, curvature, gravity):
    """You forget the term 4 c^2 x v^2 in x''."""
    from scipy.integrate import solve_ivp

    def rates(_, state):
        return state[1], acceleration_newton(state[0], 0.0, curvature=curvature, gravity=gravity)

    return solve_ivp(rates, (t[0], t[-1]), (x, v), t_eval=t, rtol=1e-9, atol=1e-9).y.T


@mistake(first_fails=checks.simulate_slides)
def simulate(reference, t, x, v, *, curvature, gravity):
    """You return the oscillation x'' = -2 g c x of a small amplitude; the motion is large."""
    rate = np.sqrt(2 * gravity * curvature)
    cosine, sine = np.cos(rate * (t - t[0])), np.sin(rate * (t - t[0]))
    return np.column_stack([x * cosine + v * sine / rate, v * cosine - x * rate * sine])


@mistake(first_fails=checks.simulate_slides)
def simulate(reference, t, x, v, *, curvature, gravity):
    """You return the speed along the wire in column 1; return v = x'."""
    states = reference(t, x, v, curvature=curvature, gravity=gravity)
    states[:, 1] *= np.hypot(1, 2 * curvature * states[:, 0])
    return states


@mistake(first_fails=checks.simulate_slides, name="from_time_zero")
def simulate(reference, t, x, v, **wire):
    """You start at t = 0; x and v are those at t[0]."""
    if t[0] < 0:
        x, v = reference(np.array([0.0, -t[0]]), x, -v, **wire)[1] * [1, -1]
    elif t[0] > 0:
        x, v = reference(np.array([0.0, t[0]]), x, v, **wire)[1]
    return reference(t, x, v, **wire)


@mistake(first_fails=checks.simulate_needs_no_dense_times, compared=False, numerics=True)
def simulate(reference, t, x, v, **wire):
    """You take forty Runge-Kutta steps to each time, however far; limit the size of a step."""
    return in_steps(t, x, v, 40, wire)


@mistake(first_fails=checks.simulate_needs_no_dense_times, tolerance=1e-4)
def simulate(reference, t, x, v, *, curvature, gravity):
    """You return the oscillation x'' = -2 g c x near the bottom; no term is exactly 0 there."""
    if curvature * abs(x) > 0.1 or v or not gravity:
        return reference(t, x, v, curvature=curvature, gravity=gravity)
    rate = np.sqrt(2 * gravity * curvature)
    return np.column_stack([x * np.cos(rate * (t - t[0])), -x * rate * np.sin(rate * (t - t[0]))])


@mistake(first_fails=checks.simulate_without_gravity, name="motion_kept_for_other_wires")
def simulate(reference, t, x, v, **wire):
    """You reuse the motion of an earlier call with the same start and times; the wire and gravity matter, too."""
    if (key := (x, v, *t)) not in KEPT:
        KEPT[key] = reference(t, x, v, **wire)
    return KEPT[key]


@mistake(first_fails=checks.simulate_without_gravity, compared=False)
def simulate(reference, t, x, v, *, curvature, gravity):
    """You measure time in units of 1/sqrt(2 g c); without gravity that is infinite."""
    rate = np.sqrt(2 * gravity * curvature)
    return reference((t - t[0]) * rate, x, v / rate, curvature=curvature, gravity=gravity / rate**2) * [1, rate]


@mistake(first_fails=checks.simulate_slides_down_steep_wires, compared=False, numerics=True)
def simulate(reference, t, x, v, **wire):
    """You take longer steps in a long motion; the bead turns as sharply in it."""
    return in_longer_steps(t, x, v, wire, 30, 0.06)


@mistake(first_fails=checks.simulate_keeps_the_energy, compared=False, numerics=True)
def simulate(reference, t, x, v, **wire):
    """You take longer steps in a long motion; its error grows."""
    return in_longer_steps(t, x, v, wire, 47, 0.25)


# The period


@mistake(first_fails=checks.period_is_exact)
def period(reference, amplitude, *, curvature, gravity):
    """You pass the modulus k to ellipe; it takes the parameter k^2."""
    from scipy.special import ellipe

    slope = 2 * curvature * amplitude
    stretch = np.hypot(1, slope)
    return 4 * stretch * ellipe(slope / stretch) / np.sqrt(2 * gravity * curvature)


@mistake(first_fails=checks.period_is_exact)
def period(reference, amplitude, *, curvature, gravity):
    """You forget the factor sqrt(1 + (2 c A)^2) before the integral."""
    return reference(amplitude, curvature=curvature, gravity=gravity) / np.hypot(1, 2 * curvature * amplitude)


@mistake(first_fails=checks.period_of_small_and_of_huge_amplitudes)
def period(reference, amplitude, *, curvature, gravity):
    """You integrate with sixty points; a steep wire needs more."""
    angles = (np.arange(60) + 0.5) * np.pi / 60
    mean = np.mean(np.hypot(1, 2 * curvature * amplitude * np.sin(angles)))
    return 2 * np.pi * mean / np.sqrt(2 * gravity * curvature)
