"""What is right in hw14, from Jourdain's principle: balances along the velocities that rolling allows.

Motions are integrated in the components w1, w2, w3 of omega along e1, e2, e3 (Appell, Korteweg), another way again.
"""

import itertools
import math

import numpy as np
from scipy.integrate import solve_ivp

Z = np.array([0.0, 0.0, 1.0])
RIGHT = math.pi / 2
CENTRE, MATRIX, OMEGA = slice(0, 3), slice(3, 12), slice(12, 15)
MOST_CALLS = 50_000  # of the rates, of a motion that stays off the flat for long


def hat(v):
    """hat(v) @ r = v x r; for vectors one by one it is six times as fast as np.cross."""
    x, y, z = v
    return np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])


def frame(state):
    """Rows e1, e2, e3."""
    yaw, tilt = state[2:4]
    e1 = np.array([math.cos(yaw), math.sin(yaw), 0.0])
    e3 = math.cos(tilt) * Z + math.sin(tilt) * (hat(e1) @ Z)
    return np.array([e1, hat(e3) @ e1, e3])


def components(state):
    """w1, w2, w3 of omega along e1, e2, e3, and the rate of the frame about e3."""
    _, _, _, tilt, _, yaw_rate, tilt_rate, roll_rate = state
    turn = yaw_rate * math.cos(tilt)
    return tilt_rate, yaw_rate * math.sin(tilt), roll_rate + turn, turn


def attitude(state):
    """R, column by column, of e1 and e2 turned by the roll."""
    (e1, e2, e3), roll = frame(state), state[4]
    c, s = math.cos(roll), math.sin(roll)
    return np.column_stack([c * e1 + s * e2, c * e2 - s * e1, e3])


def matrix_state(state, radius):
    E = frame(state)
    centre = np.array([state[0], state[1], 0.0]) + radius * E[1]
    return np.concatenate([centre, attitude(state).ravel(), np.array(components(state)[:3]) @ E])


def euler_state(state, radius):
    """The Euler state of a matrix state."""
    R, w = np.reshape(state[MATRIX], (3, 3)), np.asarray(state[OMEGA])
    s = math.hypot(*R[:2, 2])
    yaw, tilt = math.atan2(R[0, 2], -R[1, 2]), math.atan2(s, R[2, 2])
    e1, e2, e3 = frame([0, 0, yaw, tilt])
    x, y, _ = state[CENTRE] - radius * e2
    yaw_rate = w @ e2 / s
    roll = math.atan2(-R[:, 1] @ e1, R[:, 0] @ e1)
    return np.array([x, y, yaw, tilt, roll, yaw_rate, w @ e1, w @ e3 - yaw_rate * e3[2]])


def jourdain(state, *, mass, radius, inertia, gravity):
    """(yaw'', tilt'', roll''), omega' and the acceleration of the centre."""
    E, rates = frame(state), np.asarray(state[5:])
    about = np.array([Z, E[0], E[2]])  # omega = rates @ about
    omega, turning = rates @ about, rates[0] * Z + rates[1] * E[0]
    about_rate = about @ hat(turning).T * [[0.0], [1.0], [1.0]]
    moves, e2_rate = radius * about @ hat(E[1]), hat(turning) @ E[1]
    moves_rate = radius * (about_rate @ hat(E[1]) + about @ hat(e2_rate))
    tensor = inertia[0] * np.eye(3) + (inertia[1] - inertia[0]) * np.outer(E[2], E[2])
    force = mass * (gravity * Z + rates @ moves_rate)
    moment = tensor @ (rates @ about_rate) + hat(omega) @ (tensor @ omega)
    second = np.linalg.solve(mass * moves @ moves.T + about @ tensor @ about.T, -moves @ force - about @ moment)
    return second, second @ about + rates @ about_rate, second @ moves + rates @ moves_rate


def euler_state_derivative(_, state, **disk):
    return np.concatenate([contact_velocity(state, disk["radius"]), state[5:], jourdain(state, **disk)[0]])


def contact_velocity(state, radius):
    return -radius * state[7] * math.cos(state[2]), -radius * state[7] * math.sin(state[2])


def matrix_state_derivative(_, state, **disk):
    radius, w = disk["radius"], hat(state[OMEGA])
    euler = euler_state(state, radius)
    velocity = radius * w @ frame(euler)[1]
    return np.concatenate([velocity, (w @ attitude(euler)).ravel(), jourdain(euler, **disk)[1]])


multiplier_state_derivative = matrix_state_derivative


def energy(state, *, mass, radius, inertia, gravity):
    w = np.array(components(state)[:3])
    velocity = radius * np.array([-w[2], 0.0, w[0]])
    turning = np.array([inertia[0], inertia[0], inertia[1]]) @ w**2
    return 0.5 * (mass * velocity @ velocity + turning) + mass * gravity * radius * math.sin(state[3])


def contact_force(state, **disk):
    return disk["mass"] * (jourdain(state, **disk)[2] + disk["gravity"] * Z)


# Motions


def rates_along_the_frame(state, *, mass, radius, inertia, gravity):
    """Rates of the Euler state, by w1', w2', w3'."""
    (A, C), m = inertia, mass * radius**2
    w1, w2, w3, turn = components(state)
    c, s, yaw_rate = math.cos(state[3]), math.sin(state[3]), state[5]
    tilt_second = (w2 * (A * turn - (C + m) * w3) - mass * gravity * radius * c) / (A + m)
    yaw_second = (w1 * (C * w3 - A * turn) / A - yaw_rate * w1 * c) / s
    roll_second = m * w1 * w2 / (C + m) - yaw_second * c + yaw_rate * w1 * s
    return [*contact_velocity(state, radius), *state[5:], yaw_second, tilt_second, roll_second]


def simulate_euler(t, state, rtol=1e-11, **disk):
    """(n, 8) Euler states; ArithmeticError where the disk falls flat, and the steps never end."""
    calls = itertools.count()

    def rates(_, y):
        if next(calls) > MOST_CALLS:
            raise ArithmeticError("the disk falls flat")
        return rates_along_the_frame(y.tolist(), **disk)

    found = solve_ivp(rates, (t[0], t[-1]), state, method="DOP853", t_eval=t, rtol=rtol, atol=rtol)
    if not found.success:
        raise ArithmeticError(found.message)
    return found.y.T


def simulate_matrix(t, state, **disk):
    """(n, 15) matrix states."""
    radius = disk["radius"]
    return np.array([matrix_state(row, radius) for row in simulate_euler(t, euler_state(state, radius), **disk)])


def energies(rows, **disk):
    return np.array([energy(row, **disk) for row in rows])


def energy_at_the_start(case, rows):
    return energy(rows[0], **case.kwargs)


def two_integrals(rows, *, mass, radius, inertia, gravity):
    """(n, 2): w2 and w3 carried to the upright disk by their linear equations in the tilt (Appell, Korteweg)."""
    (A, C), m = inertia, mass * radius**2

    def rates(tilt, w):
        w2, w3 = w.reshape(2, 2)
        return np.concatenate([C / A * w3 - w2 / math.tan(tilt), m / (C + m) * w2])

    def carried(row):
        span = (RIGHT, row[3])
        basis = solve_ivp(rates, span, np.eye(2).ravel(), method="DOP853", rtol=1e-11, atol=1e-12).y[:, -1]
        return np.linalg.solve(basis.reshape(2, 2), components(row)[1:3])

    return np.array([carried(row) for row in rows])


def not_a_rotation(rows, **_):
    """(n, 3, 3): R^T R."""
    R = rows[:, MATRIX].reshape(-1, 3, 3)
    return R.transpose(0, 2, 1) @ R


def above_the_ground(rows, *, radius, **_):
    """(n,) m: the height of the centre over that of a disk on the ground."""
    return rows[:, 2] - radius * np.hypot(rows[:, 5], rows[:, 8])


# Steady and nearly upright


def steady_state(lean, precession, spin):
    """The Euler state of hw11's motion."""
    tilt = lean + RIGHT
    return np.array([0, 0, 0, tilt, 0, precession, 0, spin - precession * math.cos(tilt)])


def steady_residual(lean, precession, spin, **disk):
    return jourdain(steady_state(lean, precession, spin), **disk)[0][1]


def growth_rate_squared(speed, **disk):
    """d(tilt'')/d(tilt) at w2 = C/A spin d(tilt), the balance about e2; by a five-point difference."""
    spin, h = speed / disk["radius"], 1e-3

    def second(lean):
        yaw_rate = disk["inertia"][1] / disk["inertia"][0] * spin * lean / math.cos(lean)
        return steady_residual(lean, yaw_rate, spin, **disk)

    return (8 * (second(h) - second(-h)) - second(2 * h) + second(-2 * h)) / (12 * h)


def critical_speed(**disk):
    """Where growth, linear in the square of the speed, is zero."""
    unit = usual(disk) * disk["radius"]
    still, moving = growth_rate_squared(0.0, **disk), growth_rate_squared(unit, **disk)
    return unit * math.sqrt(still / (still - moving))


def usual(disk):
    """Size of angular rates, rad/s."""
    return math.sqrt((disk["gravity"] or 10.0) / disk["radius"])


# The picture


def turned(angles, by):
    """Angles less a whole number of `by`, between -by/2 and by/2."""
    return (angles + by / 2) % by - by / 2


def in_the_disk(points, state, radius):
    """Angles of points in the body's plane, and how far the points are from the rim, m."""
    body = (points - matrix_state(state, radius)[CENTRE]) @ attitude(state)
    return np.arctan2(body[..., 1], body[..., 0]), np.hypot(np.hypot(body[..., 0], body[..., 1]) - radius, body[..., 2])
