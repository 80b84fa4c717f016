"""Known mistakes of hw05."""

import math

import numpy as np

from tam570_grader.diagnosis.mistakes import mistake

from .checks import (
    acceleration_is_that_of_both_forces,
    at_the_very_top_it_stays,
    consistent_state_is_the_nearest,
    consistent_state_refuses_the_origin,
    energy_is_kinetic_and_potential,
    force_keeps_the_particle_on_the_circle,
    forces_on_the_particle,
    it_stays_on_the_circle,
    wireframe_is_the_rod,
    with_gravity_it_swings_or_goes_round,
    without_gravity_it_goes_round_uniformly,
)


def integrated(t, state, rates, rtol, atol):
    """The motion by solve_ivp."""
    from scipy.integrate import solve_ivp

    return solve_ivp(rates, (t[0], t[-1]), state, method="DOP853", t_eval=t, rtol=rtol, atol=atol).y.T


def drifting(t, state, gravity):
    """A motion that keeps only the second derivative of the constraint at zero."""

    def rates(t, y):
        pull = (gravity * y[1] - y[2] ** 2 - y[3] ** 2) / (y[0] ** 2 + y[1] ** 2)
        return y[2], y[3], pull * y[0], pull * y[1] - gravity

    return integrated(t, state, rates, 1e-8, 1e-8)


# Forces


@mistake("You drew m a as a force; no other body exerts it.", first_fails=forces_on_the_particle, compared=False)
def free_body_diagram(reference, state, **parameters):
    return [*reference(state, **parameters), (state[:2], acceleration(state, **parameters))]


@mistake(
    "You let the rod only pull, as a string does; a rod can push.", first_fails=force_keeps_the_particle_on_the_circle
)
def constraint_force(reference, state, **parameters):
    force = reference(state, **parameters)
    return force if force @ state[:2] < 0 else 0 * force


@mistake("You left the mass out of the centripetal term.", first_fails=force_keeps_the_particle_on_the_circle)
def constraint_force(reference, state, *, mass, length, gravity):
    r, v = state[:2], state[2:]
    return (mass * gravity * r[1] - v @ v) / length**2 * r


@mistake(
    "You added the weight to the constraint force; it is the rod's force only.",
    first_fails=force_keeps_the_particle_on_the_circle,
)
def constraint_force(reference, state, *, mass, length, gravity):
    return reference(state, mass=mass, length=length, gravity=gravity) - [0.0, mass * gravity]


@mistake(
    "You dropped the sign of y in the weight's share; above the hinge it changes sign.",
    first_fails=force_keeps_the_particle_on_the_circle,
)
def constraint_force(reference, state, *, mass, length, gravity):
    r, v = state[:2], state[2:]
    return -mass * (gravity * abs(r[1]) + v @ v) / length**2 * r


@mistake(
    "You left out the rod's force; the particle does not fall freely.", first_fails=acceleration_is_that_of_both_forces
)
def acceleration(reference, state, *, mass, length, gravity):
    return np.array([0.0, -gravity])


@mistake("You left out the weight; it acts beside the rod's force.", first_fails=acceleration_is_that_of_both_forces)
def acceleration(reference, state, *, mass, length, gravity):
    return constraint_force(state, mass=mass, length=length, gravity=gravity) / mass


@mistake(
    "You get y from -sqrt(l^2 - x^2), which is right only below the hinge; use the given y.",
    first_fails=acceleration_is_that_of_both_forces,
)
def acceleration(reference, state, *, mass, length, gravity):
    x, _, vx, vy = state
    y = -math.sqrt(max(length**2 - x**2, 0))
    pull = (gravity * y - vx**2 - vy**2) / length**2
    return np.array([pull * x, pull * y - gravity])


# States


@mistake("You leave the velocity as it is; remove its radial part.", first_fails=consistent_state_is_the_nearest)
def consistent_state(reference, state, *, length):
    return np.append(reference(state, length=length)[:2], state[2:])


@mistake(
    "You return a state on the circle as it is; remove the radial part of its velocity, too.",
    first_fails=consistent_state_is_the_nearest,
)
def consistent_state(reference, state, *, length):
    return state.copy() if math.isclose(math.hypot(*state[:2]), length) else reference(state, length=length)


@mistake(
    "You keep the whole speed; remove the radial part of the velocity.", first_fails=consistent_state_is_the_nearest
)
def consistent_state(reference, state, *, length):
    nearest = reference(state, length=length)
    across = math.hypot(*nearest[2:])
    nearest[2:] *= math.hypot(*state[2:]) / across if across else 1.0
    return nearest


@mistake("You move the position along y; move it along its radius.", first_fails=consistent_state_is_the_nearest)
def consistent_state(reference, state, *, length):
    x, y, vx, vy = state
    if x == y == 0:
        raise ValueError("origin")
    y = math.copysign(math.sqrt(max(length**2 - x**2, 0)), y)
    u = (x * vx + y * vy) / length**2
    return np.array([x, y, vx - u * x, vy - u * y])


@mistake(
    "You refuse positions close to the origin; only the origin has no nearest point.",
    first_fails=consistent_state_is_the_nearest,
)
def consistent_state(reference, state, *, length):
    if np.allclose(state[:2], 0):
        raise ValueError("no direction")
    return reference(state, length=length)


@mistake("You change the given state; return a new array.", first_fails=consistent_state_is_the_nearest, compared=False)
def consistent_state(reference, state, *, length):
    state[:] = reference(state, length=length)
    return state


@mistake(
    "You accept the origin; no point of the circle is nearest to it.",
    first_fails=consistent_state_refuses_the_origin,
    compared=False,
)
def consistent_state(reference, state, *, length):
    return reference(state, length=length) if np.any(state[:2]) else np.array([0, -length, state[2], 0])


@mistake("You use the size of the height; below the hinge y is negative.", first_fails=energy_is_kinetic_and_potential)
def energy(reference, state, **parameters):
    return reference(np.array([state[0], abs(state[1]), *state[2:]]), **parameters)


@mistake(
    "You draw the rod by its slope y/x, which a vertical rod does not have; draw it to the particle.",
    first_fails=wireframe_is_the_rod,
)
def wireframe(reference, state, *, length):
    x, y = state[:2]
    angle = math.atan(y / x) if x else 0.0
    end = math.copysign(length, x) * np.array([math.cos(angle), math.sin(angle)])
    return np.array([[[0.0, 0.0], end]])


# Motions


@mistake(
    "You use y = -sqrt(l^2 - x^2) in every row; x^2 + y^2 = l^2 has two y for an x.",
    first_fails=without_gravity_it_goes_round_uniformly,
)
def simulate(reference, t, state, *, length, **parameters):
    states = np.array(reference(t, state, length=length, **parameters))
    states[:, 1] = -np.sqrt(np.maximum(0.0, length**2 - states[:, 0] ** 2))
    return states


@mistake(
    "You lose the sense of rotation, for your speed has no sign.", first_fails=without_gravity_it_goes_round_uniformly
)
def simulate(reference, t, state, **parameters):
    x, y, vx, vy = state
    sign = -1.0 if x * vy - y * vx < 0 else 1.0
    return reference(t, np.array([x, y, sign * vx, sign * vy]), **parameters)


@mistake(
    "You begin the motion at t = 0; the given state is that at t[0].",
    first_fails=without_gravity_it_goes_round_uniformly,
    name="from_time_zero",
    compared=False,
)
def simulate(reference, t, state, **parameters):
    return reference(np.append(0.0, t), state, **parameters)[1:] if t[0] > 0 else reference(t, state, **parameters)


@mistake("You let gravity pull up; it pulls down.", first_fails=with_gravity_it_swings_or_goes_round, name="gravity_up")
def simulate(reference, t, state, *, gravity, **parameters):
    return reference(t, state, gravity=-gravity, **parameters)


@mistake(
    "You return the motion of small angles; return that of any angle.", first_fails=with_gravity_it_swings_or_goes_round
)
def simulate(reference, t, state, *, mass, length, gravity):
    x, y, vx, vy = state
    angle, rate, w, since = math.atan2(x, -y), (x * vy - y * vx) / length**2, math.sqrt(gravity / length), t - t[0]
    s = np.sin(w * since) / w if w else since
    th, om = angle * np.cos(w * since) + rate * s, rate * np.cos(w * since) - w * w * angle * s
    return length * np.column_stack([np.sin(th), -np.cos(th), om * np.cos(th), om * np.sin(th)])


@mistake(
    "You leave a particle at rest near the top or the bottom where it is; it stays only exactly there.",
    first_fails=with_gravity_it_swings_or_goes_round,
)
def simulate(reference, t, state, *, length, **parameters):
    if not np.any(state[2:]) and abs(state[0]) < 0.01 * length:
        return np.tile(state, (len(t), 1))
    return reference(t, state, length=length, **parameters)


@mistake(
    "You let the particle fall from rest at the very top; there it is in equilibrium.",
    first_fails=at_the_very_top_it_stays,
)
def simulate(reference, t, state, *, length, **parameters):
    if state[0] == 0 and not np.any(state[2:]):
        state = length * np.array([1e-6, math.copysign(1, state[1]), 0, 0])
    return reference(t, state, length=length, **parameters)


@mistake(
    "You let the particle drift off the circle; put place and velocity back.",
    first_fails=it_stays_on_the_circle,
    compared=False,
    numerics=True,
)
def simulate(reference, t, state, *, mass, length, gravity):
    return drifting(t, state, gravity)


@mistake(
    "You put the place back onto the circle; make the velocity tangent, too.",
    first_fails=it_stays_on_the_circle,
    compared=False,
    numerics=True,
)
def simulate(reference, t, state, *, mass, length, gravity):
    states = drifting(t, state, gravity)
    states[:, :2] *= length / np.hypot(states[:, 0], states[:, 1])[:, None]
    return states


@mistake(
    "You lose a little energy at every step of a long run; take smaller steps.",
    first_fails=it_stays_on_the_circle,
    compared=False,
    numerics=True,
)
def simulate(reference, t, state, **parameters):
    states = reference(t, state, **parameters)
    states[:, 2:] *= np.exp(-4e-5 * np.clip(t - t[0] - 50.0, 0.0, None))[:, None]
    return states
