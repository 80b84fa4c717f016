"""The motions of the solutions conserve energy, momenta and constraints to 1e-11 of their sizes, from any start.

Each function simulates a motion for some periods and returns its invariants divided by their sizes, a row per time.
"""

import math

import numpy as np
import pytest

from tam570.invariants import rotation_defect
from tam570_grader.checks import assignments

KEPT = 1e-11
NEXT_TO_TOP = math.pi - 1e-8  # rad
SHAPES = {"disk": (0.25, 0.5), "hoop": (0.5, 1.0), "wheel": (0.61, 0.87), "roller": (4.0, 0.5)}  # A, C over m a^2
# Not run for 1000 periods: weightless bars lose 1.3e-11 in 1000 s; down a ramp, phi grows as the square of time.
FAST = {"hw07-weightless", "hw13-down a ramp", "hw13-small and heavy"}


def uneven(periods, rate):
    """Return 301 uneven times, s, from 3 s on, over `periods` periods of a motion with angular frequency `rate`."""
    steps = np.random.default_rng(570).uniform(0.1, 1.9, 300)
    return 3.0 + np.concatenate([[0.0], np.cumsum(steps) / steps.sum()]) * periods * 2 * math.pi / rate


def pendulum(periods, theta, omega, length=1.7, gravity=9.3):
    hw, k = assignments.solution("hw01_simple_pendulum"), math.sqrt(gravity / length)
    theta, omega = hw.simulate(uneven(periods, k), theta, omega * k, length=length, gravity=gravity).T
    energy = (omega / k) ** 2 / 2 + 2 * np.sin(theta / 2) ** 2
    return energy[:, None] / energy[0]


def spring(periods, mass, stiffness, gravity):
    """Return the oscillator's tensor, whose trace is the energy, the angular momentum about the centre, the energy."""
    hw, k = assignments.solution("hw04_hanging_spring"), math.sqrt(stiffness / mass)
    position, velocity = np.array([1.3, -0.4, 0.9]), np.array([-0.7, 1.1, 0.3]) * k
    parameters = {"mass": mass, "stiffness": stiffness, "gravity": gravity}
    states = hw.simulate(uneven(periods, k), position, velocity, **parameters)
    r, v = states[:, :3] + [0, 0, gravity / k**2], states[:, 3:] / k
    tensor = r[:, :, None] * r[:, None] + v[:, :, None] * v[:, None]
    energy = [hw.energy(state, **parameters) / stiffness for state in states]
    return np.column_stack([tensor.reshape(-1, 9), np.cross(r, v), energy]) / np.trace(tensor[0])


def circle(periods, theta, omega, length=1.7, gravity=9.3):
    """Return x^2 + y^2, the radial velocity and the energy; assert that the first two are 1 and 0 to 1e-12."""
    hw, k = assignments.solution("hw05_constrained_pendulum"), math.sqrt(gravity / length)
    c, s = math.cos(theta), math.sin(theta)
    start = length * np.array([s, -c, omega * k * c, omega * k * s])
    states = hw.simulate(uneven(periods, k), start, mass=2.3, length=length, gravity=gravity)
    x, y, vx, vy = states.T
    size, speed = gravity * length + np.max(vx**2 + vy**2), np.hypot(vx, vy).max()
    energy = [hw.energy(state, mass=1.0, gravity=gravity) / size for state in states]
    on_circle, tangent = (x**2 + y**2) / length**2, (x * vx + y * vy) / (length * speed)
    np.testing.assert_allclose(np.column_stack([on_circle, tangent]), [[1.0, 0.0]] * len(states), rtol=0, atol=1e-12)
    return np.column_stack([on_circle, tangent, energy])


def bars(periods, theta, omega, masses=(1.3, 0.7), lengths=(0.9, 1.6), gravity=9.81):
    """Return the energy, and without gravity the angular momentum, too."""
    hw = assignments.solution("hw07_double_pendulum")
    both = {"masses": np.array(masses), "lengths": np.array(lengths)}
    states = hw.simulate(uneven(periods, 2 * math.pi), theta, omega, **both, gravity=gravity)
    energy = [hw.energy(state[:2], state[2:], **both, gravity=gravity) for state in states]
    size = gravity * sum(masses) * sum(lengths) + abs(energy[0])
    if gravity:
        return np.array(energy)[:, None] / size
    momenta = [hw.angular_momentum(state[:2], state[2:], **both) for state in states]
    return np.column_stack([np.array(energy) / size, np.array(momenta) / abs(momenta[0])])


def body(periods, omega, inertia=(1.0, 2.0, 2.7)):
    """Return the energy and the angular momentum in space; assert that R stays a rotation."""
    hw, inertia = assignments.solution("hw10_free_rigid_body"), np.array(inertia)
    R = np.linalg.qr(np.random.default_rng(10).normal(size=(3, 3)))[0]
    omegas, rotations = hw.simulate(uneven(periods, 2 * math.pi), R * np.linalg.det(R), omega, inertia=inertia)
    energy = [hw.energy(w, inertia=inertia) for w in omegas]
    momenta = [hw.angular_momentum(*both, inertia=inertia) for both in zip(rotations, omegas, strict=True)]
    assert rotation_defect(rotations).max() <= KEPT
    return np.column_stack([np.array(energy) / energy[0], np.array(momenta) / np.linalg.norm(momenta[0])])


def bead(periods, steepness, curvature=0.37, gravity=9.3, way=1.0):
    """Return the energy; the bead starts at `way` times its amplitude, steepness/curvature, at rest if `way` is 1."""
    hw, rate = assignments.solution("hw12_bead_on_wire"), math.sqrt(2 * curvature * gravity)
    amplitude, wire = steepness / curvature, {"curvature": curvature, "gravity": gravity}
    x, period = way * amplitude, hw.period(amplitude, **wire)
    v = amplitude * math.sqrt(1 - way**2) * rate / math.hypot(1, 2 * curvature * x)
    states = hw.simulate(uneven(periods / 4, 2 * math.pi / period), x, v, **wire)
    energy = hw.energy(*states.T, mass=2.0, **wire)
    return energy[:, None] / energy[0]


def cylinder(periods, phi, rate, mass=2.0, radius=0.5, offset=0.4, inertia=0.3, slope=0.3, gravity=9.3):
    hw, k = assignments.solution("hw13_rolling_cylinder"), math.sqrt(gravity / radius)
    parameters = {"mass": mass, "radius": radius, "offset": offset * radius, "inertia": inertia * mass * radius**2}
    parameters |= {"slope": slope, "gravity": gravity}
    states = hw.simulate(uneven(periods / 4, k), phi, rate * k, **parameters)
    energy = np.array([hw.energy(*state, **parameters) for state in states])
    return energy[:, None] / (mass * gravity * radius * np.abs(states[:, 0]).max())


def disk(periods, start, shape="disk", mass=1.7, radius=0.45, gravity=9.81):
    """Return the energy by angles; assert that the simulation by matrices keeps R^T R and the height of the centre."""
    hw = assignments.solution("hw14_rolling_disk")
    parameters = {"mass": mass, "radius": radius, "gravity": gravity}
    parameters["inertia"] = tuple(k * mass * radius**2 for k in SHAPES[shape])
    t = uneven(periods / 2, 2 * math.pi)[::20]
    angles = hw.simulate_euler(t, start, **parameters)
    by_matrix = hw.simulate_matrix(t, hw.matrix_state(np.array(start), radius=radius), **parameters)
    R = by_matrix[:, 3:12].reshape(-1, 3, 3)
    height = by_matrix[:, 2] / radius - np.hypot(R[:, 0, 2], R[:, 1, 2])
    assert max(rotation_defect(R).max(), np.abs(height).max()) <= 10 * KEPT
    energy = np.array([hw.energy(state, **parameters) for state in angles])
    return energy[:, None] / energy[0]


def shuddering(tilt=1e-3, kick=0.1, mass=1.7, radius=0.45, gravity=9.81):
    """Return the start of a nearly flat coin: the motion of hw11 that both rolls and slides, with a kick."""
    yaw_rate = math.sqrt(gravity / (SHAPES["disk"][0] * radius * math.sin(tilt)))
    return [0, 0, 0, tilt, 0, yaw_rate, kick * tilt * yaw_rate, -yaw_rate * math.cos(tilt)]


ROLLING = [0.1, 0.2, 0.3, 1.4, 0.5, 0.4, 0.2, -18.0]
MOTIONS = {
    "hw01-tiny": (pendulum, 1e-8, 0.0),
    "hw01-large": (pendulum, 2.5, 0.3),
    "hw01-next to the top": (pendulum, NEXT_TO_TOP, 0.0),
    "hw01-on the separatrix": (pendulum, 0.0, 2.0),
    "hw01-turning fast": (pendulum, 40.0, 26.0),
    "hw01-a short rod": (pendulum, 2.5, 0.3, 1e-6, 1e3),
    "hw01-a long rod": (pendulum, 7.0, -3.0, 1e6, 1e-6),
    "hw04-usual": (spring, 2.3, 7.1, 9.3),
    "hw04-weightless": (spring, 2.3, 7.1, 0.0),
    "hw04-soft": (spring, 1e6, 1e-6, 9.3),
    "hw04-stiff": (spring, 1e-6, 1e6, 30.0),
    "hw05-small": (circle, 1e-3, 0.0),
    "hw05-swinging": (circle, 2.0, 0.3),
    "hw05-next to the top": (circle, math.pi - 1e-6, 0.0),
    "hw05-turning fast": (circle, 3.0, 30.0),
    "hw05-short": (circle, 2.0, 0.3, 1e-3),
    "hw05-long": (circle, -0.5, -2.3, 1e3),
    "hw07-from horizontal": (bars, np.full(2, math.pi / 2), np.zeros(2), (1.0, 1.0), (1.0, 1.0)),
    "hw07-weightless": (bars, np.array([1.1, -2.3]), np.array([-1.7, 2.9]), (1.3, 0.7), (0.9, 1.6), 0.0),
    "hw07-a heavy tip": (bars, np.array([2.9, -1.3]), np.zeros(2), (0.4, 3.0), (2.5, 0.4)),
    "hw10-usual": (body, (0.7, -1.1, 0.9)),
    "hw10-next to the separatrix": (body, (0.0, 1.0, 1e-12)),
    "hw10-middle axis": (body, (0.01, 1.0, 0.02)),
    "hw10-light": (body, (0.7, -1.1, 0.9), (1e-6, 2e-6, 2.7e-6)),
    "hw10-heavy": (body, (0.7, -1.1, 0.9), (2.7e6, 1e6, 2e6)),
    "hw10-disk": (body, (0.7, -1.1, 0.9), (0.3, 0.3, 0.6)),
    "hw10-rod": (body, (0.7, -1.1, 0.9), (1.0, 1.0, 1e-6)),
    "hw10-thin plate": (body, (0.0, 1.0, 1e-12), (1e-6, 1.0, 1.0 + 1e-6)),
    "hw10-ball": (body, (0.7, -1.1, 0.9), (0.4, 0.4, 0.4)),
    **{f"hw12-steepness {steepness:g}": (bead, steepness) for steepness in (1e-8, 1e-3, 1.0, 10.0, 1e4)},
    "hw12-on the way": (bead, 1.0, 0.37, 9.3, -0.6),
    "hw12-a narrow wire": (bead, 1.0, 1e6, 1e3),
    "hw12-a wide wire": (bead, 1e4, 1e-6, 1e-6),
    "hw13-down a ramp": (cylinder, 1.0, 1.0),
    "hw13-rocking": (cylinder, 2.0, 0.0, 2.0, 0.5, 0.9, 0.05, 0.0),
    "hw13-small and heavy": (cylinder, -3.0, 1.0, 1e6, 1e-6, 0.7, 0.9, -1.4, 1e3),
    **{f"hw14-{shape}": (disk, ROLLING, shape) for shape in SHAPES},
    "hw14-a coin that shudders": (disk, shuddering()),
}
LONG = [pytest.param(motion, 1000, marks=pytest.mark.slow) for motion in MOTIONS if motion not in FAST]


@pytest.mark.parametrize(("motion", "periods"), [*((motion, 20) for motion in MOTIONS), *LONG])
def test_what_is_conserved_stays(motion, periods):
    run, *start = MOTIONS[motion]
    assert np.ptp(run(periods, *start), axis=0).max() <= KEPT
