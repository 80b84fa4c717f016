"""hw11's reference solution against mpmath at 50 digits."""

import math

import mpmath
import numpy as np
import pytest

from tam570_grader.checks import assignments

hw = assignments.solution("hw11_disk_steady")

DRAW = np.random.default_rng(11)
DIGITS = 1e-13  # relative; a closed form of a dozen operations in doubles
# Disk, hoop, a general wheel and a long roller: A and C in units of m a^2.
SHAPES = {"disk": (0.25, 0.5), "hoop": (0.5, 1.0), "wheel": (0.61, 0.87), "roller": (4.0, 0.5)}


def body(disk, *names):
    return {name: disk[name] for name in names}


def precise_residual(lean, precession, spin, inward, normal, radius, inertia):
    """Moment minus Omega z x H at 50 digits, in vectors; and the size of its terms."""
    lean, Omega, spin, inward, normal, a = map(mpmath.mpf, (lean, precession, spin, inward, normal, radius))
    A, C = map(mpmath.mpf, inertia)
    c, s = mpmath.cos(lean), mpmath.sin(lean)
    axle, up = (c, 0, -s), (s, 0, c)  # axes: towards the centre, y, up
    H = [C * spin * n + A * Omega * c * u for n, u in zip(axle, up, strict=True)]
    moment = (-a * up[2]) * inward - (-a * up[0]) * normal  # y component of (-a up) x force
    rate = Omega * H[0]  # y component of Omega z x H
    return moment - rate, abs(a * normal) + abs(a * inward) + abs(A * Omega**2) + abs(C * Omega * spin)


def members(shape, count):
    """Disks of any size, lean and precession, rad/s."""
    for _ in range(count):
        mass, radius, gravity = (float(x) for x in 10 ** DRAW.uniform([-6, -6, -3], [6, 6, 3]))
        inertia = tuple(k * mass * radius**2 for k in SHAPES[shape])
        disk = {"mass": mass, "radius": radius, "inertia": inertia, "gravity": gravity}
        lean, rate = DRAW.uniform(1e-3, 1.57), math.sqrt(gravity / radius) * 10 ** DRAW.uniform(-2, 2)
        yield disk, *(float(sign * x) for sign, x in zip(DRAW.choice([-1, 1], 2), (lean, rate), strict=True))


@pytest.mark.parametrize("shape", SHAPES)
def test_members_of_both_families_balance_the_moments_at_50_digits(shape):
    for disk, lean, precession in members(shape, 50):
        spins = (f(lean, precession, **disk) for f in (hw.rolling_spin, hw.sliding_spin))
        rolls = hw.contact_force(lean, precession, spin := next(spins), **body(disk, "mass", "radius", "gravity"))
        slides = (0.0, disk["mass"] * disk["gravity"])
        for member, force in ((spin, rolls), (next(spins), slides)):
            residual, size = precise_residual(lean, precession, member, *force, *[disk["radius"], disk["inertia"]])
            assert abs(residual) <= DIGITS * size
