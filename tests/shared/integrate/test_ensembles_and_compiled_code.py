"""Many starts at once, compiled code, and what an import loads."""

import math
import subprocess
import sys

import numpy as np
import pytest

from tam570.integrate import numba_backend, solve

EPS = 2.0**-52


def pendulum(t, state, *, length, gravity):
    theta, omega = state
    return omega, -gravity / length * math.sin(theta)


PENDULUM = {"length": 1.0, "gravity": 9.81}


def test_an_ensemble_is_its_members():
    starts = np.random.default_rng(570).uniform(-1, 1, (40, 2))
    t = np.linspace(0, 5, 7)
    together = solve(pendulum, t, starts, parameters=PENDULUM, method="python")
    assert together.shape == (40, 7, 2)
    alone = [solve(pendulum, t, start, parameters=PENDULUM, method="python") for start in starts]
    assert together == pytest.approx(np.array(alone), abs=1e-11)  # a tenth of rtol: NumPy rounds sines otherwise
    few = solve(lambda t, y: (y[1], -abs(float(y[0]))), t, starts[:3])
    assert few.shape == (3, 7, 2)


def test_compiled_and_interpreted_agree():
    pytest.importorskip("numba")
    t = np.linspace(0, 30, 50)
    for rtol in (1e-6, 1e-12):
        compiled_, plain = (
            solve(pendulum, t, [2.0, 0.0], parameters=PENDULUM, rtol=rtol, method=m) for m in ("numba", "python")
        )
        assert compiled_ == pytest.approx(plain, abs=1e-11)  # the same steps, sines rounded otherwise


def test_where_nothing_may_be_written_it_goes_on_in_python(tmp_path, monkeypatch):
    pytest.importorskip("numba")
    (tmp_path / "file").touch()
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "file"))
    assert numba_backend.wait("no such source") == np.inf

    def rates(t, state):  # of this test alone: no process has it compiled
        return state[1], -math.sin(state[0]) - 0.0123 * state[1]

    t, starts = np.linspace(0, 1000, 4), np.array([[2.0, 0.0], [1.0, 0.0]])
    rows = solve(rates, t, starts, rtol=1e-12)
    assert rows == pytest.approx(solve(rates, t, starts, rtol=1e-12, method="python"), abs=1e-12)
    with pytest.raises(OSError, match="file"):
        solve(rates, t, starts[0], method="numba")


def test_importing_loads_numpy_at_most():
    code = "import sys, tam570.integrate; print(*sorted({m.split('.')[0] for m in sys.modules}))"
    loaded = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout.split()
    assert "numpy" in loaded
    assert not {"scipy", "numba", "sympy", "matplotlib", "mpmath"} & set(loaded)
