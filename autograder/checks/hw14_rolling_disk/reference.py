"""Reference functions of hw14, by the angular momentum about the contact; w1, w2, w3 is omega along e1, e2, e3."""

import math

import numpy as np

from tam570.integrate import solve
from tam570_grader.checks.diagrams import Force, FreeBody, weight

Z = np.array([0.0, 0.0, 1.0])
RIGHT = math.pi / 2
CENTRE, MATRIX, OMEGA = slice(0, 3), slice(3, 12), slice(12, 15)
TERMS = np.arange(400)  # of a series in cos(tilt), exact up to rounding where sin(tilt) is 0.4


def frame(state):
    """Return the rows e1, e2, e3."""
    yaw, tilt = state[2:4]
    e1 = np.array([math.cos(yaw), math.sin(yaw), 0.0])
    across = np.array([-e1[1], e1[0], 0.0])
    c, s = math.cos(tilt), math.sin(tilt)
    return np.array([e1, s * Z + c * across, c * Z - s * across])


def components(state, functions=np):
    """Return w1, w2, w3, also of columns. functions : math, which is fast, or numpy."""
    _, _, _, tilt, _, yaw_rate, tilt_rate, roll_rate = state
    return tilt_rate, yaw_rate * functions.sin(tilt), roll_rate + yaw_rate * functions.cos(tilt)


def matrix_state(state, radius):
    E, roll = frame(state), state[4]
    centre = np.array([state[0], state[1], 0.0]) + radius * E[1]
    c, s = math.cos(roll), math.sin(roll)
    R = np.array([[c, s, 0.0], [-s, c, 0.0], Z]) @ E
    return np.concatenate([centre, R.T.ravel(), components(state) @ E])


def euler_state(state, radius):
    """Return the Euler state of a matrix state."""
    R, w = np.reshape(state[MATRIX], (3, 3)), np.asarray(state[OMEGA])
    s = math.hypot(*R[:2, 2])
    yaw, tilt = math.atan2(R[0, 2], -R[1, 2]), math.atan2(s, R[2, 2])
    e1, e2, e3 = frame([0, 0, yaw, tilt])
    x, y, _ = state[CENTRE] - radius * e2
    yaw_rate = w @ e2 / s
    roll = math.atan2(-R[:, 1] @ e1, R[:, 0] @ e1)
    return np.array([x, y, yaw, tilt, roll, yaw_rate, w @ e1, w @ e3 - yaw_rate * e3[2]])


def component_rates(state, *, mass, radius, inertia, gravity):
    """Return w1', w2', w3': the contact, about which only the weight has a moment, moves along -e1 at a roll'."""
    (A, C), m = inertia, mass * radius**2
    w1, w2, w3 = components(state, math)
    tilt, roll_rate = state[3], state[7]
    H1, H2, H3, turn = (A + m) * w1, A * w2, (C + m) * w3, w3 - roll_rate  # the frame turns at w1, w2, turn
    moment = -mass * gravity * radius * math.cos(tilt)
    about_e2 = w1 * H3 - turn * H1 - m * roll_rate * w1
    return (moment + turn * H2 - w2 * H3) / (A + m), about_e2 / A, (w2 * H1 - w1 * H2) / (C + m)


def euler_state_derivative(_, state, **disk):
    _, _, yaw, tilt, _, yaw_rate, tilt_rate, roll_rate = state
    c, s, speed = math.cos(tilt), math.sin(tilt), -disk["radius"] * roll_rate
    tilt_second, w2_rate, w3_rate = component_rates(state, **disk)
    yaw_second = (w2_rate - yaw_rate * tilt_rate * c) / s
    roll_second = w3_rate - yaw_second * c + yaw_rate * tilt_rate * s
    velocity = speed * math.cos(yaw), speed * math.sin(yaw)
    return *velocity, yaw_rate, tilt_rate, roll_rate, yaw_second, tilt_second, roll_second


def accelerations(state, **disk):
    """Return omega' and the acceleration of the centre, which is at a e2 from the contact, in space axes."""
    omega, arm, E = np.array(components(state)), [0.0, disk["radius"], 0.0], frame(state)
    turning = omega - [0.0, 0.0, state[7]]
    omega_rate = component_rates(state, **disk) + np.cross(turning, omega)
    return omega_rate @ E, (np.cross(omega_rate, arm) + np.cross(omega, np.cross(turning, arm))) @ E


def matrix_state_derivative(_, state, **disk):
    euler, omega = euler_state(state, disk["radius"]), state[OMEGA]
    velocity = np.cross(omega, disk["radius"] * frame(euler)[1])
    R_rate = np.cross(omega, np.reshape(state[MATRIX], (3, 3)).T).T
    return np.concatenate([velocity, R_rate.ravel(), accelerations(euler, **disk)[0]])


def multiplier_state_derivative(t, state, **disk):
    return matrix_state_derivative(t, state, **disk)


def energy(state, *, mass, radius, inertia, gravity):
    """Return the energy, J, also of columns."""
    (A, C), (w1, w2, w3) = inertia, components(state)
    moving, turning = mass * radius**2 * (w1**2 + w3**2), A * (w1**2 + w2**2) + C * w3**2
    return (moving + turning) / 2 + mass * gravity * radius * np.sin(state[3])


def contact_force(state, **disk):
    return disk["mass"] * (accelerations(state, **disk)[1] + disk["gravity"] * Z)


def simulate_euler(t, state, rtol=1e-10, **disk):
    """Return (n, 8) Euler states; raise ArithmeticError if the disk falls flat."""

    def rates(time, row):
        return euler_state_derivative(time, row.tolist(), **disk)  # in plain floats, which are fast

    return solve(rates, t, state, rtol=rtol, method="python")


def simulate_matrix(t, state, **disk):
    """Return (n, 15) matrix states."""
    radius = disk["radius"]
    return np.array([matrix_state(row, radius) for row in simulate_euler(t, euler_state(state, radius), **disk)])


def two_integrals(rows, *, mass, radius, inertia, gravity):
    """Return (n, 2): w2 and w3 carried to the upright disk by their linear equations in the tilt (Appell, Korteweg).

    dw3 = share w2, dw2 = C/A w3 - w2/tan(tilt): w3 is a Legendre function of x = cos(tilt), here its series about 0.
    """
    (A, C), share, x = inertia, mass * radius**2 / (inertia[1] + mass * radius**2), np.cos(rows[:, 3:4])
    ratios = (TERMS * (TERMS + 1) + share * C / A) / ((TERMS + 1) * (TERMS + 2))  # of term n + 2 to term n
    weights = np.ones(len(TERMS))
    weights[2::2], weights[3::2] = np.cumprod(ratios[:-2:2]), np.cumprod(ratios[1:-2:2])
    powers = x**TERMS
    summands, slopes = weights * powers, (TERMS * weights)[1:] * powers[:, :-1]
    w3 = [summands[:, first::2].sum(axis=1) for first in (0, 1)]  # for w3 = 1, and for w2 = -1/share, upright
    w2 = [-np.sin(rows[:, 3]) / share * slopes[:, first::2].sum(axis=1) for first in (1, 0)]
    turning = np.transpose(components(rows.T)[1:])[..., None]
    upright = np.linalg.solve(np.moveaxis(np.array([w2, w3]), 2, 0), turning)[..., 0]
    return upright[:, ::-1] * [-1 / share, 1.0]


def not_a_rotation(rows, **_):
    """Return (n, 3, 3), R^T R."""
    R = rows[:, MATRIX].reshape(-1, 3, 3)
    return R.transpose(0, 2, 1) @ R


def above_the_ground(rows, *, radius, **_):
    """Return (n,) m, the height of the centre over that of a disk on the ground."""
    return rows[:, 2] - radius * np.hypot(rows[:, 5], rows[:, 8])


# Steady and nearly upright


def steady_residual(lean, precession, spin, **disk):
    """Return tilt'' of hw11's motion."""
    state = np.array([0, 0, 0, lean + RIGHT, 0, precession, 0, spin + precession * math.sin(lean)])
    return euler_state_derivative(0, state, **disk)[6]


def growth_rate_squared(speed, **disk):
    """Return d(tilt'')/d(tilt) at w2 = C/A spin d(tilt), the balance about e2; by a five-point difference."""
    spin, h = speed / disk["radius"], 1e-3

    def second(lean):
        yaw_rate = disk["inertia"][1] / disk["inertia"][0] * spin * lean / math.cos(lean)
        return steady_residual(lean, yaw_rate, spin, **disk)

    return (8 * (second(h) - second(-h)) - second(2 * h) + second(-2 * h)) / (12 * h)


def critical_speed(**disk):
    """Return the speed at which growth, linear in the square of the speed, is zero."""
    still, moving = growth_rate_squared(0.0, **disk), growth_rate_squared(1.0, **disk)
    return math.sqrt(still / (still - moving))


def usual(disk):
    """Return the scale of angular rates, rad/s."""
    return math.sqrt((disk["gravity"] or 10.0) / disk["radius"])


# The picture


def turned(angles, by):
    """Return the angles less a whole number of `by`, between -by/2 and by/2."""
    return (angles + by / 2) % by - by / 2


def in_the_disk(points, placed, radius):
    """Return the angles of points in the plane of a disk of this matrix state, and their distances from the rim, m."""
    x, y, z = np.moveaxis((points - placed[CENTRE]) @ np.linalg.pinv(placed[MATRIX].reshape(3, 3)).T, -1, 0)
    return np.arctan2(y, x), np.hypot(np.hypot(x, y) - radius, z)


def free_body_diagram(state, mass, radius, gravity):
    """Return the disk and its forces; the ground does not push a disk at rest without gravity."""
    contact = np.array([state[0], state[1], 0.0])
    centre = contact + radius * frame(state)[1]
    ground = Force("the force of the ground", contact, "the contact", acts=gravity != 0 or bool(np.any(state[5:])))
    turns = np.linspace(0.0, 2 * np.pi, 25)[:, None]
    rim = centre + radius * (np.cos(turns) * frame(state)[0] + np.sin(turns) * frame(state)[1])
    forces = weight(centre, "the centre", gravity, -Z), ground
    return FreeBody("the disk", forces, outline=np.stack([rim[:-1], rim[1:]], axis=1))
