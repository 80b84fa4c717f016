"""Show that the inertia tensor in space axes passes, and arrays without dimensions."""

import numpy as np

X, Y, Z = np.eye(3)


def directions(lean):
    axle = np.array([np.cos(lean), 0.0, -np.sin(lean)])
    return axle, np.cross(axle, Y)  # the second points up along the disk


def tensor(axle, inertia):
    A, C = inertia
    return A * np.eye(3) + (C - A) * np.outer(axle, axle)


def turning(lean, precession, spin):
    axle, upwards = directions(lean)
    return spin * axle + precession * np.dot(Z, upwards) * upwards


def moment_residual(lean, precession, spin, inward, normal, *, mass, radius, inertia):
    axle, upwards = directions(lean)
    H = tensor(axle, inertia) @ turning(lean, precession, spin)
    moment = np.cross(-radius * upwards, inward * X + normal * Z)
    return np.dot(moment - np.cross(precession * Z, H), Y)


def solved(lean, precession, mass, radius, inertia, gravity, rolls):
    """Spin and inward force together."""
    disk = {"mass": mass, "radius": radius, "inertia": inertia}

    def left(spin, inward):
        return moment_residual(lean, precession, spin, inward, mass * gravity, **disk)

    still = left(0.0, 0.0)
    weight = mass * radius * precession if rolls else 0.0
    matrix = [[left(1.0, 0.0) - still, left(0.0, 1.0) - still], [-weight, 1.0]]
    return np.linalg.solve(matrix, [-still, 0.0])


def rolling_spin(lean, precession, *, mass, radius, inertia, gravity):
    return solved(lean, precession, mass, radius, inertia, gravity, True)[0]


def sliding_spin(lean, precession, *, mass, radius, inertia, gravity):
    return solved(lean, precession, mass, radius, inertia, gravity, False)[0]


def rolling_track_radius(lean, precession, **disk):
    spin, radius = rolling_spin(lean, precession, **disk), disk["radius"]
    _, upwards = directions(lean)
    velocity = np.cross(turning(lean, precession, spin), radius * upwards)
    centre = -np.linalg.solve(
        np.array([[0.0, -precession], [precession, 0.0]]), velocity[:2]
    )  # from the centre of the disk to that of the circle
    return np.array(centre[0] + radius * upwards[0])


def sliding_track_radius(lean, *, radius):
    return np.array(radius * directions(lean)[1][0])


def rolling_precession(lean, track_radius, *, mass, radius, inertia, gravity):
    if gravity == 0:  # it can stand still, on any track
        return 0.0
    disk = {"mass": mass, "radius": radius, "inertia": inertia}
    ratio = track_radius / radius - np.sin(lean)
    moving = moment_residual(lean, 1.0, ratio, mass * radius * ratio, 0.0, **disk)
    weight = moment_residual(lean, 0.0, 0.0, 0.0, mass * gravity, **disk)
    if abs(moving) < 1e-14 * mass * radius**2 or -weight / moving < 0:
        raise ValueError("no such motion")
    return np.sqrt(-weight / moving)


def common_precession(lean, *, mass, radius, inertia, gravity):
    return np.sqrt(mass * gravity * radius / inertia[0] / np.cos(lean))


def contact_force(lean, precession, spin, *, mass, radius, gravity):
    velocity = np.cross(turning(lean, precession, spin), radius * directions(lean)[1])
    force = mass * np.cross(precession * Z, velocity) + mass * gravity * Z
    return force[0], force[2]


def settling_energy(lean, *, mass, radius, inertia, gravity):
    omega = common_precession(lean, mass=mass, radius=radius, inertia=inertia, gravity=gravity)
    axle, upwards = directions(lean)
    w = turning(lean, omega, 0.0)
    return 0.5 * w @ tensor(axle, inertia) @ w + mass * gravity * radius * upwards[2]
