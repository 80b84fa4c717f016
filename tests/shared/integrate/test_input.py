"""Invalid input raises an error that names the argument and the remedy."""

import math

import numpy as np
import pytest
from systems import oscillator

from tam570.integrate import solve, solve_rotation
from tam570.lectures import rocket

ROCKET = {"rhs": rocket.rates, "y0": rocket.START, "parameters": rocket.EXAMPLE}


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"t": [0, 1, 1]}, r"^t: must increase, but t\[2\] = 1"),
        ({"t": [2.0, 0.0, 1.0]}, r"^t: must decrease, but t\[2\] = 1 does not come before t\[1\]"),
        ({"t": [0.0]}, "^t: need"),
        ({"t": [0, math.nan]}, "^t: "),
        ({"t": [0, 1j]}, "^t: must be"),
        ({"y0": [1.0, math.inf]}, "^y0: every number must be finite"),
        ({"y0": []}, "^y0: need"),
        ({"y0": [1j, 0]}, "^y0: must be"),
        ({"rtol": 0}, "^rtol: "),
        ({"rtol": [1e-6, 1e-6]}, "^rtol: "),
        ({"method": "euler"}, "^method: one of"),
        ({"parameters": {"w": 1}}, "^rhs: cannot be called"),
        ({"parameters": "w"}, "^parameters: must be a mapping"),
        ({"rhs": lambda t, y: y[0], "t": [1, 0]}, "^rhs: must return 2 numbers"),
        ({"rhs": lambda t, y: [[1.0, 2.0], 3.0]}, "^rhs: must return 2 numbers"),
        ({"rhs": lambda t, y: 1j * np.asarray(y)}, "^rhs: must return real"),
        ({"rhs": lambda t, y: (math.nan, 0.0)}, "^rhs: gives"),
        ({"method": "gauss", "step": -1.0}, "^step: must be"),
        ({"method": "gauss", "step": math.inf}, "^step: must be"),
        ({"step": 0.1}, '^step: goes with method "gauss" or "composition" alone'),
        ({"max_step": 1e-20}, "^max_step: 1e-20 is too short"),
        ({"y0": [10**400, 0]}, "^y0: must be"),
        ({"method": "composition", "rhs": lambda t, y: (y[1], -y[0] - y[1])}, "^method: "),
        ({"method": "gauss", "project": lambda y: y}, "^project: "),
        ({"method": "gauss", "dense": True}, "^events, dense, report: "),
        ({"project": lambda y: y, "dense": True}, "^events, dense, report: "),
        ({"y0": [[1.0, 0.0]], "dense": True}, "^events, dense, report: "),
        ({**ROCKET, "t": [0, 18], "method": "gauss"}, r'jump of rhs near t = 10; try "auto"'),
        ({"y0": [[1.0, 0.0], [0.0, 1.0]], "project": lambda y: y}, "^project: "),
        ({"y0": [[1.0, 0.0], [0.0, 1.0]], "method": "gauss"}, "^y0: "),
        ({"method": "compiled", "rhs": lambda t, y: (y[1], -y[0]) if y[0] > 0 else (0.0, 1.0)}, "^method: "),
    ],
)
def test_bad_input_is_named_with_its_remedy(change, message):
    with pytest.raises(ValueError, match=message):
        solve(**{"rhs": oscillator, "t": [0, 1], "y0": [1.0, 0.0], **change})


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"R": np.eye(2)}, "^R: need finite numbers of shape"),
        ({"R": np.full((3, 3), math.nan)}, "^R: need finite numbers of shape"),
        ({"omega": (1.0, 0.0)}, "^omega: need finite numbers of shape"),
        ({"omega": (math.inf, 0.0, 0.0)}, "^omega: need finite numbers of shape"),
        ({"t": [0.0]}, "^t: need"),
        ({"rtol": 1.0}, "^rtol: "),
    ],
)
def test_bad_input_of_a_rotation_is_named_too(change, message):
    arguments = {"t": [0, 1], "omega": (0.0, 0.0, 1.0), "R": np.eye(3), **change}
    with pytest.raises(ValueError, match=message):
        solve_rotation(lambda t, w: (0.0, 0.0, 0.0), **arguments)


def test_a_rotation_that_becomes_infinitely_fast_is_told_with_its_time():
    with pytest.raises(ArithmeticError, match=r"t = 0\.(9|99\d*)|t = 1"):
        solve_rotation(lambda t, w: (0.0, 0.0, w[2] * w[2]), [0, 2], (0.0, 0.0, 1.0), np.eye(3))
