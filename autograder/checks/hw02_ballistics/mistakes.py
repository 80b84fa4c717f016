"""Known mistakes of hw02."""

import math

import numpy as np

from tam570_grader.diagnosis.mistakes import mistake

from . import checks

# Forces


@mistake(first_fails=checks.forces_on_the_particle, compared=False)
def free_body_diagram(reference, state, **parameters):
    """You drew drag along the velocity; on the particle it opposes the velocity."""
    weight, (r, drag) = reference(state, **parameters)
    return [weight, (r, np.negative(drag))]


@mistake(first_fails=checks.forces_on_the_particle, compared=False)
def free_body_diagram(reference, state, **parameters):
    """You drew a force along the velocity; nothing pushes the particle after the launch."""
    return [*reference(state, **parameters), (state[:2], state[2:])]


@mistake(first_fails=checks.rates_are_newtons)
def state_derivative(reference, t, state, *, drag, **parameters):
    """You use quadratic drag, -c v^2; the drag is linear, -c v."""
    return reference(t, state, drag=drag * np.hypot(*state[2:]), **parameters)


@mistake(first_fails=checks.rates_are_newtons)
def state_derivative(reference, t, state, *, mass, drag, gravity):
    """You point the vertical drag down in the fall too; it opposes the velocity, so there it points up."""
    rates = reference(t, state, mass=mass, drag=drag, gravity=gravity)
    return rates - np.array([0, 0, 0, drag / mass * (abs(state[3]) - state[3])])


@mistake(first_fails=checks.rates_are_newtons, compared=False)
def state_derivative(reference, t, state, **parameters):
    """You divide the velocity by its size, which is zero for a particle at rest; use -c v."""
    return reference(t, state, **parameters) / (1.0 if any(state[2:]) else math.nan)


@mistake(first_fails=checks.rates_without_drag_or_gravity, compared=False)
def state_derivative(reference, t, state, *, mass, drag, gravity):
    """You divide by the terminal speed m g/c, which is infinite without drag and zero without gravity; use c and g."""
    terminal = mass * gravity / drag
    return reference(t, state, mass=mass, drag=mass * gravity / terminal, gravity=gravity)


# Motion


@mistake(first_fails=checks.simulation_follows_the_motion, compared=False)
def simulate(reference, t, speed, angle, **parameters):
    """You stop the particle at launch height; there is no ground."""
    rows = reference(t, speed, angle, **parameters)
    return np.column_stack([rows[:, 0], np.maximum(rows[:, 1], 0.0), rows[:, 2:]])


@mistake(first_fails=checks.simulation_follows_the_motion, compared=False, numerics=True)
def simulate(reference, t, speed, angle, **parameters):
    """You take ten Euler steps between two times; use a method of higher order, with an error tolerance."""
    rows = [np.array([0, 0, speed * np.cos(angle), speed * np.sin(angle)])]
    for step in np.diff(t):
        y = rows[-1]
        for _ in range(10):
            y = y + step / 10 * state_derivative(0, y, **parameters)
        rows.append(y)
    return np.array(rows)


@mistake(first_fails=checks.simulation_without_drag_or_gravity, compared=False)
def simulate(reference, t, speed, angle, *, mass, drag, gravity):
    """You scale by m/c and m g/c, which are infinite without drag; use seconds and metres."""
    time, terminal = mass / drag, mass * gravity / drag
    scaled = reference(t / time, speed / terminal, angle, mass=1.0, drag=1.0, gravity=1.0)
    return scaled * [terminal * time, terminal * time, terminal, terminal]


@mistake(first_fails=checks.trajectory_is_the_motion)
def trajectory(reference, t, speed, angle, *, mass, drag, gravity):
    """Your constant of integration has vy(0) - m g/c; it is vy(0) + m g/c."""
    rows = reference(t, speed, angle, mass=mass, drag=drag, gravity=gravity)
    if drag == 0:
        return rows
    decay = np.exp(-drag / mass * t)
    too_low = np.column_stack([0 * t, mass / drag * (1 - decay), 0 * t, decay])
    return rows - 2 * mass * gravity / drag * too_low


@mistake(first_fails=checks.trajectory_counts_time_from_the_launch)
def trajectory(reference, t, speed, angle, **parameters):
    """You count the times from the first one; the launch is at t = 0."""
    return reference(t - t[0], speed, angle, **parameters)


@mistake(first_fails=checks.trajectory_with_any_drag, compared=False)
def trajectory(reference, t, speed, angle, *, mass, drag, gravity):
    """You subtract nearly equal numbers, which loses all digits at little drag; use numpy.expm1 and a series."""
    if drag == 0:
        return reference(t, speed, angle, mass=mass, drag=drag, gravity=gravity)
    vx, vy, k = speed * math.cos(angle), speed * math.sin(angle), drag / mass
    decay = np.exp(-k * t)
    y = (vy + gravity / k) * (1 - decay) / k - gravity * t / k
    return np.column_stack([vx * (1 - decay) / k, y, vx * decay, (vy + gravity / k) * decay - gravity / k])


# Landing


@mistake(first_fails=checks.flight_ends_at_launch_height)
def flight_time(reference, speed, angle, *, mass, drag, gravity):
    """You double the time to the top; with drag the way down takes longer than the way up."""
    if drag == 0:
        return 2 * speed * math.sin(angle) / gravity
    return 2 * mass / drag * math.log1p(drag * speed * math.sin(angle) / (mass * gravity))


@mistake(first_fails=checks.flight_time_with_hardly_any_drag, compared=False)
def flight_time(reference, speed, angle, *, mass, drag, gravity):
    """You use Lambert's W next to its branch point, where it loses half of its digits; add a Newton step."""
    from scipy.special import lambertw

    if drag < 1e-9:
        return 2 * speed * math.sin(angle) / gravity
    a = 1 + drag * speed * math.sin(angle) / (mass * gravity)
    return mass / drag * (a + lambertw(-a * np.exp(-a)).real)


@mistake(first_fails=checks.flight_time_with_great_drag_and_straight_up)
def flight_time(reference, speed, angle, *, mass, drag, gravity):
    """You search for the landing only up to 200 m/c; with great drag the particle falls longer."""
    time = reference(speed, angle, mass=mass, drag=drag, gravity=gravity)
    return min(time, 200 * mass / drag) if drag else time


@mistake(first_fails=checks.range_is_where_it_lands)
def horizontal_range(reference, speed, angle, **parameters):
    """You omit drag from the horizontal motion; it acts on both components."""
    return speed * math.cos(angle) * flight_time(speed, angle, **parameters)


@mistake(first_fails=checks.range_with_hardly_any_drag)
def horizontal_range(reference, speed, angle, *, mass, drag, gravity):
    """You subtract e^(-s) from 1, which loses digits at little drag; use expm1."""
    time = flight_time(speed, angle, mass=mass, drag=drag, gravity=gravity)
    way = mass / drag * (1 - math.exp(-drag / mass * time)) if drag else time
    return speed * math.cos(angle) * way


@mistake(first_fails=checks.best_angle_has_the_largest_range)
def best_angle(reference, speed, **parameters):
    """You always return 45 degrees; with drag the best angle is smaller."""
    return math.pi / 4


@mistake(first_fails=checks.best_angle_is_45_degrees_without_drag, compared=False)
def best_angle(reference, speed, *, mass, drag, gravity):
    """You divide by the drag, which may be zero; without drag return 45 degrees."""
    terminal = mass * gravity / drag
    return reference(speed / terminal, mass=1.0, drag=1.0, gravity=1.0)


@mistake(first_fails=checks.best_angle_is_45_degrees_without_drag, compared=False)
def best_angle(reference, speed, *, mass, drag, gravity):
    """You return 45 degrees below a tenth of the terminal speed; the angle falls in proportion to the drag."""
    slow = drag * speed < 0.1 * mass * gravity
    return math.pi / 4 if slow else reference(speed, mass=mass, drag=drag, gravity=gravity)


@mistake(first_fails=checks.best_angle_at_a_huge_speed, compared=False)
def best_angle(reference, speed, **parameters):
    """You maximise the range, which is very flat at a huge speed; solve for where its derivative vanishes."""
    from scipy.optimize import minimize_scalar

    def shortness(angle):
        return -horizontal_range(speed, angle, **parameters) / speed

    return minimize_scalar(shortness, bounds=(1e-4, 1.5), method="bounded", options={"xatol": 1e-9}).x


# Pictures


@mistake(first_fails=checks.path_at_a_huge_speed_has_the_limit_shape)
def limit_shape(reference, angle):
    """Your top corner is at x = 1 for every angle; it is at x = cos(angle)."""
    return np.array([[0, 0], [1, math.tan(angle)], [1, 0]])


@mistake(first_fails=checks.path_at_a_huge_speed_has_the_limit_shape)
def limit_shape(reference, angle):
    """You land at x = 1; the particle falls straight down from its top corner, at x = cos(angle)."""
    return np.array([*reference(angle)[:2], [1, 0]])


@mistake(first_fails=checks.both_paths_are_drawn, compared=False)
def plot_comparison(reference, ax, t, speed, angle, **parameters):
    """You drew the numerical path twice; draw trajectory's path too."""
    x, y, _, _ = simulate(t, speed, angle, **parameters).T
    ax.plot(x, y, label="numerical")
    ax.plot(x, y, "--", label="closed form")
    ax.set(xlabel="x (m)", ylabel="y (m)", aspect="equal")


@mistake(first_fails=checks.both_paths_are_drawn, compared=False)
def plot_comparison(reference, ax, t, speed, angle, **parameters):
    """You drew y over the time; draw y over x."""
    for motion in (simulate, trajectory):
        ax.plot(t, motion(t, speed, angle, **parameters)[:, 1])
    ax.set(xlabel="t (s)", ylabel="y (m)")
