"""Laws of the lectures on rotations: dyads, the spherical triangle."""

import math

import numpy as np
import pytest

from tam570.lectures import dyads, sphere
from tam570.rotations import exp, log

DRAW = np.random.default_rng(105)


def triad():
    return exp(DRAW.normal(size=3))


# dyads


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
    found = dyads.nine(R, base)
    rebuilt = sum(found[i, j] * dyads.dyad(base[i], base[j]) for i in range(3) for j in range(3))
    assert rebuilt == pytest.approx(R, abs=1e-14)
    assert dyads.nine(R, np.eye(3)) == pytest.approx(R)


def test_what_is_no_triad_is_refused_by_name():
    skewed = triad() + [[0, 1e-3, 0], [0, 0, 0], [0, 0, 0]]
    with pytest.raises(ValueError, match="before"):
        dyads.rotation(skewed, triad())
    with pytest.raises(ValueError, match="after"):
        dyads.rotation(triad(), -triad())
    with pytest.raises(ValueError, match="triad"):
        dyads.nine(triad(), skewed)
    with pytest.raises(ValueError, match="R"):
        dyads.nine(np.eye(2), triad())
    for wrong in ([1.0, 2.0], [1.0, 2.0, math.nan], "abc"):
        with pytest.raises(ValueError, match="b"):
            dyads.dyad([1.0, 0.0, 0.0], wrong)


# sphere


def composed(first, second):
    return exp(np.asarray(second)) @ exp(np.asarray(first))


@pytest.mark.parametrize("size", [1e-300, 1e-160, 1e-8, 1.0, 3.0, 20.0])
def test_the_triangle_composes_as_matrices_do(size):
    for _ in range(20):
        first, second = size * DRAW.normal(size=(2, 3))
        found = sphere.compose(first, second)
        assert np.linalg.norm(found) <= math.pi + 1e-15
        assert exp(found) == pytest.approx(composed(first, second), abs=1e-13)


def test_tiny_rotations_add_up_to_the_second_order():
    first, second = np.array([3e-9, -1e-9, 2e-9]), np.array([1e-9, 4e-9, -2e-9])
    assert sphere.compose(first, second) == pytest.approx(first + second, rel=1e-8)
    assert sphere.compose(first * 1e-200, np.zeros(3)) == pytest.approx(first * 1e-200, rel=1e-14)
    assert (sphere.compose(np.zeros(3), np.zeros(3)) == 0).all()


def test_turns_about_one_axis_add_up_round_and_round():
    n = DRAW.normal(size=3)
    n /= np.linalg.norm(n)
    assert sphere.compose(1.0 * n, 1.5 * n) == pytest.approx(2.5 * n, abs=1e-14)
    assert sphere.compose(2.0 * n, 2.0 * n) == pytest.approx((4.0 - 2 * math.pi) * n, abs=1e-14)
    assert sphere.compose(1.3 * n, -1.3 * n) == pytest.approx(np.zeros(3), abs=1e-15)
    assert np.linalg.norm(sphere.compose(math.pi / 2 * n, math.pi / 2 * n)) == pytest.approx(math.pi, abs=1e-14)


def test_two_half_turns_make_twice_the_angle_between_their_axes():
    x, y = np.eye(3)[:2]
    between = 0.3
    tilted = math.cos(between) * x + math.sin(between) * y
    assert sphere.compose(math.pi * x, math.pi * tilted) == pytest.approx([0, 0, 2 * between], abs=1e-14)
    assert exp(sphere.compose(math.pi * x, math.pi * y)) == pytest.approx(np.diag([-1, -1, 1]), abs=1e-14)


def test_a_rotation_vector_is_no_vector():
    first, second = np.array([0.0, 0.0, 1.6]), np.array([1.2, 0.3, 0.0])
    one, other = sphere.compose(first, second), sphere.compose(second, first)
    assert np.linalg.norm(one - other) > 0.5 and np.linalg.norm(one - first - second) > 0.1
    assert np.linalg.norm(one) == pytest.approx(np.linalg.norm(other)) and one == pytest.approx(
        log(composed(first, second))
    )


@pytest.mark.parametrize("wrong", [[1.0, 2.0], [math.inf, 0.0, 0.0], [[0.0, 0.0, 0.0]]])
def test_what_is_no_rotation_vector_is_refused_by_name(wrong):
    with pytest.raises(ValueError, match="first"):
        sphere.compose(wrong, np.zeros(3))
    with pytest.raises(ValueError, match="second"):
        sphere.compose(np.zeros(3), wrong)
