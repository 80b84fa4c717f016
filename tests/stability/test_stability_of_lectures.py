"""The integrators over every lecture that moves, and over planets that come close to the sun."""

import importlib.util
from pathlib import Path

import numpy as np
import pytest

from tam570.integrate import solve
from tam570.lectures import load

FILE = Path(__file__).parents[2] / "benchmarks" / "run_time" / "lectures.py"
SPEC = importlib.util.spec_from_file_location("_stability_lectures", FILE)
LECTURES = importlib.util.module_from_spec(SPEC)
SPEC.loader.exec_module(LECTURES)
EXACT = [name for name in LECTURES.PROBLEMS if hasattr(load(name.partition(",")[0]), "exact")]
TOLERANCES = (1e-6, 1e-8, 1e-10, 1e-12)
# rtol bounds a step's error; motions through pericentre multiply it by what a time error there is worth
SENSITIVE = {"planet, e = .9": 1e2, "planet, e = .999": 1e5}


def ended(name, rtol, **options):
    rhs, start, parameters, end = LECTURES.PROBLEMS[name]
    return solve(rhs, [0.0, end], start, parameters=parameters, rtol=rtol, **options)[-1]


@pytest.mark.parametrize("name", LECTURES.PROBLEMS)
def test_two_methods_that_share_nothing_but_the_rates_agree(name):
    rhs, start, parameters, end = LECTURES.PROBLEMS[name]
    times = np.linspace(0.0, min(end, 2.0), 5)
    explicit = solve(rhs, times, start, parameters=parameters, rtol=1e-13, method="python")
    implicit = solve(rhs, times, start, parameters=parameters, rtol=1e-12, method="gauss")
    size = np.abs(explicit).max() + 1e-300
    assert np.abs(explicit - implicit).max() / size < 1e-9


@pytest.mark.parametrize("name", EXACT)
def test_a_tighter_tolerance_brings_the_exact_motion_closer(name):
    _, start, parameters, end = LECTURES.PROBLEMS[name]
    exact = load(name.partition(",")[0]).exact([0.0, end], start, **parameters)[-1]
    errors = [np.abs(ended(name, rtol) - exact).max() / np.abs(exact).max() for rtol in TOLERANCES]
    for rtol, error in zip(TOLERANCES, errors, strict=True):
        assert error < 1e3 * SENSITIVE.get(name, 1.0) * rtol, rtol


@pytest.mark.parametrize("name", ["planet, e = .9", "planet, e = .999"])
def test_close_to_the_sun_what_is_conserved_stays(name):
    rhs, start, parameters, end = LECTURES.PROBLEMS[name]
    states = solve(rhs, np.linspace(0.0, end, 200), start, parameters=parameters, rtol=1e-13)
    for law in load("planet").INVARIANTS.values():
        values = np.array([np.ravel(law(state, **parameters)) for state in states])
        assert np.abs(values - values[0]).max() < 1e-9
