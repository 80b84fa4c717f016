"""Known mistakes of hw06."""

import math

import numpy as np

from tam570_grader.diagnosis.mistakes import mistake

from . import checks


def share(locked, *, front, rear, **others):
    """The part of the weight that the locked axle carries."""
    return axle_load(locked, mass=1.0, front=front, rear=rear, gravity=1.0)


# Forces


@mistake(first_fails=checks.forces_on_the_car, compared=False)
def free_body_diagram(reference, state, locked, **car):
    """You wrote forward and left components; the diagram has the axes of the ground."""
    (locked_axle, _), (free, _) = reference(state, locked, **car)
    return [(locked_axle, friction_force(state, locked, **car)), (free, (0.0, 1.0))]


@mistake(first_fails=checks.forces_on_the_car, compared=False)
def free_body_diagram(reference, state, locked, **car):
    """You drew the drag at the free axle and the side force at the locked one; the locked axle drags."""
    (locked_axle, drag), (free, side) = reference(state, locked, **car)
    return [(free, drag), (locked_axle, side)]


@mistake(first_fails=checks.axle_load_balances_the_weight)
def axle_load(reference, locked, *, front, rear, **car):
    """You put half of the weight on each axle; the load depends on G."""
    return reference(locked, front=1.0, rear=1.0, **car)


@mistake(first_fails=checks.axle_load_balances_the_weight)
def axle_load(reference, locked, *, front, rear, **car):
    """You divide one axle's distance from G by the other's; divide it by the wheelbase."""
    load = reference(locked, front=front, rear=rear, **car)
    return load * (front + rear) / (front if locked == "front" else rear)


@mistake(first_fails=checks.forces_on_the_car)
def friction_force(reference, state, locked, **car):
    """You use the full friction along each axis of the car; friction is one force against the locked axle's
    velocity.
    """
    force = reference(state, locked, **car)
    return math.hypot(*force) * np.sign(force)


@mistake(first_fails=checks.forces_on_the_car)
def friction_force(reference, state, locked, **car):
    """You point friction straight back along the car; it opposes the velocity of the locked axle."""
    return np.array([-math.hypot(*reference(state, locked, **car)) * np.sign(state[3]), 0.0])


@mistake(first_fails=checks.forces_on_the_car)
def friction_force(reference, state, locked, *, mass, front, rear, friction, gravity):
    """You oppose the velocity of G; friction opposes the velocity of the locked axle."""
    drag = friction * axle_load(locked, mass=mass, front=front, rear=rear, gravity=gravity)
    return np.array(_drag_force(*state[3:], arm=-_axles(locked, front, rear)[0], drag=drag))


@mistake(first_fails=checks.forces_on_the_car)
def friction_force(reference, state, locked, **car):
    """You return the force along x and y of the ground; return its forward and left components."""
    forward, side = reference(state, locked, **car)
    c, s = math.cos(state[2]), math.sin(state[2])
    return np.array([forward * c - side * s, forward * s + side * c])


@mistake(first_fails=checks.forces_on_the_car)
def friction_force(reference, state, locked, **car):
    """You take the arctan of left over forward, which is the same in reverse; use arctan2."""
    return reference(state, locked, **car) * np.sign(state[3])


@mistake(first_fails=checks.friction_opposes_the_sliding)
def friction_force(reference, state, locked, **car):
    """You use friction under the whole weight; the locked axle carries only a part of it."""
    return reference(state, locked, **car) / share(locked, **car)


@mistake(first_fails=checks.friction_in_any_motion_and_at_rest)
def friction_force(reference, state, locked, **car):
    """You smooth friction below a few cm/s; Coulomb friction is as large at any speed."""
    sliding = _sliding_speed(*state[3:], _axles(locked, car["front"], car["rear"])[1])
    return reference(state, locked, **car) * math.tanh(sliding / 1e-2)


@mistake(first_fails=checks.forces_on_the_car, compared=False)
def friction_force(reference, state, locked, **car):
    """You divide zero by zero at rest; return zero friction there."""
    return reference(state, locked, **car) / (1.0 if any(state[3:]) else math.nan)


# Equations of motion


@mistake(first_fails=checks.equations_of_motion)
def state_derivative(reference, t, state, locked, **car):
    """You move G only along the car; G also moves sideways, as the car turns."""
    rates = reference(t, state, locked, **car)
    return np.array([state[3] * math.cos(state[2]), state[3] * math.sin(state[2]), *rates[2:]])


@mistake(first_fails=checks.equations_in_any_motion)
def state_derivative(reference, t, state, locked, **car):
    """You use the size of the speed; the speed is negative in reverse."""
    return reference(t, np.array([*state[:3], abs(state[3]), state[4]]), locked, **car)


@mistake(first_fails=checks.equations_without_friction_and_at_rest)
def state_derivative(reference, t, state, locked, **car):
    """For front = rear you return no yaw acceleration; the car still turns."""
    rates = reference(t, state, locked, **car)
    return np.append(rates[:4], rates[4] if car["front"] != car["rear"] else 0.0)


@mistake(first_fails=checks.equations_without_friction_and_at_rest, compared=False)
def state_derivative(reference, t, state, locked, **car):
    """You divide by the speed, which is zero at rest; return zero rates there."""
    return reference(t, state, locked, **car) / (1.0 if any(state[3:]) else math.nan)


@mistake(first_fails=checks.kinetic_energy_of_G_and_of_turning)
def kinetic_energy(reference, state, locked, *, mass, front, rear, **car):
    """You omit G's sideways velocity from the kinetic energy; G is not on the free axle."""
    sideways = _axles(locked, front, rear)[0] * state[4]
    return reference(state, locked, mass=mass, front=front, rear=rear, **car) - mass * sideways**2 / 2


@mistake(first_fails=checks.mechanics_refuses_other_axles, compared=False)
def kinetic_energy(reference, state, locked, **car):
    """You use the rear axle for every name except front; raise ValueError for other names."""
    return reference(state, "front" if locked == "front" else "rear", **car)


# The motion


@mistake(first_fails=checks.simulate_brakes)
def simulate(reference, t, state, locked, **car):
    """You wrap the heading; it counts whole turns."""
    rows = reference(t, state, locked, **car)
    rows[:, 2] = (rows[:, 2] + math.pi) % (2 * math.pi) - math.pi
    return rows


@mistake(first_fails=checks.simulate_brakes)
def simulate(reference, t, state, locked, **car):
    """You stop a car that goes back because its speed is not positive; it stops where speed and yaw rate are zero."""
    rows = reference(t, state, locked, **car)
    if state[3] < 0:
        rows[1:] = [*state[:3], 0.0, 0.0]
    return rows


@mistake(first_fails=checks.simulate_needs_no_dense_times)
def simulate(reference, t, state, locked, **car):
    """You leave a car of zero speed where it is; it may still turn about its free axle."""
    return reference(t, state, locked, **car) if state[3] else np.tile(state, (len(t), 1))


@mistake(first_fails=checks.simulate_glides_without_friction)
def simulate(reference, t, state, locked, **car):
    """You stop the car below 1 cm/s; without friction nothing stops it."""
    sliding = _sliding_speed(*state[3:], _axles(locked, car["front"], car["rear"])[1])
    return np.tile(state, (len(t), 1)) if sliding < 1e-2 else reference(t, state, locked, **car)


@mistake(first_fails=checks.simulate_comes_to_rest_and_stays, compared=False)
def simulate(reference, t, state, locked, **car):
    """You stop the car where its speed is zero; it may still turn, and rests only where both are zero."""
    rows = reference(t, state, locked, **car)
    slow = 5e-4 * _sliding_speed(*state[3:], car["front"] + car["rear"])
    first = np.argmax(rows[:, 3] * np.sign(state[3]) < slow)
    if first:
        rows[first:] = [*rows[first, :3], 0.0, 0.0]
    return rows


@mistake(first_fails=checks.simulate_comes_to_rest_and_stays)
def simulate(reference, t, state, locked, **car):
    """You set the speed to zero at the stop but keep moving x; the place is constant after the stop."""
    rows = reference(t, state, locked, **car)
    still = ~rows[:, 3:].any(axis=1)
    rows[still, 0] += 1e-3 * state[3] * (t[still] - t[0])
    return rows


@mistake(first_fails=checks.simulate_comes_to_rest_and_stays, compared=False)
def simulate(reference, t, state, locked, **car):
    """You fill the rows after the stop with zeros; the place and heading keep their values."""
    rows = reference(t, state, locked, **car)
    rows[1:][~rows[1:, 3:].any(axis=1) & (state[3] != 0)] = 0.0
    return rows


@mistake(first_fails=checks.simulate_comes_to_rest_and_stays, compared=False)
def simulate(reference, t, state, locked, **car):
    """You divide by the speed of a car that starts at rest; return rows of the given state."""
    return reference(t, state, locked, **car) / (1.0 if any(state[3:]) else math.nan)


# Stability


@mistake(first_fails=checks.growth_rate_is_the_slope)
def yaw_growth_rate(reference, speed, locked, **car):
    """You use the locked axle's distance from G in friction's term; use the wheelbase."""
    constants = _car(locked, **car)
    more = constants["drag"] * (constants["arm"] ** 2 - (constants["free"] + constants["arm"]) ** 2) / speed
    return reference(speed, locked, **car) + more / constants["inertia"]


@mistake(first_fails=checks.growth_rate_is_the_slope)
def yaw_growth_rate(reference, speed, locked, **car):
    """You cut a negative growth rate off to 0; return the negative rate."""
    return max(reference(speed, locked, **car), 0.0)


@mistake(first_fails=checks.critical_speed_is_where_growth_begins)
def critical_speed(reference, locked, *, front, rear, friction, gravity):
    """You use one formula for either locked axle; with the front locked the car is always stable."""
    return math.sqrt(friction * gravity * abs(_axles(locked, front, rear)[1]))


@mistake(first_fails=checks.stability_refuses_other_axles, compared=False)
def critical_speed(reference, locked, **car):
    """You use the rear axle for every name except front; raise ValueError for other names."""
    return reference("front" if locked == "front" else "rear", **car)


@mistake(first_fails=checks.small_yaw_rate_is_the_linear_solution)
def small_yaw_rate(reference, speed, speed0, yaw_rate0, locked, **car):
    """You use the growth rate of the first speed at every speed; integrate it over the speed."""
    time = (speed0 - speed) * car["mass"] / _car(locked, **car)["drag"]
    return yaw_rate0 * math.exp(yaw_growth_rate(speed0, locked, **car) * time)


@mistake(first_fails=checks.small_yaw_rate_is_the_linear_solution)
def small_yaw_rate(reference, speed, speed0, yaw_rate0, locked, **car):
    """You slow the car by friction under its whole weight; the locked axle carries only a part of it."""
    return yaw_rate0 * reference(speed, speed0, 1.0, locked, **car) ** share(locked, **car)
