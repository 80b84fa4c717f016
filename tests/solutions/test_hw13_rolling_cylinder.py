"""hw13's reference solution, by other routes: sympy's Lagrange, moments in the plane, quadrature."""

import math

import mpmath
import numpy as np
import pytest
import sympy

from tam570_grader.checks import assignments

hw = assignments.solution("hw13_rolling_cylinder")

DRAW = np.random.default_rng(13)
DIGITS = 1e-13  # relative to the terms; a closed form of a dozen operations in doubles
NAMES = "phi phi_dot mass radius offset inertia slope gravity"


def cylinders(count, **fixed):
    """Any masses and lengths over twelve decades, G anywhere inside the cylinder."""
    for _ in range(count):
        mass, radius = (float(x) for x in 10 ** DRAW.uniform(-6, 6, 2))
        body = {"mass": mass, "radius": radius, "offset": float(radius * DRAW.uniform(0, 1))}
        body["inertia"] = float(mass * radius**2 * DRAW.uniform(0.01, 1))
        yield {**body, "slope": float(DRAW.uniform(-1.5, 1.5)), "gravity": float(10 ** DRAW.uniform(-3, 3)), **fixed}


def motions(cylinder):
    """An angle of several turns and a rate that makes the centripetal terms as large as gravity's."""
    return float(DRAW.uniform(-20, 20)), float(DRAW.normal() * math.sqrt(cylinder["gravity"] / cylinder["radius"]))


def body(cylinder, *more):
    return {name: cylinder[name] for name in ("mass", "radius", "offset", *more)}


def lagrange():
    """phi'' in mpmath, by sympy from T - V of G's position; and the size of its terms."""
    phi, rate, m, r, e, inertia, slope, g = sympy.symbols(NAMES)
    x, y = r * phi - e * sympy.sin(phi), r - e * sympy.cos(phi)
    speed_squared = (sympy.diff(x, phi) ** 2 + sympy.diff(y, phi) ** 2) * rate**2
    T = m * speed_squared / 2 + inertia * rate**2 / 2
    V = m * g * ((y - r) * sympy.cos(slope) - x * sympy.sin(slope))
    momentum = sympy.diff(T, rate)
    force = sympy.diff(T - V, phi) - sympy.diff(momentum, phi) * rate
    symbols = sympy.symbols(NAMES)
    return [sympy.lambdify(symbols, f, "mpmath") for f in (force / sympy.diff(momentum, rate), T + V)]


LAGRANGE, ENERGY = lagrange()


def precisely(formula, motion, cylinder):
    return formula(*map(mpmath.mpf, [*motion, *(cylinder[name] for name in NAMES.split()[2:])]))


def test_acceleration_and_energy_are_lagranges_at_50_digits():
    for cylinder in cylinders(100):
        motion = motions(cylinder)
        expected = precisely(LAGRANGE, motion, cylinder)
        m, r, g = (cylinder[name] for name in ("mass", "radius", "gravity"))
        moments = m * r * (g + r * motion[1] ** 2)  # of gravity and of the centripetal term
        scale = moments / hw.contact_inertia(motion[0], **body(cylinder, "inertia"))
        assert abs(hw.acceleration(*motion, **cylinder) - expected) <= DIGITS * scale
        scale = moments + m * r * g * abs(motion[0])
        assert abs(hw.energy(*motion, **cylinder) - precisely(ENERGY, motion, cylinder)) <= DIGITS * scale


@pytest.mark.parametrize("gap", [1e-6, 1e-9])
def test_contact_inertia_of_an_offset_near_the_radius_keeps_its_digits(gap):
    """r^2 + e^2 - 2 r e cos(phi) by the law of cosines loses them all at phi = 0."""
    radius, offset = 1.7, 1.7 * (1 - gap)
    result = hw.contact_inertia(1e-7, mass=2.0, radius=radius, offset=offset, inertia=0.0)
    r, e = mpmath.mpf(radius), mpmath.mpf(offset)
    assert abs(result / (2 * (r**2 + e**2 - 2 * r * e * mpmath.cos(mpmath.mpf(1e-7)))) - 1) <= DIGITS
