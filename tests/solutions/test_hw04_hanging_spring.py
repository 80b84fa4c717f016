"""hw04: the reference against 50 digits of mpmath, against SymPy, and against its own laws."""

import math

import mpmath
import numpy as np
import pytest
import sympy

from tam570_grader.checks import assignments

hw = assignments.solution("hw04_hanging_spring")
DRAW = np.random.default_rng(4)
SPRING = {"mass": 2.3, "stiffness": 7.1, "gravity": 9.3}  # kg, N/m, m/s^2
K = math.sqrt(7.1 / 2.3)  # 1/s
SAG = 2.3 * 9.3 / 7.1  # m
POSITION, VELOCITY = np.array([1.3, -0.4, 0.9]), np.array([-2.0, 3.1, 0.7])  # m, m/s
ROUNDINGS = 1e-13  # relative to the largest term


@pytest.fixture(autouse=True)
def fifty_digits():
    with mpmath.workdps(50):
        yield


def springs(number):
    """Masses and stiffnesses over twelve decades, with and without gravity."""
    return [
        {
            "mass": 10 ** DRAW.uniform(-6, 6),
            "stiffness": 10 ** DRAW.uniform(-6, 6),
            "gravity": DRAW.uniform(1, 30) * (i % 3 > 0),
        }
        for i in range(number)
    ]


def starts(known):
    """A random position, and a velocity that matters as much."""
    rate = math.sqrt(known["stiffness"] / known["mass"])
    return DRAW.normal(size=3), DRAW.normal(size=3) * rate, rate


def motion(time, position, velocity, known):
    """The state at a time, and the size of its largest term, in mpmath."""
    mass, stiffness, gravity = (mpmath.mpf(x) for x in known.values())
    rate, time = mpmath.sqrt(stiffness / mass), mpmath.mpf(time)
    c, s = mpmath.cos(rate * time), mpmath.sin(rate * time)
    weight = [0, 0, -gravity]
    # 1/s to m: what is rounded is the phase, by eps of itself, so the size grows with it
    growth = 1 + abs(rate * time)
    places, speeds = [], []
    for p, v, w in zip(position, velocity, weight, strict=True):
        p, v = mpmath.mpf(p), mpmath.mpf(v)
        places.append((p * c + v / rate * s + w / rate**2 * (1 - c), abs(p * c) + abs(v / rate * s) + abs(p)))
        speeds.append((v * c - p * rate * s + w / rate * s, abs(v) + abs(p * rate) + abs(w / rate * s)))
    return [(value, growth * (size + abs(value))) for value, size in places + speeds]


@pytest.mark.parametrize("known", springs(12))
def test_the_solution_has_full_digits(known):
    """Route: the same in mpmath; short times too, at which a soft spring hardly differs from free fall."""
    position, velocity, rate = starts(known)
    t = np.array([0.0, *10 ** DRAW.uniform(-6, 1, 8)]) / rate
    for row, time in zip(hw.solution(t, position, velocity, **known), t, strict=True):
        for found, (expected, scale) in zip(row, motion(time, position, velocity, known), strict=True):
            assert abs(found - expected) <= ROUNDINGS * scale


def test_a_soft_spring_is_free_fall():
    """Limit: k = 1e-12 N/m; the equilibrium is 1e13 m below."""
    found = hw.solution(np.array([0.7]), POSITION, VELOCITY, mass=1.0, stiffness=1e-12, gravity=9.3)[0]
    fall = [*(POSITION + VELOCITY * 0.7 - [0, 0, 9.3 * 0.7**2 / 2]), *(VELOCITY - [0, 0, 9.3 * 0.7])]
    np.testing.assert_allclose(found, fall, rtol=1e-11)  # k t^2/m = 1e-12


def test_the_solution_solves_the_equation():
    """Route: SymPy differentiates twice what mpmath was given."""
    t, r, v, m, k, g = sympy.symbols("t r v m k g", positive=True)
    w = sympy.sqrt(k / m)
    z = r * sympy.cos(w * t) + v / w * sympy.sin(w * t) - g / w**2 * (1 - sympy.cos(w * t))
    assert sympy.simplify(m * z.diff(t, 2) + k * z + m * g) == 0
    assert (z.subs(t, 0), z.diff(t).subs(t, 0)) == (r, v)


def test_the_derivative_is_that_of_the_solution():
    """Route: differences of the closed form, of eighth order."""
    step, weights = 0.02 / K, {1: 4 / 5, 2: -1 / 5, 3: 4 / 105, 4: -1 / 280}
    for time in DRAW.uniform(-5, 5, 10):
        states = {n: hw.solution(np.array([time + n * step]), POSITION, VELOCITY, **SPRING)[0] for n in range(-4, 5)}
        slope = sum(w * (states[n] - states[-n]) for n, w in weights.items()) / step
        found = hw.state_derivative(time, states[0], **SPRING)
        np.testing.assert_allclose(found, slope, rtol=0, atol=1e-11 * K * np.abs(states[0]).max() * 5)


def test_the_energy_is_that_of_its_terms():
    """Route: work done by hand against both forces along a straight path, in mpmath."""
    for known in springs(10):
        state = DRAW.normal(size=6)
        mass, stiffness, gravity = (mpmath.mpf(x) for x in known.values())
        r, v = ([mpmath.mpf(x) for x in part] for part in (state[:3], state[3:]))
        work = mpmath.quad(
            lambda s, r=r, k=stiffness, w=mass * gravity: s * k * sum(x * x for x in r) + w * r[2], [0, 1]
        )
        motion_energy = mass * sum(x * x for x in v) / 2
        scale = motion_energy + stiffness * sum(x * x for x in r) / 2 + abs(mass * gravity * r[2])
        assert abs(hw.energy(state, **known) - (work + motion_energy)) <= ROUNDINGS * scale


@pytest.mark.parametrize("periods", [20, pytest.param(1000, marks=pytest.mark.slow)])
@pytest.mark.parametrize("known", [SPRING, {**SPRING, "gravity": 0.0}, *springs(4)])
def test_the_invariants_stay(known, periods):
    """Energy, the angular momentum about the centre, and the oscillator's tensor, along the simulation."""
    position, velocity, rate = starts(known)
    t = np.cumsum(DRAW.uniform(0.1, 1.9, 300))
    t *= periods * 2 * math.pi / rate / t[-1]
    states = hw.simulate(t, position, velocity, **known)
    assert np.all(states[0] == [*position, *velocity])
    r, v = states[:, :3] + [0, 0, known["gravity"] / rate**2], states[:, 3:]
    tensor = r[:, :, None] * r[:, None] + v[:, :, None] * v[:, None] / rate**2
    spin = np.cross(r, v) / rate
    size = np.trace(tensor[0])
    np.testing.assert_allclose(tensor, np.broadcast_to(tensor[0], tensor.shape), rtol=0, atol=1e-11 * size)
    np.testing.assert_allclose(spin, np.broadcast_to(spin[0], spin.shape), rtol=0, atol=1e-11 * size)
    energies = np.array([hw.energy(state, **known) for state in states])
    assert np.ptp(energies) <= 1e-11 * known["stiffness"] * size


def test_the_simulation_is_the_solution_however_it_is_sampled():
    t = np.cumsum(DRAW.uniform(0.01, 1, 200)) - 7.0
    many = hw.simulate(t, POSITION, VELOCITY, **SPRING)
    expected = hw.solution(t - t[0], POSITION, VELOCITY, **SPRING)
    np.testing.assert_allclose(many, expected, rtol=0, atol=1e-11 * np.abs(expected).max())
    few = hw.simulate(t[[0, 77, -1]], POSITION, VELOCITY, **SPRING)
    np.testing.assert_allclose(few, many[[0, 77, -1]], rtol=0, atol=1e-11 * np.abs(expected).max())


def test_every_start_has_the_same_period():
    for _ in range(5):
        position, velocity = DRAW.normal(size=(2, 3)) * 10 ** DRAW.uniform(-3, 3)
        back = hw.simulate(np.array([0.0, 2 * math.pi / K]), position, velocity, **SPRING)[1]
        size = np.linalg.norm(position) + np.linalg.norm(velocity) + SAG
        np.testing.assert_allclose(back, [*position, *velocity], rtol=0, atol=1e-12 * size)


def test_at_rest_in_equilibrium_it_stays():
    rest = np.array([0.0, 0.0, -SAG])
    states = hw.simulate(np.linspace(0, 100, 5), rest, np.zeros(3), **SPRING)
    np.testing.assert_allclose(states, np.tile([*rest, 0, 0, 0], (5, 1)), rtol=0, atol=1e-14 * SAG)


# The ellipse

ORBITS = {
    "general": (POSITION, VELOCITY),
    "circle": (np.array([2.0, 0, -SAG]), np.array([0, 2.0 * K, 0])),
    "nearly a line": (np.array([2.0, 0, -SAG]), np.array([3.0, 1e-9, 0])),
    "line": (np.array([0.3, -1.0, 0.5]), np.zeros(3)),
    "line through the centre": (np.array([0.0, 0.0, -SAG]), VELOCITY),
    "vertical line": (np.array([0.0, 0.0, 1.0]), np.array([0.0, 0.0, -3.0])),
    "point": (np.array([0.0, 0.0, -SAG]), np.zeros(3)),
}


@pytest.mark.parametrize(("position", "velocity"), ORBITS.values(), ids=ORBITS.keys())
def test_every_point_is_on_the_ellipse(position, velocity):
    """Route: the points' components along the axes, over the axes, are cosine and sine."""
    centre, (a, b) = hw.orbit(position, velocity, **SPRING)
    assert centre.tolist() == [0, 0, pytest.approx(-SAG, rel=1e-15)]
    size = np.linalg.norm(a) + 1e-16 * SAG
    assert abs(a @ b) <= 1e-14 * size**2 and a @ a >= b @ b
    from_centre = hw.solution(np.linspace(0, 7, 50), position, velocity, **SPRING)[:, :3] - centre
    components = np.zeros((50, 2))
    for i, axis in enumerate((a, b)):
        length = np.linalg.norm(axis)
        if length > 1e-12 * SAG:
            components[:, i] = from_centre @ axis / length**2
    tolerance = 1e-13 * (size + SAG)
    np.testing.assert_allclose(components @ [a, b], from_centre, rtol=0, atol=tolerance)
    if np.linalg.norm(b) > 1e-6:
        np.testing.assert_allclose(np.sum(components**2, axis=1), 1, rtol=1e-12)


def test_the_axes_are_eigenvectors_of_the_tensor():
    """Route: eigenvalues in mpmath."""
    for known in springs(10):
        position, velocity, _ = starts(known)
        mass, stiffness, gravity = (mpmath.mpf(x) for x in known.values())
        centre = mpmath.matrix([0, 0, -mass * gravity / stiffness])
        r, v = mpmath.matrix(position.tolist()) - centre, mpmath.matrix(velocity.tolist())
        values, _ = mpmath.eigsy(r * r.T + v * v.T * mass / stiffness)
        _, axes = hw.orbit(position, velocity, **known)
        size = mpmath.sqrt(values[2])
        for axis, value in zip(axes, (values[2], values[1]), strict=True):
            assert abs(np.linalg.norm(axis) - mpmath.sqrt(value)) <= ROUNDINGS * size


def test_a_line_has_one_axis_and_a_point_none():
    for label, zero in (("line", 1), ("line through the centre", 1), ("vertical line", 1), ("point", 2)):
        _, axes = hw.orbit(*ORBITS[label], **SPRING)
        assert np.sum(np.linalg.norm(axes, axis=1) < 1e-15 * SAG) == zero


# The picture


def test_the_projection_is_that_of_a_turned_frame():
    """Route: the eye's frame completed to a rotation; lengths across the line of sight are kept."""
    for _ in range(10):
        azimuth, elevation = DRAW.uniform(-9, 9, 2)
        columns = hw.project(np.eye(3), azimuth, elevation)
        eye = [math.cos(elevation) * math.cos(azimuth), math.cos(elevation) * math.sin(azimuth), math.sin(elevation)]
        frame = np.column_stack([columns, eye])
        np.testing.assert_allclose(frame.T @ frame, np.eye(3), atol=1e-15)
        assert np.linalg.det(frame) == pytest.approx(1, abs=1e-15)


def test_the_picture_shows_the_path():
    from matplotlib.figure import Figure

    ax = Figure().add_subplot()
    t = np.linspace(0, 3, 40)
    assert hw.plot_projection(ax, t, POSITION, VELOCITY, 0.4, 0.2, **SPRING) is None
    expected = hw.project(hw.solution(t, POSITION, VELOCITY, **SPRING)[:, :3], 0.4, 0.2)
    np.testing.assert_allclose(ax.lines[0].get_xydata(), expected, atol=1e-11)
    assert (ax.get_xlabel(), ax.get_ylabel(), ax.get_aspect()) == ("right (m)", "up (m)", 1.0)
