"""Compiled code: the motions of Python, a cache on disk, interrupts, and results that do not depend on other runs."""

import math
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest
from parameters import first

from tam570.integrate import solve

pytest.importorskip("llvmlite")

RUN = """
import sys, math
from tam570.integrate import solve
end = solve(lambda t, y: (y[1], -math.sin(y[0])), [0, 50.0], [2.0, 0.0], method="compiled")[-1]
print(*map(float.hex, end.tolist()), "numba" in sys.modules)
"""


def printed(cache, program, *arguments):
    """Return the output of a program in a new process that caches compiled code in the folder `cache`."""
    options = {**os.environ, "XDG_CACHE_HOME": str(cache)}
    run = subprocess.run([sys.executable, "-c", program, *arguments], env=options, capture_output=True, text=True)
    assert not run.stderr, run.stderr
    return run.stdout


def first_and_second(cache, between=lambda files: None):
    """Return the outputs of two successive processes with one cache; call `between` with its files after each."""
    runs = []
    for _ in range(2):
        runs.append(printed(cache, RUN))
        between(sorted(Path(cache).rglob("*.o")))
    return runs


def test_a_function_without_derivatives_takes_the_steps_of_python():
    def rates(t, y):
        return y[1], -abs(y[0]) * y[0] - 0.1 * abs(y[1]) * y[1]

    t = np.linspace(0, 20, 41)
    compiled, plain = (solve(rates, t, [2.0, 0.0], method=m) for m in ("compiled", "python"))
    assert (compiled == plain).all()  # products and sums in the same order: the same bits


@pytest.mark.parametrize("method", ["gauss", "composition"])
def test_long_runs_compiled_take_the_steps_of_python(method, monkeypatch):
    t, options = np.linspace(0, 50, 6), {"method": method, "step": 0.01}
    compiled = solve(lambda t, y: (y[1], -y[0] * y[0] * y[0]), t, [1.0, 0.0], **options)
    monkeypatch.setenv("TAM570_COMPILED", "0")
    assert (solve(lambda t, y: (y[1], -y[0] * y[0] * y[0]), t, [1.0, 0.0], **options) == compiled).all()


def test_a_second_process_takes_what_the_first_compiled(tmp_path):
    def unchanged(files):
        stamps.append([file.stat().st_mtime_ns for file in files])

    stamps = []
    run, two = first_and_second(tmp_path, unchanged)
    assert run == two and run.endswith("False\n")  # numba is not imported
    assert len(stamps[0]) == 2 and stamps[0] == stamps[1]  # the series, and the loop for this number of components


@pytest.mark.parametrize("spoiled", first(1, [None, b"", b"nonsense"]))
def test_a_file_that_was_spoiled_is_made_again(tmp_path, spoiled):
    contents = []

    def spoil(files):
        code = files[0].read_bytes()
        contents.append(code)
        files[0].write_bytes(code[:-1] + bytes([code[-1] ^ 1]) if spoiled is None else spoiled)

    run, two = first_and_second(tmp_path, spoil)
    assert run == two
    assert contents[0] == contents[1]  # the second process compiled again


def test_a_folder_that_takes_nothing_is_no_hindrance(tmp_path):
    (tmp_path / "file").touch()
    run, two = first_and_second(tmp_path / "file")
    assert run == two and run


def test_without_the_compiler_auto_runs_in_python(monkeypatch):
    monkeypatch.setenv("TAM570_COMPILED", "0")

    def rates(t, state):
        return state[1], -math.sin(state[0]) - 0.0123 * state[1]

    rows = solve(rates, [0, 500.0], [2.0, 0.0])
    assert (rows == solve(rates, [0, 500.0], [2.0, 0.0], method="python")).all()


@pytest.mark.skipif(sys.platform == "win32", reason="no SIGINT for one process there")
def test_an_interrupt_is_heard_in_compiled_code():
    code = (
        "import math\nfrom tam570.integrate import solve\nprint('go', flush=True)\n"
        "solve(lambda t, y: (y[1], -math.sin(y[0])), [0, 1e12], [2.0, 0.0], method='compiled')"
    )
    run = subprocess.Popen([sys.executable, "-c", code], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    run.stdout.readline()
    time.sleep(1.0)  # s, until the run has started
    run.send_signal(signal.SIGINT)
    assert "KeyboardInterrupt" in run.communicate(timeout=300)[1]


CALLS = """
import hashlib, math, sys
import numpy as np
from tam570.integrate import solve

def pendulum(t, y, *, k=1.0):
    return y[1], -k * math.sin(y[0])

def outflow(t, y):
    return (-math.sqrt(y[0]),)

def pulse(t, y):
    return y[1], -y[0] + math.exp(-(((t - 3.0) / 0.02) ** 2))

def bounce(t, y):
    return y[1], -1e4 * y[0] if y[0] < 0 else -9.81

LONG = np.linspace(0, 2e5, 5)
calls = [
    lambda: solve(pendulum, [0, 10], [2.0, 0.0]),
    lambda: solve(pendulum, LONG, [2.0, 0.1]),
    lambda: solve(pendulum, LONG, [0.0, 0.3], parameters={"k": 2.0}),
    lambda: solve(pendulum, [0, 10], [2.0, 0.0], method="compiled"),
    lambda: solve(pendulum, [0, 10], [0.0, 1.0], method="compiled"),
    lambda: solve(pendulum, [0, 300], [[0.01 * i, 0.0] for i in range(15)]),
    lambda: solve(pendulum, [0, 5000], [[0.01 * i, 0.0] for i in range(40)]),
    lambda: solve(outflow, [0, 1], [0.0]),
    lambda: solve(outflow, [0, 1], [1.0]),
    lambda: solve(pulse, [0, 10], [0.0, 0.0]),
    lambda: solve(pulse, [1, 10], [0.0, 0.0]),
    lambda: solve(pulse, [0, 3e5], [0.0, 0.0], rtol=1e-6),
    lambda: solve(bounce, [0, 3], [1.0, 0.0]),
    lambda: solve(lambda t, y: (y[1], -y[0] ** 3), [0, 3000], [1.0, 0.0], method="gauss"),
]
for which in map(int, sys.argv[1:]):
    print(which, hashlib.sha256(np.ascontiguousarray(calls[which]()).tobytes()).hexdigest())
"""
COUNT = CALLS.count("lambda: ")


def answers(order, cache):
    """Return {call: set of the digests of its results} of one new process."""
    digests = {}
    for line in printed(cache, CALLS, *map(str, order)).splitlines():
        which, digest = line.split()
        digests.setdefault(int(which), set()).add(digest)
    return digests


def test_identical_calls_return_identical_arrays_cold_or_warm_in_any_order(tmp_path):
    forwards = list(range(COUNT))
    cold = answers(3 * forwards, tmp_path)
    assert {which: len(digests) for which, digests in cold.items()} == dict.fromkeys(forwards, 1)
    assert cold == answers(forwards[::-1], tmp_path)
