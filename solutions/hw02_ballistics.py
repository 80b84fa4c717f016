"""hw02: Ballistics with linear drag.

figure.svg, beside this file, shows the axes, the names and the positive senses.

The particle feels its weight, m g down, and the drag -c v. x is to the right, y up; it is launched from
the origin at `angle` above the horizontal. There is no ground: it goes on below y = 0. A state is
x, y, vx, vy in m and m/s.

Off limits inside `trajectory`: scipy.integrate and tam570.integrate. A closed form is asked for.
"""

import math

import numpy as np

from tam570.integrate import solve

__all__ = [
    "best_angle",
    "flight_time",
    "free_body_diagram",
    "horizontal_range",
    "limit_shape",
    "plot_comparison",
    "simulate",
    "state_derivative",
    "trajectory",
]


def free_body_diagram(state, *, mass, drag, gravity):
    """The forces on the particle.

    state   : (4,) x, y, vx, vy; m and m/s
    mass    : kg
    drag    : c in the force -c v, kg/s, may be 0
    gravity : m/s^2, may be 0
    Returns a list of pairs (point, direction), one for each force: where it acts, (2,) in m, and a vector (2,) of any
    length along which it acts, or None where neither component is known. The order is free.
    """
    x, y, vx, vy = state
    return [((x, y), (0.0, -1.0)), ((x, y), (-vx, -vy))]


def state_derivative(t, state, *, mass, drag, gravity):
    """Rate of change of the state: what solve and solve_ivp integrate.

    t       : s, not used
    state   : (4,) x, y, vx, vy; m and m/s
    mass    : kg
    drag    : c in the force -c v, kg/s, may be 0
    gravity : m/s^2, may be 0
    Returns (4,) vx, vy, ax, ay.
    """
    _, _, vx, vy = state
    return np.array(_rates(t, (0.0, 0.0, vx, vy), rate=drag / mass, gravity=gravity))


def simulate(t, speed, angle, *, mass, drag, gravity):
    """The motion by numerical integration, launched at t[0].

    t     : (n,) s, strictly increasing, n >= 2; its sampling does not change the motion
    speed : of the launch, m/s
    angle : of the launch above the horizontal, rad
    mass, drag, gravity : kg, kg/s, m/s^2
    Returns (n, 4), the states at t.
    """
    start = (0.0, 0.0, speed * math.cos(angle), speed * math.sin(angle))
    return solve(_rates, t, start, parameters={"rate": drag / mass, "gravity": gravity}, rtol=1e-13)


def trajectory(t, speed, angle, *, mass, drag, gravity):
    """The motion in closed form, launched at t = 0.

    Good to all digits for any drag, zero included: no difference of nearly equal numbers may be left in it.

    t     : (n,) s
    speed : of the launch, m/s
    angle : of the launch above the horizontal, rad
    mass, drag, gravity : kg, kg/s, m/s^2
    Returns (n, 4), the states at t.
    """
    t = np.asarray(t, dtype=float)
    decay, phi1, phi2 = np.vectorize(_decays, otypes=[float] * 3)(drag / mass * t)
    vx, vy = speed * math.cos(angle), speed * math.sin(angle)
    fallen, fall_speed = gravity * t * t * phi2, gravity * t * phi1
    return np.column_stack([vx * t * phi1, vy * t * phi1 - fallen, vx * decay, vy * decay - fall_speed])


def flight_time(speed, angle, *, mass, drag, gravity):
    """Time until the particle is back at launch height.

    speed : of the launch, m/s, positive
    angle : of the launch above the horizontal, rad, 0 < angle <= pi/2
    mass, drag, gravity : kg, kg/s, m/s^2; gravity positive
    Returns s, positive.
    """
    drag_free = 2.0 * speed * math.sin(angle) / gravity
    lift = 0.5 * drag / mass * drag_free
    return drag_free * _slowing(lift)


def horizontal_range(speed, angle, *, mass, drag, gravity):
    """Distance from the launch at which the particle is back at launch height.

    speed : of the launch, m/s, positive
    angle : of the launch above the horizontal, rad, 0 < angle <= pi/2
    mass, drag, gravity : kg, kg/s, m/s^2; gravity positive
    Returns m.
    """
    time = flight_time(speed, angle, mass=mass, drag=drag, gravity=gravity)
    _, phi1, _ = _decays(drag / mass * time)
    return speed * math.cos(angle) * time * phi1


def best_angle(speed, *, mass, drag, gravity):
    """Launch angle of the largest range.

    speed : of the launch, m/s, positive
    mass, drag, gravity : kg, kg/s, m/s^2; gravity positive
    Returns rad, to 1e-6 rad; at a huge speed, where it is small, to 1 % of itself.
    """
    s = _best_duration(drag * speed / (mass * gravity))
    _, phi1, phi2 = _decays(s)
    return math.atan(math.sqrt(phi2 / _phi12(s)) * math.exp(-0.5 * s))


def limit_shape(angle):
    """Corners of the path in the limit of infinite speed, from the launch back to launch height.

    angle : of the launch above the horizontal, rad, 0 < angle <= pi/2
    Returns (3, 2), x and y of the corners from start to end, in units of mass * speed / drag.
    """
    x, y = math.cos(angle), math.sin(angle)
    return np.array([[0.0, 0.0], [x, y], [x, 0.0]])


def plot_comparison(ax, t, speed, angle, *, mass, drag, gravity):
    """Draw the numerical and the closed-form path, from t[0] to t[-1], at the same scale.

    ax    : Matplotlib Axes to draw on; one line for each path, labelled
    t     : (n,) s, strictly increasing from the launch at t[0] = 0
    speed : of the launch, m/s
    angle : of the launch above the horizontal, rad
    mass, drag, gravity : kg, kg/s, m/s^2
    """
    times = np.linspace(0.0, t[-1] - t[0], 400)
    parameters = {"mass": mass, "drag": drag, "gravity": gravity}
    for motion, label, style in ((simulate, "numerical", "-"), (trajectory, "closed form", "--")):
        x, y, _, _ = motion(times, speed, angle, **parameters).T
        ax.plot(x, y, style, label=label)
    ax.set(xlabel="x (m)", ylabel="y (m)", aspect="equal")
    ax.legend()


def _rates(t, state, rate, gravity):
    """The state's derivative in plain floats; rate = c/m."""
    _, _, vx, vy = state
    return vx, vy, -rate * vx, -rate * vy - gravity


# In the dimensionless time s = c t / m the motion is made of two functions, entire and known in exponential
# integrators (Hochbruck and Ostermann, Acta Numerica 19, 2010):
#     phi1(-s) = (1 - e^-s)/s -> 1,   phi2(-s) = (s - 1 + e^-s)/s^2 -> 1/2   as s -> 0,
# with s phi2 = 1 - phi1. The derivative of phi1(-s) is -phi12, where phi12 = phi1 - phi2 = (1 - (1 + s) e^-s)/s^2.


def _decays(s):
    """e^-s, phi1(-s) and phi2(-s)."""
    phi1 = -math.expm1(-s) / s if s else 1.0
    return math.exp(-s), phi1, (1.0 - phi1) / s if abs(s) > 1.0 else _phi2_series(s)


def _phi2_series(s):
    """phi2(-s) = 1/2 - s/6 + s^2/24 - ..., from the inside out; to all digits for abs(s) <= 1."""
    inner = 1.0
    for n in range(20, 2, -1):
        inner = 1.0 - s / n * inner
    return 0.5 * inner


def _phi12(s):
    """phi1(-s) - phi2(-s), s >= 0."""
    decay, phi1, phi2 = _decays(s)
    return (phi1 - decay) / s if s > 1.0 else phi1 - phi2


def _slowing(lift):
    """Flight time as a multiple of that without drag; lift = c vy(0) / (m g).

    The flight ends at s = 1 + lift + W(-(1 + lift) e^-(1 + lift)), W Lambert's function on its principal branch
    (Packel and Yuen, College Math. J. 35, 2004). Without drag W sits at its branch point and half of the digits are
    lost. Here s is the zero of lift phi1 - s phi2, which is convex, falls with the slope -(1 + lift) phi12 and
    is as good at s = 0 as anywhere: Newton's method from below, lift < s, climbs to it.
    """
    if lift == 0.0:
        return 1.0
    s, step = lift, lift
    while step > 1e-15 * s:
        _, phi1, phi2 = _decays(s)
        step = (lift * phi1 - s * phi2) / ((1.0 + lift) * _phi12(s))
        s += step
    return 0.5 * s / lift


def _best_duration(swiftness):
    """Flight time c T / m at the best angle; swiftness = c v / (m g).

    The range is v cos(angle) T / (1 + lift). It is largest where lift = swiftness sin(angle) obeys

        lift = s phi2 / phi1,   swiftness^2 - lift^2 = lift (s - lift) e^s,   s - lift = s phi12 / phi1;

    the swiftness grows with s, which is bisected: e^(s/2) - 1 <= swiftness.
    """
    low, high = 0.0, 2.0 * math.log1p(swiftness)
    while low < (s := 0.5 * (low + high)) < high:
        decay, phi1, phi2 = _decays(s)
        lift, rest = s * phi2 / phi1, s * _phi12(s) / phi1
        if math.sqrt(lift * (lift * decay + rest)) < swiftness * math.exp(-0.5 * s):
            low = s
        else:
            high = s
    return s
