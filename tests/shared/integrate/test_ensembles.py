"""Many starts at once, and what an import loads."""

import subprocess
import sys

import numpy as np
import pytest
from systems import PENDULUM, pendulum

from tam570.integrate import solve


def test_an_ensemble_is_its_members():
    starts = np.random.default_rng(570).uniform(-1, 1, (40, 2))
    t = np.linspace(0, 5, 7)
    together = solve(pendulum, t, starts, parameters=PENDULUM, method="python")
    assert together.shape == (40, 7, 2)
    alone = [solve(pendulum, t, start, parameters=PENDULUM, method="python") for start in starts]
    assert together == pytest.approx(np.array(alone), abs=1e-11)  # a tenth of rtol: NumPy rounds sines otherwise
    few = solve(lambda t, y: (y[1], -abs(float(y[0]))), t, starts[:3])
    assert few.shape == (3, 7, 2)


def test_importing_loads_numpy_at_most():
    code = "import sys, tam570.integrate; print(*sorted({m.split('.')[0] for m in sys.modules}))"
    loaded = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout.split()
    assert "numpy" in loaded
    assert not {"scipy", "llvmlite", "sympy", "matplotlib", "mpmath"} & set(loaded)
