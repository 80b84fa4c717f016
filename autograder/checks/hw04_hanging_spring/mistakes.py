"""Known mistakes of hw04."""

import numpy as np

from tam570_grader.diagnosis.fixed_steps import runge_kutta
from tam570_grader.diagnosis.mistakes import mistake

from . import checks


def radii(position, velocity, *, mass, stiffness, gravity):
    """The centre, and the conjugate radii: position and velocity from there."""
    centre = np.array([0.0, 0.0, -mass * gravity / stiffness])
    return centre, position - centre, velocity * np.sqrt(mass / stiffness)


# Forces and energies


@mistake(first_fails=checks.forces_on_the_mass, compared=False)
def free_body_diagram(reference, state, **parameters):
    """You let the spring push; it pulls towards the origin."""
    weight, (r, pull) = reference(state, **parameters)
    return [weight, (r, -np.array(pull))]


@mistake(first_fails=checks.derivative_is_velocity_and_force_over_mass)
def state_derivative(reference, t, state, *, gravity, **parameters):
    """You let gravity pull along -y; it pulls along -z."""
    return np.subtract(reference(t, state, gravity=0.0, **parameters), [0, 0, 0, 0, gravity, 0])


@mistake(first_fails=checks.derivative_is_velocity_and_force_over_mass)
def state_derivative(reference, t, state, *, stiffness, **parameters):
    """You let the spring push; it pulls."""
    return reference(t, state, stiffness=-stiffness, **parameters)


@mistake(first_fails=checks.derivative_is_velocity_and_force_over_mass)
def state_derivative(reference, t, state, *, mass, stiffness, gravity):
    """You gave the spring a rest length of 1 m; its rest length is 0."""
    x, y, z, vx, vy, vz = state
    stretch = stiffness / mass * (1 - 1 / np.sqrt(x * x + y * y + z * z))
    return vx, vy, vz, -stretch * x, -stretch * y, -stretch * z - gravity


@mistake(first_fails=checks.derivative_is_velocity_and_force_over_mass, label="a very small motion")
def state_derivative(reference, t, state, **parameters):
    """You treat a state near zero as zero, as np.allclose does; a very small motion is still a motion."""
    return reference(t, np.zeros(6) if np.linalg.norm(state) < 1e-8 else state, **parameters)


@mistake(first_fails=checks.energy_is_that_of_motion_spring_and_weight)
def energy(reference, state, *, mass, stiffness, gravity):
    """You set the energy to zero at the equilibrium; it is zero at the origin."""
    sag = mass * gravity / stiffness
    return reference(state, mass=mass, stiffness=stiffness, gravity=gravity) + stiffness * sag**2 / 2


@mistake(first_fails=checks.energy_is_that_of_motion_spring_and_weight)
def energy(reference, state, *, mass, stiffness, gravity):
    """You measure the stretch from the equilibrium, and add the weight's energy; measure it from the origin."""
    sag = mass * gravity / stiffness
    return reference(state, mass=mass, stiffness=stiffness, gravity=2 * gravity) + stiffness * sag**2 / 2


# The closed form


def oscillates(t, position, velocity, k, centre, shift=0.0):
    """Position and velocity about a centre."""
    centre = np.array(centre)
    c, s, r = np.cos(k * t)[:, None], np.sin(k * t)[:, None], position - centre
    return np.hstack([centre + shift + r * c + velocity / k * s, velocity * c - k * r * s])


@mistake(first_fails=checks.solution_is_the_motion)
def solution(reference, t, position, velocity, *, mass, stiffness, gravity):
    """You take the position from the origin as amplitude; the amplitude is measured from the equilibrium."""
    sag = np.array([0.0, 0.0, -mass * gravity / stiffness])
    return oscillates(t, position, velocity, np.sqrt(stiffness / mass), np.zeros(3), sag)


@mistake(first_fails=checks.solution_is_the_motion)
def solution(reference, t, position, velocity, *, mass, stiffness, gravity):
    """You use the rate sqrt(m/k); the rate is sqrt(k/m)."""
    return oscillates(t, position, velocity, np.sqrt(mass / stiffness), [0, 0, -mass * gravity / stiffness])


@mistake(first_fails=checks.solution_is_the_motion)
def solution(reference, t, position, velocity, *, mass, stiffness, gravity):
    """You use the rate k/m; the rate is the square root of k/m."""
    return oscillates(t, position, velocity, stiffness / mass, [0, 0, -mass * gravity / stiffness])


@mistake(first_fails=checks.solution_is_the_motion)
def solution(reference, t, position, velocity, *, mass, stiffness, gravity):
    """You wrote +sin in the velocity's term with the position; the rate of cos is -sin."""
    k, r = np.sqrt(stiffness / mass), position - np.array([0, 0, -mass * gravity / stiffness])
    rows = reference(t, position, velocity, mass=mass, stiffness=stiffness, gravity=gravity)
    return rows + np.hstack([0 * rows[:, :3], 2 * k * np.sin(k * t)[:, None] * r])


@mistake(first_fails=checks.solution_is_the_motion)
def solution(reference, t, position, velocity, *, mass, stiffness, gravity):
    """Your velocity lacks the factor sqrt(k/m) from the derivative; d/dt cos(w t) = -w sin(w t)."""
    rows = reference(t, position, velocity, mass=mass, stiffness=stiffness, gravity=gravity)
    return rows / np.repeat([1.0, np.sqrt(stiffness / mass)], 3)


@mistake(first_fails=checks.solution_holds_without_gravity_and_from_any_time)
def solution(reference, t, position, velocity, **parameters):
    """Your closed form ignores the sign of the time; a time before zero is earlier than the given state."""
    return reference(np.abs(t), position, velocity, **parameters)


@mistake(first_fails=checks.solution_holds_without_gravity_and_from_any_time)
def solution(reference, t, position, velocity, **parameters):
    """You return the given state for a single time; it is the state at t = 0, not at t[0]."""
    return reference(0 * t if len(t) == 1 else t, position, velocity, **parameters)


@mistake(first_fails=checks.solution_holds_without_gravity_and_from_any_time)
def solution(reference, t, position, velocity, **parameters):
    """You sort the times; row i belongs to t[i], in any order."""
    return reference(np.sort(t), position, velocity, **parameters)


# The simulation


@mistake(first_fails=checks.simulate_moves_as_it_must, name="from_time_zero", compared=False)
def simulate(reference, t, position, velocity, **parameters):
    """You use the given state at t = 0; it is the state at t[0]."""
    return solution(t, position, velocity, **parameters)


@mistake(first_fails=checks.simulate_does_not_depend_on_the_sampling, compared=False, numerics=True)
def simulate(reference, t, position, velocity, **parameters):
    """You take a fixed number of steps from each time to the next; how many are needed depends on the span."""
    return runge_kutta(lambda y: state_derivative(0, y, **parameters), t, [*position, *velocity], 40)


@mistake(first_fails=checks.energy_stays, compared=False, numerics=True)
def simulate(reference, t, position, velocity, *, mass, stiffness, gravity):
    """Your integrator loses a little energy at every step; over many periods it must stay."""
    centre = np.array([0, 0, -mass * gravity / stiffness, 0, 0, 0])
    rows = reference(t, position, velocity, mass=mass, stiffness=stiffness, gravity=gravity)
    return centre + (rows - centre) * np.exp(-5e-7 * (t - t[0]) * np.sqrt(stiffness / mass))[:, None]


# The ellipse


@mistake(first_fails=checks.orbit_has_its_centre_at_the_equilibrium, compared=False)
def orbit(reference, position, velocity, **parameters):
    """Your angle to the axes is the arctan of a ratio, which is 0/0 for a circle; use arctan2."""
    centre, p, q = radii(position, velocity, **parameters)
    if not np.any(velocity):
        return centre, np.array([p, 0 * p])
    with np.errstate(all="ignore"):
        turn = np.arctan(2 * (p @ q) / (p @ p - q @ q)) / 2
    axes = [p * np.cos(turn) + q * np.sin(turn), q * np.cos(turn) - p * np.sin(turn)]
    return centre, np.array(sorted(axes, key=lambda axis: -(axis @ axis)))


@mistake(first_fails=checks.orbit_is_the_ellipse_of_the_motion, compared=False)
def orbit(reference, position, velocity, **parameters):
    """You treat perpendicular radii, to a thousandth, as axes; only exactly perpendicular ones are."""
    centre, p, q = radii(position, velocity, **parameters)
    if abs(p @ q) < 1e-3 * np.sqrt(p @ p * (q @ q)):
        return centre, np.array(sorted([p, q], key=lambda r: -(r @ r)))
    return reference(position, velocity, **parameters)


@mistake(first_fails=checks.orbit_is_the_ellipse_of_the_motion, compared=False)
def orbit(reference, position, velocity, **parameters):
    """You set the smaller axis to zero below a fiftieth of the larger; a thin ellipse is no line."""
    centre, axes = reference(position, velocity, **parameters)
    lengths = np.linalg.norm(axes, axis=1)
    return centre, axes * [[1], [lengths[1] > lengths[0] / 50]]


@mistake(first_fails=checks.orbit_may_be_a_line_or_a_point, compared=False)
def orbit(reference, position, velocity, **parameters):
    """You cross the larger axis with the normal of the plane; a line has no normal."""
    centre, p, q = radii(position, velocity, **parameters)
    phase = np.arctan2(2 * p @ q, p @ p - q @ q) / 2
    first, normal = p * np.cos(phase) + q * np.sin(phase), np.cross(p, q)
    with np.errstate(all="ignore"):
        return centre, np.array([first, np.cross(normal, first) / (first @ first)])


# The picture


@mistake(first_fails=checks.projection_is_orthographic)
def project(reference, points, azimuth, elevation):
    """You convert the angles from degrees; they are in radians."""
    return reference(points, np.radians(azimuth), np.radians(elevation))


@mistake(first_fails=checks.projection_is_orthographic)
def project(reference, points, azimuth, elevation):
    """You cross the vertical with the direction of the eye; seen from straight above that is zero."""
    eye = np.array([np.cos(elevation) * np.cos(azimuth), np.cos(elevation) * np.sin(azimuth), np.sin(elevation)])
    reference = np.cross([0.0, 0.0, 1.0], eye)
    reference = reference / max(np.linalg.norm(reference), 1e-9)
    return points @ np.column_stack([reference, np.cross(eye, reference)])


@mistake(first_fails=checks.the_path_is_drawn, compared=False)
def plot_projection(reference, ax, t, position, velocity, azimuth, elevation, **parameters):
    """You draw x and y; draw what project returns, right and up."""
    ax.plot(*simulate(t, position, velocity, **parameters)[:, :2].T)
    ax.set(xlabel="right (m)", ylabel="up (m)", aspect="equal")
