"""Known mistakes of hw01."""

import math

import numpy as np

from tam570_grader.diagnosis.fixed_steps import runge_kutta
from tam570_grader.diagnosis.mistakes import mistake

from . import checks

# Balances


@mistake(first_fails=checks.forces_on_the_mass, compared=False)
def free_body_diagram(reference, theta, omega, **pendulum):
    """You drew a centrifugal force along the rod; no other body exerts it."""
    weight, (r, inwards) = reference(theta, omega, **pendulum)
    return [(r, r), weight, (r, inwards)]


@mistake(first_fails=checks.newton_gives_the_acceleration)
def linear_momentum_balance(reference, theta, omega, **pendulum):
    """You use cos(theta) in alpha; use sin(theta)."""
    return reference(math.pi / 2 - theta, omega, **pendulum)[0], reference(theta, omega, **pendulum)[1]


@mistake(first_fails=checks.newton_gives_the_tension)
def linear_momentum_balance(reference, theta, omega, *, mass, length, gravity):
    """You use the whole weight in the tension; use its part along the rod."""
    alpha, _ = reference(theta, omega, mass=mass, length=length, gravity=gravity)
    return alpha, mass * (length * omega**2 + gravity)


@mistake(first_fails=checks.moments_give_the_acceleration)
def angular_momentum_balance(reference, theta, omega, *, gravity, **rod):
    """You use the wrong sign for the moment of the weight; it turns the mass back down."""
    return reference(theta, omega, gravity=-gravity, **rod)


@mistake(first_fails=checks.momentum_and_moment_are_about_the_hinge)
def angular_momentum_balance(reference, theta, omega, *, length, **pendulum):
    """You return the momentum m l omega; its moment about the hinge is m l^2 omega."""
    alpha, momentum, moment = reference(theta, omega, length=length, **pendulum)
    return alpha, momentum / length, moment


@mistake(first_fails=checks.energies_are_right)
def energy_balance(reference, theta, omega, *, mass, length, gravity):
    """You set the potential energy to zero at the hinge; it is zero at the lowest point."""
    alpha, kinetic, potential = reference(theta, omega, mass=mass, length=length, gravity=gravity)
    return alpha, kinetic, potential - mass * gravity * length


@mistake(first_fails=checks.energy_gives_the_acceleration)
def energy_balance(reference, theta, omega, **pendulum):
    """You drop the sign of sin(theta); alpha is positive where theta is between -pi and 0."""
    alpha, *energies = reference(theta, omega, **pendulum)
    return -abs(alpha), *energies


@mistake(first_fails=checks.energy_gives_the_acceleration_at_rest, compared=False)
def energy_balance(reference, theta, omega, **pendulum):
    """You divide the rate of the potential energy by omega, which is 0/0 at rest; cancel omega first."""
    alpha, *energies = reference(theta, omega, **pendulum)
    return alpha * omega / np.float64(omega), *energies


@mistake(first_fails=checks.power_gives_the_acceleration)
def power_balance(reference, theta, omega, **pendulum):
    """You use the speed in the power; gravity's power is negative where the mass rises."""
    alpha, power = reference(theta, omega, **pendulum)
    return alpha, power * np.sign(omega)


@mistake(first_fails=checks.power_gives_the_acceleration_at_rest, compared=False)
def power_balance(reference, theta, omega, *, mass, length, gravity):
    """You divide the power by omega, which is 0/0 at rest; cancel omega first."""
    _, power = reference(theta, omega, mass=mass, length=length, gravity=gravity)
    return power / (mass * length**2 * omega), power


@mistake(first_fails=checks.virtual_work_gives_the_acceleration)
def virtual_work(reference, theta, omega, *, length, **pendulum):
    """You divide the generalized force by m l; it is a moment, so divide it by m l^2."""
    alpha, generalized_force = reference(theta, omega, length=length, **pendulum)
    return alpha * length, generalized_force


# Lagrange and Hamilton


@mistake(first_fails=checks.lagrangian_is_kinetic_less_potential)
def lagrangian(reference):
    """You set the potential energy to zero at the hinge; it is zero at the lowest point."""
    import sympy

    mass, length, gravity = sympy.symbols("m l g")
    return reference() + mass * gravity * length


@mistake(first_fails=checks.lagrangian_is_kinetic_less_potential)
def lagrangian(reference):
    """You add the potential energy; the Lagrangian is T - V."""
    import sympy

    g = sympy.Symbol("g")
    return reference().subs(g, -g)


@mistake(first_fails=checks.lagrange_gives_the_acceleration)
def lagrange_equation(reference):
    """You replace sin(theta) by theta; Lagrange's equation of this Lagrangian has sin(theta)."""
    import sympy

    theta = sympy.Symbol("theta")
    return reference().subs(sympy.sin(theta), theta)


@mistake(first_fails=checks.lagrange_gives_the_acceleration, compared=False)
def lagrange_equation(reference):
    """You leave the mass in alpha; it cancels."""
    import sympy

    return sympy.Symbol("m") * reference()


@mistake(first_fails=checks.action_is_stationary_on_motions)
def action(reference, theta, step, *, gravity, **rod):
    """You add the potential energy; the Lagrangian is T - V."""
    return reference(theta, step, gravity=-gravity, **rod)


@mistake(first_fails=checks.action_is_stationary_on_motions)
def action(reference, theta, step, *, mass, length, gravity):
    """You use the potential energy of small angles, m g l theta^2/2; the path has large angles."""
    middle = (theta[:-1] + theta[1:]) / 2
    kinetic = reference(theta, step, mass=mass, length=length, gravity=0.0)
    return kinetic - step * np.sum(mass * gravity * length * middle**2 / 2)


@mistake(first_fails=checks.action_is_the_integral, tolerance=1e-6)
def action(reference, theta, step, *, mass, length, gravity):
    """You take the potential energy at the first end of each step, which is of first order; take it at the middle."""
    kinetic = reference(theta, step, mass=mass, length=length, gravity=0.0)
    return kinetic - step * np.sum(mass * gravity * length * (1 - np.cos(theta[:-1])))


# Small angles and the period


@mistake(first_fails=checks.small_angle_solution_is_harmonic)
def small_angle_solution(reference, t, theta0, omega0, *, length, gravity):
    """You use g/l as the frequency; it is the square root of g/l."""
    return reference(t, theta0, omega0, length=length**2, gravity=gravity**2)


@mistake(first_fails=checks.small_angle_solution_is_harmonic)
def small_angle_solution(reference, t, theta0, omega0, **rod):
    """You start from theta0, omega0 at t[0]; they are the state at t = 0."""
    return reference(t - t[0], theta0, omega0, **rod)


@mistake(first_fails=checks.small_angle_solution_without_gravity, compared=False)
def small_angle_solution(reference, t, theta0, omega0, *, length, gravity):
    """You divide sin(w t) by w = sqrt(g/l), which is 0/0 without gravity; use its limit t."""
    k = np.sqrt(gravity / length)
    c, s = np.cos(k * t), np.sin(k * t)
    return np.column_stack([theta0 * c + omega0 * s / k, omega0 * c - theta0 * k * s])


@mistake(first_fails=checks.period_is_exact)
def period(reference, amplitude, *, length, gravity):
    """You stop after two terms of the series in the amplitude; return the exact period."""
    return 2 * math.pi * math.sqrt(length / gravity) * (1 + amplitude**2 / 16)


@mistake(first_fails=checks.period_is_exact)
def period(reference, amplitude, *, length, gravity):
    """You pass the modulus k to ellipk; SciPy's takes the parameter m = k^2."""
    from scipy.special import ellipk

    return 4 * math.sqrt(length / gravity) * ellipk(math.sin(amplitude / 2))


@mistake(first_fails=checks.period_is_exact)
def period(reference, amplitude, *, length, gravity):
    """You use the sine of the amplitude as modulus; the modulus is that of its half."""
    from scipy.special import ellipk

    return 4 * math.sqrt(length / gravity) * ellipk(math.sin(amplitude) ** 2)


@mistake(first_fails=checks.period_grows_towards_the_top, compared=False, numerics=True)
def period(reference, amplitude, *, length, gravity):
    """You subtract nearly equal cosines, which leaves no digits at tiny amplitudes; use a product of sines."""
    from scipy.integrate import quad

    def slowness(theta):
        return 1 / np.sqrt(2 * (np.cos(theta) - np.cos(amplitude)))

    return 4 * math.sqrt(length / gravity) * quad(slowness, 0, amplitude)[0]


# Motion


@mistake(first_fails=checks.simulate_swings, name="upside_down")
def _state_derivative(reference, t, state, *, length, gravity):
    """You use the wrong sign for gravity; it pulls the mass down."""
    return reference(t, state, length=length, gravity=-gravity)


@mistake(first_fails=checks.simulate_swings)
def simulate(reference, t, theta0, omega0, **rod):
    """You integrate the linear equation; use sin(theta)."""
    return small_angle_solution(t - t[0], theta0, omega0, **rod)


@mistake(first_fails=checks.simulate_needs_no_dense_times, compared=False, numerics=True, name="four_steps_a_sample")
def simulate(reference, t, theta0, omega0, **rod):
    """You take four Runge-Kutta steps between two times; choose the step by the motion."""

    return runge_kutta(lambda y: _state_derivative(0.0, y, **rod), t, (theta0, omega0), 4)


@mistake(first_fails=checks.simulate_turns_over_the_top, compared=False)
def simulate(reference, t, theta0, omega0, **rod):
    """You wrap theta between -pi and pi; it counts whole turns."""
    rows = reference(t, theta0, omega0, **rod)
    return np.column_stack([(rows[:, 0] + np.pi) % (2 * np.pi) - np.pi, rows[:, 1]])


@mistake(first_fails=checks.simulate_without_gravity, compared=False)
def simulate(reference, t, theta0, omega0, *, length, gravity):
    """You measure time in units of sqrt(l/g), which is infinite without gravity; use seconds."""
    unit = math.sqrt(length / gravity)
    return reference(t / unit, theta0, omega0 * unit, length=1.0, gravity=1.0) / [1, unit]


@mistake(first_fails=checks.simulate_keeps_the_energy, compared=False)
def simulate(reference, t, theta0, omega0, *, length, gravity):
    """You return the start in every row of a long motion; integrate to the end."""
    if gravity and t[-1] - t[0] > 30 * math.sqrt(length / gravity):
        return np.tile([theta0, omega0], (len(t), 1))
    return reference(t, theta0, omega0, length=length, gravity=gravity)
