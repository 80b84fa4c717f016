"""A prepared run, and a run that `solve` caches, give the states of `solve` from any start, whatever ran before."""

import math
from concurrent.futures import ThreadPoolExecutor
from functools import partial

import numpy as np
import pytest
from systems import pendulum

from tam570.integrate import prepared, solve, solver

STARTS = [[1.0, 0.0], (0.1, 2.0), np.array([-2.0, 0.5]), [0.0, 0.0], [3, -1]]
LENGTH = {"length": 0.7, "gravity": 9.81}


def driven(t, y):
    return y[1], math.cos(t + 0.3) - y[0] ** 3


def thrown(t, y, *, length, gravity):
    return y[1], -length if y[0] > 0 else length


@pytest.mark.parametrize("times", [[0, 3], np.linspace(-1, 20, 57), [5.0, 2.0, 1.5]])
@pytest.mark.parametrize(("rhs", "parameters"), [(pendulum, LENGTH), (driven, {})])
def test_the_states_are_those_of_solve(monkeypatch, times, rhs, parameters):
    monkeypatch.setattr("tam570.integrate.solver.solve", pytest.fail)  # the prepared code must not call it
    for atol in (None, 1e-3, [1e-3, 0.0]):
        run = prepared(rhs, times, STARTS[0], parameters=parameters, rtol=1e-9, atol=atol)
        for start in STARTS[:3]:
            expected = solve(rhs, times, start, parameters=parameters, rtol=1e-9, atol=atol, method="compiled")
            np.testing.assert_array_equal(run(start), expected)


def test_threads_do_not_share_their_memory():
    times = np.linspace(0, 300, 1001)
    run = prepared(pendulum, times, STARTS[0], parameters=LENGTH, rtol=1e-12)
    starts = [[0.01 * k, 0.3] for k in range(1, 41)]
    with ThreadPoolExecutor(4) as pool:
        together = list(pool.map(run, starts))
    for start, states in zip(starts, together, strict=True):
        np.testing.assert_array_equal(states, run(start))


@pytest.mark.parametrize("start", [[1.0], [1, 2, 3], [math.nan, 0.0], [math.inf, 0.0], 1.0, "no", [1.0, None], []])
def test_a_wrong_start_is_refused_and_the_next_one_runs(start):
    """A prepared run, and `solve` with a cached run, raise for a wrong start and then still work."""
    run = prepared(pendulum, [0, 1], STARTS[0], parameters=LENGTH)
    call = partial(solve, pendulum, [0, 1], parameters=LENGTH, method="compiled")
    expected = [call(each) for each in STARTS[:3]]
    for states_from in (run, call):
        with pytest.raises((ValueError, IndexError)):  # or what rhs itself raises
            states_from(start)
        np.testing.assert_array_equal(states_from(STARTS[0]), expected[0])


def test_what_cannot_be_compiled_runs_as_it_stands(monkeypatch):
    run = prepared(thrown, [0, 5], STARTS[0], parameters=LENGTH)
    np.testing.assert_array_equal(run(STARTS[0]), solve(thrown, [0, 5], STARTS[0], parameters=LENGTH))
    monkeypatch.setenv("TAM570_COMPILED", "0")
    plain = prepared(pendulum, [0, 5], STARTS[0], parameters=LENGTH)
    np.testing.assert_array_equal(plain(STARTS[1]), solve(pendulum, [0, 5], STARTS[1], parameters=LENGTH))


@pytest.mark.parametrize("rhs", [pendulum, thrown])
def test_parameters_are_those_of_the_preparation(rhs):
    arguments = dict(LENGTH)
    run = prepared(rhs, [0, 1], STARTS[0], parameters=arguments)
    before = run(STARTS[0])
    arguments["length"] = 5.0
    np.testing.assert_array_equal(run(STARTS[0]), before)


def repeated_call(rhs, times, **arguments):
    """Return a call of `solve` that has been made often enough to have a cached run."""
    call = partial(solve, rhs, times, method="compiled", **arguments)
    for start in STARTS[:3]:
        call(start)
    return call


@pytest.mark.parametrize("times", [[0, 3], np.linspace(-1, 20, 57), (5.0, 2.0, 1.5)])
@pytest.mark.parametrize(("rhs", "parameters"), [(pendulum, LENGTH), (driven, {})])
def test_a_call_like_ones_before_gives_what_they_gave(monkeypatch, times, rhs, parameters):
    run = repeated_call(rhs, times, parameters=parameters, rtol=1e-9, atol=1e-12)
    with monkeypatch.context() as patch:
        patch.setattr(solver, "engine", None)  # the cached run needs none
        results = [run(start) for start in STARTS]
    monkeypatch.setattr("tam570.integrate.compiled_cache.slot_of", lambda *_: None)
    for start, states in zip(STARTS, results, strict=True):
        np.testing.assert_array_equal(states, run(start))


def test_a_call_of_which_anything_differs_is_another(monkeypatch):
    times, arguments = np.array([0.0, 1.0, 3.0]), dict(LENGTH)
    run = repeated_call(pendulum, times, parameters=arguments)
    monkeypatch.setattr(solver, "engine", None)
    first = run(STARTS[0])
    first[:] = 0.0  # the caller may change a result
    assert run(STARTS[0])[0].tolist() == STARTS[0]
    for change in (partial(times.__setitem__, 2, 2.0), partial(arguments.update, length=1.7)):
        change()
        with pytest.raises(TypeError):  # no cached run: `solve` calls `engine`, here None
            run(STARTS[0])


def test_rates_that_are_no_numbers_are_refused_before_a_start():
    with pytest.raises(ValueError, match="^rhs: must return 2 numbers"):
        prepared(lambda t, y: (-v for v in y), [0, 1], STARTS[0])
