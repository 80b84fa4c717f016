"""Invariants, orders and growth: each measure on a case known in closed form."""

import math

import numpy as np
import pytest

from tam570.invariants import drift, growth_exponent, observed_order, rotation_defect, violation


def test_drift_is_relative_to_the_largest_value():
    states = np.array([[1.0], [2.0], [4.0]])
    assert drift(lambda s: s[0], states) == pytest.approx([0, 1 / 4, 3 / 4])
    assert drift(lambda s: (s[0], 0.0), states) == pytest.approx([0, 1 / 4, 3 / 4])  # a vector, by its length
    assert drift(lambda s: 1e-200 * s[0], states) == pytest.approx([0, 1 / 4, 3 / 4])


def test_violation_is_the_largest_component():
    states = np.array([[3.0, 4.0], [0.0, 5.0], [6.0, 0.0]])
    assert violation(lambda s: s @ s - 25, states) == pytest.approx([0, 0, 11])
    assert violation(lambda s: (s[0] - 3, 4 - s[1]), states) == pytest.approx([0, 3, 4])


def test_rotation_defect_sees_stretch_and_shear():
    turn = np.array([[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]])
    shear = np.eye(3) + 1e-6 * np.outer([1, 0, 0], [0, 1, 0])
    assert rotation_defect([turn, 1.001 * turn, shear]) == pytest.approx([0, 1.001**2 - 1, 1e-6], rel=1e-9)


@pytest.mark.parametrize("order", [1, 2.5, 8])
def test_order_and_exponent_are_slopes(order):
    x = np.array([0.1, 0.2, 0.5])
    assert observed_order(x, 3 * x**order) == pytest.approx(order)
    assert growth_exponent(x, -3 * x**order) == pytest.approx(order)


def test_a_lucky_zero_does_not_count_as_shrinking():
    t = np.arange(1.0, 101.0)
    assert growth_exponent(t, t * np.cos(math.pi * t / 3)) == pytest.approx(1, abs=0.1)


@pytest.mark.parametrize(("x", "y"), [([1.0], [1.0]), ([1.0, 2.0], [1.0]), ([0.0, 1.0], [1.0, 1.0]), ([1, 2], [0, 1])])
def test_what_has_no_logarithm_is_refused(x, y):
    with pytest.raises(ValueError, match="^steps, errors: "):
        observed_order(x, y)
