"""hw04's solution and its ellipse, against fifty digits, over twelve decades of masses and stiffnesses."""

import math

import mpmath
import numpy as np
import pytest

from tam570_grader.checks import assignments

hw = assignments.solution("hw04_hanging_spring")
DRAW = np.random.default_rng(4)
SPRING = {"mass": 2.3, "stiffness": 7.1, "gravity": 9.3}  # kg, N/m, m/s^2
K = math.sqrt(7.1 / 2.3)  # 1/s
SAG = 2.3 * 9.3 / 7.1  # m
POSITION, VELOCITY = np.array([1.3, -0.4, 0.9]), np.array([-2.0, 3.1, 0.7])  # m, m/s
ROUNDINGS = 1e-13  # relative to the largest term


def springs(number):
    """Springs, one in three without gravity, a random position, and a velocity that matters as much."""
    for i in range(number):
        mass, stiffness = 10 ** DRAW.uniform(-6, 6, 2)
        spring = {"mass": mass, "stiffness": stiffness, "gravity": DRAW.uniform(1, 30) * (i % 3 > 0)}
        yield spring, DRAW.normal(size=3), DRAW.normal(size=3) * math.sqrt(stiffness / mass)


def motion(time, position, velocity, spring):
    """The state at a time, and the size of its largest term, in mpmath."""
    mass, stiffness, gravity = (mpmath.mpf(x) for x in spring.values())
    rate, time = mpmath.sqrt(stiffness / mass), mpmath.mpf(time)
    c, s = mpmath.cos(rate * time), mpmath.sin(rate * time)
    # what is rounded is the phase, by eps of itself, so the size grows with it
    growth = 1 + abs(rate * time)
    positions, speeds = [], []
    for p, v, w in zip(position, velocity, [0, 0, -gravity], strict=True):
        p, v = mpmath.mpf(p), mpmath.mpf(v)
        positions.append((p * c + v / rate * s + w / rate**2 * (1 - c), abs(p * c) + abs(v / rate * s) + abs(p)))
        speeds.append((v * c - p * rate * s + w / rate * s, abs(v) + abs(p * rate) + abs(w / rate * s)))
    return [(value, growth * (size + abs(value))) for value, size in positions + speeds]


def test_the_solution_has_full_digits():
    """Route: the same in mpmath; short times too, at which a soft spring hardly differs from free fall."""
    for spring, position, velocity in springs(12):
        t = np.array([0.0, *10 ** DRAW.uniform(-6, 1, 8)]) / math.sqrt(spring["stiffness"] / spring["mass"])
        for row, time in zip(hw.solution(t, position, velocity, **spring), t, strict=True):
            for result, (expected, scale) in zip(row, motion(time, position, velocity, spring), strict=True):
                assert abs(result - expected) <= ROUNDINGS * scale


ORBITS = {  # position, velocity, and how many of the axes are zero
    "general": (POSITION, VELOCITY, 0),
    "circle": (np.array([2.0, 0, -SAG]), np.array([0, 2.0 * K, 0]), 0),
    "nearly a line": (np.array([2.0, 0, -SAG]), np.array([3.0, 1e-9, 0]), 0),
    "line": (np.array([0.3, -1.0, 0.5]), np.zeros(3), 1),
    "line through the centre": (np.array([0.0, 0.0, -SAG]), VELOCITY, 1),
    "vertical line": (np.array([0.0, 0.0, 1.0]), np.array([0.0, 0.0, -3.0]), 1),
    "point": (np.array([0.0, 0.0, -SAG]), np.zeros(3), 2),
}


@pytest.mark.parametrize(("position", "velocity", "zeros"), ORBITS.values(), ids=ORBITS.keys())
def test_every_point_is_on_the_ellipse(position, velocity, zeros):
    """Route: the points' components along the axes, over the axes, are cosine and sine."""
    centre, (a, b) = hw.orbit(position, velocity, **SPRING)
    assert centre.tolist() == [0, 0, pytest.approx(-SAG, rel=1e-15)]
    size, lengths = np.linalg.norm(a) + 1e-16 * SAG, np.linalg.norm([a, b], axis=1)
    assert abs(a @ b) <= 1e-14 * size**2 and a @ a >= b @ b
    assert np.sum(lengths < 1e-15 * SAG) == zeros
    from_centre = hw.solution(np.linspace(0, 7, 50), position, velocity, **SPRING)[:, :3] - centre
    components = np.zeros((50, 2))
    for i, axis in enumerate((a, b)[: 2 - zeros]):
        components[:, i] = from_centre @ axis / lengths[i] ** 2
    np.testing.assert_allclose(components @ [a, b], from_centre, rtol=0, atol=1e-13 * (size + SAG))
    if lengths[1] > 1e-6:
        np.testing.assert_allclose(np.sum(components**2, axis=1), 1, rtol=1e-12)
