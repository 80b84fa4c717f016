"""Laws of the lectures on rotations: dyads, the spherical triangle."""

import math

import numpy as np
import pytest

from tam570.lectures import dyads, sphere
from tam570.rotations import exp

DRAW = np.random.default_rng(105)


def triad():
    return exp(DRAW.normal(size=3))


def test_a_dyad_turns_what_it_is_dotted_with():
    a, b, r = DRAW.normal(size=(3, 3))
    assert dyads.dyad(a, b) @ r == pytest.approx(a * (b @ r))


@pytest.mark.parametrize("mirror", [1.0, -1.0])
def test_three_dyads_take_one_triad_to_the_other(mirror):
    before, after = mirror * triad(), mirror * triad()
    R = dyads.rotation(before, after)
    for old, new in zip(before, after, strict=True):
        assert R @ old == pytest.approx(new, abs=1e-15)
    assert np.abs(R @ R.T - np.eye(3)).max() < 1e-14
    assert np.linalg.det(R) == pytest.approx(1.0)


def test_nine_dyads_rebuild_the_rotation():
    R, base = triad(), triad()
    result = dyads.nine(R, base)
    rebuilt = sum(result[i, j] * dyads.dyad(base[i], base[j]) for i in range(3) for j in range(3))
    assert rebuilt == pytest.approx(R, abs=1e-14)
    assert dyads.nine(R, np.eye(3)) == pytest.approx(R)


def composed(first, second):
    return exp(np.asarray(second)) @ exp(np.asarray(first))


@pytest.mark.parametrize("size", [1e-300, 1e-160, 1e-8, 1.0, 3.0, 20.0])
def test_the_triangle_composes_as_matrices_do(size):
    for _ in range(20):
        first, second = size * DRAW.normal(size=(2, 3))
        result = sphere.compose(first, second)
        assert np.linalg.norm(result) <= math.pi + 1e-15
        assert exp(result) == pytest.approx(composed(first, second), abs=1e-13)
