"""hw04: A mass that hangs on a zero-rest-length spring.

figure.svg, beside this file, shows the axes, the names and the positive senses.

The spring is hung at the origin and pulls the mass there with stiffness times distance; z points up and gravity acts
along -z. A state is (x, y, z, vx, vy, vz). The potential energy is zero at the origin.

Off limits in this file: tam570.lectures, which would answer it.
"""

import numpy as np

__all__ = [
    "energy",
    "free_body_diagram",
    "orbit",
    "plot_projection",
    "project",
    "simulate",
    "solution",
    "state_derivative",
]


def free_body_diagram(state, *, mass, stiffness, gravity):
    """The forces on the mass, cut free from the spring.

    state     : (6,) position in m, velocity in m/s
    mass      : kg
    stiffness : N/m, > 0
    gravity   : m/s^2, may be 0
    Returns a list of pairs (point, direction), one for each force: where it acts, (3,) in m, and a vector (3,) of any
    length along which it acts, or None where no component is known. The order is free.
    """
    x, y, z, _, _, _ = state
    return [((x, y, z), (0.0, 0.0, -1.0)), ((x, y, z), (-x, -y, -z))]


def state_derivative(t, state, *, mass, stiffness, gravity):
    """Rates of the state.

    t         : s, not used
    state     : (6,) position in m, velocity in m/s
    mass      : kg
    stiffness : N/m, > 0
    gravity   : m/s^2, may be 0
    Returns (6,): velocity, acceleration.
    """
    x, y, z, vx, vy, vz = state
    k = stiffness / mass
    return vx, vy, vz, -k * x, -k * y, -k * z - gravity


def simulate(t, position, velocity, *, mass, stiffness, gravity):
    """Motion by numerical integration from position and velocity at t[0].

    t         : (n,) s, strictly increasing, n >= 2; its sampling does not change the motion
    position  : (3,) m
    velocity  : (3,) m/s
    mass      : kg
    stiffness : N/m, > 0
    gravity   : m/s^2, may be 0
    Returns (n, 6); row i is the state at t[i].
    """
    from tam570.integrate import solve

    parameters = {"mass": mass, "stiffness": stiffness, "gravity": gravity}
    return solve(state_derivative, t, (*position, *velocity), parameters=parameters, rtol=1e-13)


def solution(t, position, velocity, *, mass, stiffness, gravity):
    """The same motion in closed form, position and velocity being those at t = 0.

    t         : (n,) s
    position  : (3,) m
    velocity  : (3,) m/s
    mass      : kg
    stiffness : N/m, > 0
    gravity   : m/s^2, may be 0
    Returns (n, 6).
    """
    k = np.sqrt(stiffness / mass)
    c, s, h = (f[:, None] for f in (np.cos(k * t), np.sin(k * t), np.sin(k * t / 2)))
    down = np.array([0.0, 0.0, -gravity])
    # 1 - cos is 2 h^2: about the origin, not the equilibrium far below, a soft spring costs no digits
    r = position * c + velocity / k * s + down / k**2 * 2 * h**2
    v = velocity * c - position * k * s + down / k * s
    return np.hstack([r, v])


def energy(state, *, mass, stiffness, gravity):
    """Kinetic plus potential energy, of the spring and of the weight.

    state     : (6,) position in m, velocity in m/s
    mass      : kg
    stiffness : N/m, > 0
    gravity   : m/s^2, may be 0
    Returns J; zero for a mass at rest at the origin.
    """
    x, y, z, vx, vy, vz = state
    kinetic = mass * (vx**2 + vy**2 + vz**2) / 2
    return kinetic + stiffness * (x**2 + y**2 + z**2) / 2 + mass * gravity * z


def orbit(position, velocity, *, mass, stiffness, gravity):
    """The ellipse on which the mass moves. A line or a point is an ellipse with zero axes.

    position  : (3,) m, at any time
    velocity  : (3,) m/s, then
    mass      : kg
    stiffness : N/m, > 0
    gravity   : m/s^2, may be 0
    Returns (centre, semi_axes): (3,) and (2, 3) in m; the larger semi-axis first, the other perpendicular to it,
    each in one of its two directions; of a circle any two perpendicular radii.
    """
    centre = np.array([0.0, 0.0, -mass * gravity / stiffness])
    # r - centre = p cos kt + q sin kt: the unit circle mapped by the rows p, q, whose singular vectors are the axes
    conjugate = np.array([position - centre, velocity * np.sqrt(mass / stiffness)])
    _, lengths, directions = np.linalg.svd(conjugate, full_matrices=False)
    return centre, lengths[:, None] * directions


def project(points, azimuth, elevation):
    """Orthographic picture of points, seen from the direction of azimuth and elevation.

    points    : (n, 3) m
    azimuth   : rad, of the eye, from the x axis
    elevation : rad, of the eye, from the x-y plane
    Returns (n, 2) m: to the right along (-sin az, cos az, 0), up along (-sin el cos az, -sin el sin az, cos el).
    """
    ca, sa, ce, se = np.cos(azimuth), np.sin(azimuth), np.cos(elevation), np.sin(elevation)
    return points @ np.array([[-sa, ca, 0.0], [-se * ca, -se * sa, ce]]).T


def plot_projection(ax, t, position, velocity, azimuth, elevation, *, mass, stiffness, gravity):
    """Draw the simulated path, projected, as one line.

    ax        : Matplotlib Axes to draw on
    t         : (n,) s, strictly increasing
    position  : (3,) m, at t[0]
    velocity  : (3,) m/s, at t[0]
    azimuth   : rad
    elevation : rad
    mass      : kg
    stiffness : N/m, > 0
    gravity   : m/s^2, may be 0
    """
    parameters = {"mass": mass, "stiffness": stiffness, "gravity": gravity}
    states = simulate(t, position, velocity, **parameters)
    ax.plot(*project(states[:, :3], azimuth, elevation).T)
    ax.set(xlabel="right (m)", ylabel="up (m)", aspect="equal")
