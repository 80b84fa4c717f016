"""Known mistakes of hw14."""

import math

import numpy as np

from tam570_grader.diagnosis.fixed_steps import runge_kutta
from tam570_grader.diagnosis.mistakes import mistake

from . import checks


def rolling_inertia(disk):
    return disk["mass"] * disk["radius"] ** 2


def along_e1_if_it_rolls(state, disk):
    """What tilt'' gains where the frame e1, e2, e3 turns with the body."""
    A, _ = disk["inertia"]
    return A / (A + rolling_inertia(disk)) * state[5] * math.sin(state[3]) * state[7]


# The diagram


@mistake(first_fails=checks.forces_on_the_disk, compared=False)
def free_body_diagram(reference, state, **disk):
    """You drew m a as a force; no other body exerts it."""
    (centre, down), ground = reference(state, **disk)
    return [(centre, down), ground, (centre, (1.0, 0.5, 0.1))]


@mistake(first_fails=checks.forces_on_the_disk, compared=False)
def free_body_diagram(reference, state, **disk):
    """You drew the force of the ground straight up; a disk that rolls needs friction."""
    weight, (contact, _) = reference(state, **disk)
    return [weight, (contact, (0.0, 0.0, 1.0))]


# The matrix state


@mistake(first_fails=checks.matrix_state_places_the_disk)
def matrix_state(reference, state, *, radius):
    """You return R column by column; return it row by row."""
    result = reference(state, radius=radius)
    return np.concatenate([result[:3], result[3:12].reshape(3, 3).T.ravel(), result[12:]])


@mistake(first_fails=checks.matrix_state_places_the_disk)
def matrix_state(reference, state, *, radius):
    """You return body components of omega; return space components."""
    result = reference(state, radius=radius)
    return np.concatenate([result[:12], result[12:] @ result[3:12].reshape(3, 3)])


@mistake(first_fails=checks.matrix_state_places_the_disk)
def matrix_state(reference, state, *, radius):
    """You return omega's components along e1, e2, e3; return space components."""
    result = reference(state, radius=radius)
    return np.concatenate([result[:12], _frame(state) @ result[12:]])


@mistake(first_fails=checks.matrix_state_places_the_disk)
def matrix_state(reference, state, *, radius):
    """You turn the disk at roll' about z; it rolls about its axle."""
    _, _, yaw, _, _, yaw_rate, tilt_rate, roll_rate = state
    omega = [tilt_rate * math.cos(yaw), tilt_rate * math.sin(yaw), yaw_rate + roll_rate]
    return np.concatenate([reference(state, radius=radius)[:12], omega])


# Three derivations


@mistake(first_fails=checks.euler_equations_hold)
def euler_state_derivative(reference, t, state, **disk):
    """You set x' = y' = 0; the disk's point at the contact is at rest, but the contact moves along the ground."""
    return [0.0, 0.0, *reference(t, state, **disk)[2:]]


@mistake(first_fails=checks.euler_equations_hold)
def euler_state_derivative(reference, t, state, **disk):
    """You move the contact with the spin, as fast as the centre; it moves with roll'."""
    speed = -disk["radius"] * _spin(state)
    return [speed * math.cos(state[2]), speed * math.sin(state[2]), *reference(t, state, **disk)[2:]]


@mistake(first_fails=checks.euler_equations_hold)
def euler_state_derivative(reference, t, state, **disk):
    """You turn the frame e1, e2, e3 with the body; it does not roll."""
    tilt, _, _, tilt_rate, roll_rate = state[3:]
    rates = np.array(reference(t, state, **disk))
    yaw_acceleration = -tilt_rate * roll_rate / math.sin(tilt)
    rates[5:] += yaw_acceleration, along_e1_if_it_rolls(state, disk), -yaw_acceleration * math.cos(tilt)
    return rates


@mistake(first_fails=checks.euler_equations_hold)
def euler_state_derivative(reference, t, state, **disk):
    """You use I omega' as the rate of H; add omega x H."""
    tilt, _, yaw_rate, tilt_rate, _ = state[3:]
    A, C = disk["inertia"]
    rates, gyroscopic = np.array(reference(t, state, **disk)), (C - A) * _spin(state)
    along_e1 = gyroscopic * yaw_rate * math.sin(tilt) / (A + rolling_inertia(disk))
    yaw_acceleration = -gyroscopic * tilt_rate / A / math.sin(tilt)
    rates[5:] += yaw_acceleration, along_e1, -yaw_acceleration * math.cos(tilt)
    return rates


@mistake(first_fails=checks.euler_equations_hold)
def euler_state_derivative(reference, t, state, **disk):
    """You treat the contact as a point of the body; its place in the disk changes."""
    rolling = rolling_inertia(disk)
    rates = np.array(reference(t, state, **disk))
    rates[6] -= rolling / (disk["inertia"][0] + rolling) * state[5] * math.sin(state[3]) * state[7]
    return rates


@mistake(first_fails=checks.euler_equations_hold, name="gravity_of_the_earth")
def euler_state_derivative(reference, t, state, *, gravity, **disk):
    """You use 9.81 m/s^2; use the given gravity."""
    return reference(t, state, gravity=9.81, **disk)


@mistake(first_fails=checks.euler_equations_hold_next_to_flat_and_upright, compared=False)
def euler_state_derivative(reference, t, state, **disk):
    """You keep the tilt 0.01 away from flat; no tilt but 0 and pi is singular."""
    tilt = min(max(state[3], 0.01), math.pi - 0.01)
    return reference(t, [*state[:3], tilt, *state[4:]], **disk)


@mistake(first_fails=checks.matrix_equations_hold)
def matrix_state_derivative(reference, t, state, **disk):
    """You use dR/dt = R omega-hat; omega has space components, so it is omega-hat R."""
    rates = np.array(reference(t, state, **disk))
    rates[3:12] = (np.reshape(state[3:12], (3, 3)) @ _cross_matrix(state[12:])).ravel()
    return rates


@mistake(first_fails=checks.multiplier_equations_hold)
def _contact_arm(reference, axle, omega, radius):
    """You forget the rate of the arm when you differentiate the constraint; the arm to the contact turns."""
    arm, _ = reference(axle, omega, radius)
    return arm, np.zeros(3)


@mistake(first_fails=checks.multiplier_equations_hold)
def _contact_arm(reference, axle, omega, radius):
    """You turn the arm to the contact with the body; the contact is no point of the body."""
    arm, _ = reference(axle, omega, radius)
    return arm, np.cross(omega, arm)


@mistake(first_fails=checks.multiplier_equations_hold)
def multiplier_state_derivative(reference, t, state, **disk):
    """You use diag(A, A, C) in space axes, but it belongs to the body; there the inertia is R diag(A, A, C) R^T."""
    mass, rates, omega = disk["mass"], np.array(reference(t, state, **disk)), np.asarray(state[12:])
    (A, C), (arm, arm_rate) = disk["inertia"], _contact_arm(state[5:12:3], omega, disk["radius"])
    force = mass * (np.array([0.0, 0.0, disk["gravity"]]) - np.cross(omega, arm_rate))  # without omega'
    about_contact = np.diag([A, A, C]) + mass * (arm @ arm * np.eye(3) - np.outer(arm, arm))
    rates[12:] = np.linalg.solve(about_contact, np.cross(arm, force) - np.cross(omega, omega * [A, A, C]))
    return rates


@mistake(first_fails=checks.multiplier_equations_hold, compared=False)
def multiplier_state_derivative(reference, t, state, **disk):
    """You call matrix_state_derivative; derive these equations on their own."""
    return matrix_state_derivative(t, state, **disk)


# Simulations


@mistake(first_fails=checks.euler_simulation_follows_the_motion)
def simulate_euler(reference, t, state, **disk):
    """You start at t = 0; the given state is that at t[0]."""
    sense = np.array([1.0] * 5 + [math.copysign(1.0, t[0])] * 3)  # with opposite rates the motion is reversed
    result = reference(np.array([0.0, abs(t[0])]), sense * state, **disk)[1]
    return reference(t, sense * result, **disk)


@mistake(first_fails=checks.euler_simulation_follows_the_motion)
def simulate_euler(reference, t, state, **disk):
    """You return x and y of the centre; return those of the contact."""
    states = reference(t, state, **disk)
    states[:, :2] = [matrix_state(row, radius=disk["radius"])[:2] for row in states]
    return states


@mistake(first_fails=checks.euler_simulation_keeps_energy_and_two_integrals, compared=False, numerics=True)
def simulate_euler(reference, t, state, **disk):
    """You take 12 Runge-Kutta steps to each time, however far; limit the size of a step."""
    return runge_kutta(lambda y: euler_state_derivative(0.0, y, **disk), t, state, 12)


@mistake(first_fails=checks.euler_simulation_keeps_energy_and_two_integrals, compared=False, numerics=True)
def simulate_euler(reference, t, state, **disk):
    """You damp the tilt a little in a long motion; nothing takes energy."""

    def damped(t, state, **disk):
        rates = np.array(euler_state_derivative(t, state, **disk))
        rates[6] -= 1e-3 * math.sqrt(disk["gravity"] / disk["radius"]) * state[6]
        return rates

    long = disk["gravity"] * (t[-1] - t[0]) ** 2 > 16 * disk["radius"]
    return _states(damped, t, state, **disk) if long else reference(t, state, **disk)


@mistake(first_fails=checks.matrix_simulation_follows_the_motion)
def simulate_matrix(reference, t, state, **disk):
    """You leave out the start; row 0 is the given state."""
    states = reference(t, state, **disk)
    return np.concatenate([states[1:], states[-1:]])


@mistake(first_fails=checks.both_simulations_agree, compared=False, numerics=True)
def simulate_matrix(reference, t, state, **disk):
    """You take 18 Runge-Kutta steps to each time, however far; limit the size of a step."""
    return runge_kutta(lambda y: matrix_state_derivative(0.0, y, **disk), t, state, 18)


# Steady circles, and the picture


@mistake(first_fails=checks.steady_residual_is_the_tilt_acceleration)
def steady_residual(reference, lean, precession, spin, **disk):
    """You use the spin as relative to the turning frame; it is the total spin."""
    return reference(lean, precession, spin - precession * math.sin(lean), **disk)


@mistake(first_fails=checks.wireframe_is_a_rolling_disk, compared=False)
def wireframe(reference, state, *, radius, sides):
    """You draw the diameters along e1 and e2; they roll with the disk."""
    still = [*state[:4], 0.0, *state[5:]]
    lines = reference(state, radius=radius, sides=sides)
    lines[sides:] = reference(still, radius=radius, sides=sides)[sides:]
    return lines


@mistake(first_fails=checks.wireframe_is_a_rolling_disk, compared=False)
def wireframe(reference, state, *, radius, sides):
    """You leave the polygon open; its last side ends at its first corner."""
    lines = reference(state, radius=radius, sides=sides)
    lines[sides - 1] = lines[0]
    return lines


# Energy and force


@mistake(first_fails=checks.energy_is_kinetic_and_potential)
def energy(reference, state, **disk):
    """You set the potential to zero with the disk upright; it is zero with the centre on the ground."""
    return reference(state, **disk) - disk["mass"] * disk["gravity"] * disk["radius"]


@mistake(first_fails=checks.contact_force_moves_the_centre)
def contact_force(reference, state, **disk):
    """You return components along e1, e2, e3; return those along x, y, z."""
    return _frame(state) @ reference(state, **disk)


@mistake(first_fails=checks.contact_force_moves_the_centre)
def contact_force(reference, state, **disk):
    """You turn the frame e1, e2, e3 with the body; it does not roll."""
    more = np.array([0.0, -_spin(state) * state[7], along_e1_if_it_rolls(state, disk)]) @ _frame(state)
    return reference(state, **disk) + disk["mass"] * disk["radius"] * more


@mistake(first_fails=checks.contact_force_moves_the_centre)
def contact_force(reference, state, **disk):
    """You differentiate only the components of the velocity; e1, e2, e3 turn, too."""
    yaw_acceleration, tilt_acceleration, roll_acceleration = euler_state_derivative(0.0, state, **disk)[5:]
    _, _, _, tilt, _, yaw_rate, tilt_rate, _ = state
    spin_rate = roll_acceleration + yaw_acceleration * math.cos(tilt) - yaw_rate * tilt_rate * math.sin(tilt)
    acceleration = disk["radius"] * np.array([-spin_rate, 0.0, tilt_acceleration]) @ _frame(state)
    return disk["mass"] * (acceleration + [0.0, 0.0, disk["gravity"]])


# Stability


@mistake(first_fails=checks.critical_speed_parts_stable_from_unstable)
def critical_speed(reference, **disk):
    """You return the critical spin; the speed is a times that."""
    return reference(**disk) / disk["radius"]


@mistake(first_fails=checks.growth_rate_is_that_of_a_small_lean)
def growth_rate_squared(reference, speed, **disk):
    """You return the rate or the frequency; return its square, negative where the lean swings."""
    return math.sqrt(abs(reference(speed, **disk)))


@mistake(first_fails=checks.growth_rate_is_that_of_a_small_lean)
def growth_rate_squared(reference, speed, **disk):
    """You return 0 where the motion is stable; return minus the square of the frequency."""
    return max(reference(speed, **disk), 0.0)
