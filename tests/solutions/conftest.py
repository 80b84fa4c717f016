"""mpmath computes with fifty digits in these tests."""

import mpmath
import pytest


@pytest.fixture(autouse=True)
def fifty_digits():
    with mpmath.workdps(50):
        yield
