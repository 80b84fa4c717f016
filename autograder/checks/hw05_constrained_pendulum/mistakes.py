"""Known mistakes of hw05."""

import math

import numpy as np

from tam570_grader.diagnosis.mistakes import mistake

from . import checks


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


@mistake(first_fails=checks.forces_on_the_particle, compared=False)
def free_body_diagram(reference, state, **parameters):
    """You drew m a as a force; no other body exerts it."""
    return [*reference(state, **parameters), (state[:2], acceleration(state, **parameters))]


@mistake(first_fails=checks.force_keeps_the_particle_on_the_circle)
def constraint_force(reference, state, **parameters):
    """You let the rod only pull, as a string does; a rod can push."""
    force = reference(state, **parameters)
    return force if force @ state[:2] < 0 else 0 * force


@mistake(first_fails=checks.force_keeps_the_particle_on_the_circle)
def constraint_force(reference, state, *, mass, length, gravity):
    """You added the weight to the constraint force; it is the rod's force only."""
    return reference(state, mass=mass, length=length, gravity=gravity) - [0.0, mass * gravity]


@mistake(first_fails=checks.force_keeps_the_particle_on_the_circle)
def constraint_force(reference, state, *, mass, length, gravity):
    """You dropped the sign of y in the weight's share; above the hinge it changes sign."""
    r, v = state[:2], state[2:]
    return -mass * (gravity * abs(r[1]) + v @ v) / length**2 * r


@mistake(first_fails=checks.acceleration_is_that_of_both_forces)
def acceleration(reference, state, *, mass, length, gravity):
    """You left out the rod's force; the particle does not fall freely."""
    return np.array([0.0, -gravity])


@mistake(first_fails=checks.acceleration_is_that_of_both_forces)
def acceleration(reference, state, *, mass, length, gravity):
    """You left out the weight; it acts beside the rod's force."""
    return constraint_force(state, mass=mass, length=length, gravity=gravity) / mass


@mistake(first_fails=checks.acceleration_is_that_of_both_forces)
def acceleration(reference, state, *, mass, length, gravity):
    """You get y from -sqrt(l^2 - x^2), which is right only below the hinge; use the given y."""
    x, _, vx, vy = state
    y = -math.sqrt(max(length**2 - x**2, 0))
    pull = (gravity * y - vx**2 - vy**2) / length**2
    return np.array([pull * x, pull * y - gravity])


# States


@mistake(first_fails=checks.consistent_state_is_the_nearest)
def consistent_state(reference, state, *, length):
    """You leave the velocity as it is; remove its radial part."""
    return np.append(reference(state, length=length)[:2], state[2:])


@mistake(first_fails=checks.consistent_state_is_the_nearest)
def consistent_state(reference, state, *, length):
    """You return a state on the circle as it is; remove the radial part of its velocity, too."""
    return state.copy() if math.isclose(math.hypot(*state[:2]), length) else reference(state, length=length)


@mistake(first_fails=checks.consistent_state_is_the_nearest)
def consistent_state(reference, state, *, length):
    """You keep the whole speed; remove the radial part of the velocity."""
    nearest = reference(state, length=length)
    across = math.hypot(*nearest[2:])
    nearest[2:] *= math.hypot(*state[2:]) / across if across else 1.0
    return nearest


@mistake(first_fails=checks.consistent_state_is_the_nearest)
def consistent_state(reference, state, *, length):
    """You move the position along y; move it along its radius."""
    x, y, vx, vy = state
    if x == y == 0:
        raise ValueError("origin")
    y = math.copysign(math.sqrt(max(length**2 - x**2, 0)), y)
    u = (x * vx + y * vy) / length**2
    return np.array([x, y, vx - u * x, vy - u * y])


@mistake(first_fails=checks.consistent_state_is_the_nearest)
def consistent_state(reference, state, *, length):
    """You refuse positions close to the origin; only the origin has no nearest point."""
    if np.allclose(state[:2], 0):
        raise ValueError("no direction")
    return reference(state, length=length)


@mistake(first_fails=checks.consistent_state_is_the_nearest, compared=False)
def consistent_state(reference, state, *, length):
    """You change the given state; return a new array."""
    state[:] = reference(state, length=length)
    return state


@mistake(first_fails=checks.consistent_state_refuses_the_origin, compared=False)
def consistent_state(reference, state, *, length):
    """You accept the origin; no point of the circle is nearest to it."""
    return reference(state, length=length) if np.any(state[:2]) else np.array([0, -length, state[2], 0])


@mistake(first_fails=checks.energy_is_kinetic_and_potential)
def energy(reference, state, **parameters):
    """You use the size of the height; below the hinge y is negative."""
    return reference(np.array([state[0], abs(state[1]), *state[2:]]), **parameters)


@mistake(first_fails=checks.wireframe_is_the_rod)
def wireframe(reference, state, *, length):
    """You draw the rod by its slope y/x, which a vertical rod does not have; draw it to the particle."""
    x, y = state[:2]
    angle = math.atan(y / x) if x else 0.0
    end = math.copysign(length, x) * np.array([math.cos(angle), math.sin(angle)])
    return np.array([[[0.0, 0.0], end]])


# Motions


@mistake(first_fails=checks.without_gravity_it_goes_round_uniformly)
def simulate(reference, t, state, *, length, **parameters):
    """You use y = -sqrt(l^2 - x^2) in every row; x^2 + y^2 = l^2 has two y for an x."""
    states = np.array(reference(t, state, length=length, **parameters))
    states[:, 1] = -np.sqrt(np.maximum(0.0, length**2 - states[:, 0] ** 2))
    return states


@mistake(first_fails=checks.without_gravity_it_goes_round_uniformly)
def simulate(reference, t, state, **parameters):
    """You lose the sense of rotation, for your speed has no sign."""
    x, y, vx, vy = state
    sign = -1.0 if x * vy - y * vx < 0 else 1.0
    return reference(t, np.array([x, y, sign * vx, sign * vy]), **parameters)


@mistake(first_fails=checks.with_gravity_it_swings_or_goes_round, name="gravity_up")
def simulate(reference, t, state, *, gravity, **parameters):
    """You let gravity pull up; it pulls down."""
    return reference(t, state, gravity=-gravity, **parameters)


@mistake(first_fails=checks.with_gravity_it_swings_or_goes_round)
def simulate(reference, t, state, *, mass, length, gravity):
    """You return the motion of small angles; return that of any angle."""
    x, y, vx, vy = state
    angle, rate, w, since = math.atan2(x, -y), (x * vy - y * vx) / length**2, math.sqrt(gravity / length), t - t[0]
    s = np.sin(w * since) / w if w else since
    th, om = angle * np.cos(w * since) + rate * s, rate * np.cos(w * since) - w * w * angle * s
    return length * np.column_stack([np.sin(th), -np.cos(th), om * np.cos(th), om * np.sin(th)])


@mistake(first_fails=checks.with_gravity_it_swings_or_goes_round)
def simulate(reference, t, state, *, length, **parameters):
    """You leave a particle at rest near the top or the bottom where it is; it stays only exactly there."""
    if not np.any(state[2:]) and abs(state[0]) < 0.01 * length:
        return np.tile(state, (len(t), 1))
    return reference(t, state, length=length, **parameters)


@mistake(first_fails=checks.at_the_very_top_it_stays)
def simulate(reference, t, state, *, length, **parameters):
    """You let the particle fall from rest at the very top; there it is in equilibrium."""
    if state[0] == 0 and not np.any(state[2:]):
        state = length * np.array([1e-6, math.copysign(1, state[1]), 0, 0])
    return reference(t, state, length=length, **parameters)


@mistake(first_fails=checks.it_stays_on_the_circle, compared=False, numerics=True)
def simulate(reference, t, state, *, mass, length, gravity):
    """You let the particle drift off the circle; put place and velocity back."""
    return drifting(t, state, gravity)


@mistake(first_fails=checks.it_stays_on_the_circle, compared=False, numerics=True)
def simulate(reference, t, state, *, mass, length, gravity):
    """You put the place back onto the circle; make the velocity tangent, too."""
    states = drifting(t, state, gravity)
    states[:, :2] *= length / np.hypot(states[:, 0], states[:, 1])[:, None]
    return states


@mistake(first_fails=checks.it_stays_on_the_circle, compared=False, numerics=True)
def simulate(reference, t, state, **parameters):
    """You lose a little energy at every step of a long run; take smaller steps."""
    states = reference(t, state, **parameters)
    states[:, 2:] *= np.exp(-4e-5 * np.clip(t - t[0] - 50.0, 0.0, None))[:, None]
    return states
