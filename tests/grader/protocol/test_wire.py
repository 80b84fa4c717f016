"""Messages between sandbox and grader, conversion of numbers of other libraries, and imports in a text."""

from decimal import Decimal
from fractions import Fraction

import mpmath
import numpy as np
import pytest
import sympy

from tam570_grader.protocol.wire import Foreign, ItemBudget, Unreadable, packed, portable, unpacked
from tam570_grader.sandbox.preload import imported


@pytest.mark.parametrize("value", [None, True, 1.5, [1, [2.0]], "x", b"x", np.eye(3), np.ones((2, 0)), Foreign("dict")])
def test_messages_arrive_as_they_were_sent(value):
    np.testing.assert_equal(unpacked(packed({"value": value})), {"value": value})


@pytest.mark.parametrize(
    "data",
    [b"", b"\xc1", b"\x81\xa1x", packed(1) + b"x", b"\xc7\x05\x01\x92\xa3|O8\x90", b"\xd4\x09\x00"]
    + [b"\xdd\0\x20\0\0" + packed(small) * 2**21 for small in ([], {}, Foreign("dict"), 1)],  # they expand in memory
)
def test_garbage_is_no_message(data):
    with pytest.raises(Unreadable):
        unpacked(data, ItemBudget())


def test_the_search_for_imports_takes_no_longer_than_the_text():
    assert not imported(b"\n" * 2**20 + b" " * 2**20 + b"from \t" * 2**18)


@pytest.mark.parametrize(
    ("value", "numbers"),
    [
        (mpmath.mpf("1.5"), 1.5),
        ([sympy.Rational(1, 2), 2], [0.5, 2.0]),
        ((np.array([1.0]), Fraction(1, 4)), [[1.0], 0.25]),
        (sympy.Matrix([[1, 2]]), [[1.0, 2.0]]),
        (np.array([[Decimal("0.5"), mpmath.pi]], dtype=object), [[0.5, np.pi]]),
    ],
)
def test_numbers_of_other_libraries_are_numbers(value, numbers):
    sent = portable(value)
    np.testing.assert_equal(sent, numbers)


@pytest.mark.parametrize("value", [{}, {1}, "x", b"x", print, object(), [1, "x"], [[1], [{}]], np.array([object()])])
def test_what_is_no_number_is_foreign(value):
    assert "Foreign" in repr(portable(value))


@pytest.mark.parametrize(
    ("line", "names"),
    [
        ("import scipy.integrate", {"scipy.integrate"}),
        ("    from scipy.integrate import solve_ivp  # inside a function", {"scipy.integrate"}),
        ("from scipy import optimize, integrate", {"scipy.integrate", "scipy.optimize"}),
        ("import sympy as sp", {"sympy"}),
        ("import sympyx, scipyxintegrate", set()),
        ("# import sympy", set()),
        ("from tam570.integrate import solve", {"tam570.integrate"}),
        ("from tam570.lectures import integrate", set()),
    ],
)
def test_what_a_submission_imports_is_read_from_its_text(line, names):
    assert imported(f"import math\n{line}\n".encode()) == names
