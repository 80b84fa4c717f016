"""The same call gives the same answer, whatever ran before it, in this process or another."""

import os
import subprocess
import sys

import pytest

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
    lambda: solve(pendulum, [0, 300], [[0.01 * i, 0.0] for i in range(40)]),
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
    """{call: digests of its answers} of one new process."""
    options = {**os.environ, "XDG_CACHE_HOME": str(cache)}
    run = subprocess.run([sys.executable, "-c", CALLS, *map(str, order)], env=options, capture_output=True, text=True)
    assert not run.stderr, run.stderr
    digests = {}
    for line in run.stdout.splitlines():
        which, digest = line.split()
        digests.setdefault(int(which), set()).add(digest)
    return digests


def test_identical_calls_return_identical_arrays_cold_or_warm_in_any_order(tmp_path):
    pytest.importorskip("llvmlite")
    forwards, backwards = list(range(COUNT)), list(range(COUNT))[::-1]
    cold = answers([*forwards, *forwards, *forwards], tmp_path)
    repeated = answers([*backwards, *backwards], tmp_path)
    assert {which: len(digests) for which, digests in cold.items()} == dict.fromkeys(forwards, 1)
    assert cold == repeated
