"""Compiled code: a cache on disk, interrupts, prepared and repeated runs, and the series of Taylor's method."""

import math
import os
import signal
import subprocess
import sys
import time
from concurrent.futures import ThreadPoolExecutor
from functools import partial
from pathlib import Path

import numpy as np
import pytest
from parameters import first
from systems import pendulum

from tam570.integrate import prepared, solve, solver
from tam570.lectures import convergence

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


def without_derivatives(t, y):
    return y[1], -abs(y[0]) * y[0] - 0.1 * abs(y[1]) * y[1]


def cubic(t, y):
    return y[1], -y[0] * y[0] * y[0]


@pytest.mark.parametrize(
    ("rhs", "method", "plain", "step"),
    [
        (without_derivatives, "compiled", "python", None),
        *((cubic, each, each, 0.01) for each in ("gauss", "composition")),
    ],
    ids=["adaptive", "gauss", "composition"],
)
def test_a_compiled_run_takes_the_steps_of_python(monkeypatch, rhs, method, plain, step):
    run = partial(solve, rhs, np.linspace(0, 50, 41), [1.0, 0.0], step=step)
    compiled = run(method=method)
    monkeypatch.setenv("TAM570_COMPILED", "0")
    assert (compiled == run(method=plain)).all()  # products and sums in the same order: the same bits


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


STARTS = [[1.0, 0.0], (0.1, 2.0), np.array([-2.0, 0.5]), [0.0, 0.0], [3, -1]]
LENGTH = {"length": 0.7, "gravity": 9.81}


def driven(t, y):
    return y[1], math.cos(t + 0.3) - y[0] ** 3


def thrown(t, y, *, length, gravity):
    return y[1], -length if y[0] > 0 else length


def repeated_call(rhs, times, **arguments):
    """Return a call of `solve` that has been made often enough to have a cached run."""
    call = partial(solve, rhs, times, method="compiled", **arguments)
    for start in STARTS[:3]:
        call(start)
    return call


@pytest.mark.parametrize("times", [[0, 3], np.linspace(-1, 20, 57), (5.0, 2.0, 1.5)])
@pytest.mark.parametrize(("rhs", "parameters"), [(pendulum, LENGTH), (driven, {})])
@pytest.mark.parametrize("atol", [None, 1e-3, (1e-3, 0.0)])
def test_a_prepared_run_and_a_cached_one_give_the_states_of_a_new_one(monkeypatch, times, rhs, parameters, atol):
    options = {"parameters": parameters, "rtol": 1e-9, "atol": atol}
    run, call = prepared(rhs, times, STARTS[0], **options), repeated_call(rhs, times, **options)
    with monkeypatch.context() as patch:
        patch.setattr(solver, "solve", pytest.fail)  # the prepared run must not call it
        patch.setattr(solver, "engine", None)  # the cached run needs none
        results = [(run(start), call(start)) for start in STARTS]
    monkeypatch.setattr("tam570.integrate.compiled_cache.slot_of", lambda *_: None)
    for start, (by_preparation, by_cache) in zip(STARTS, results, strict=True):
        np.testing.assert_array_equal(by_preparation, call(start))
        np.testing.assert_array_equal(by_cache, call(start))


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


PLAIN = "sin cos tan asin acos atan sinh cosh tanh asinh atanh exp expm1 log log1p log2 log10 sqrt cbrt erf erfc"
INNER = {  # functions of u between 0.3 and 0.7
    **{name: getattr(math, name) for name in PLAIN.split(" ")},
    "acosh": lambda u: math.acosh(1 + u),
    "hypot": lambda u: math.hypot(u, 2.0 - u),
    "hypot with a number": lambda u: math.hypot(u, 0.5),
    "atan2": lambda u: math.atan2(u, u - 0.5),
    "power": lambda u: u**2.3,
    "power of a number": lambda u: 2.5**u,
    "power of a function": lambda u: (1 + u) ** (u * u),
    "half powers": lambda u: u**-1.5 + u**2.5,
    "quotients": lambda u: 1 / u + (1 - u) / (2 + u * u) - u / 3,
    "sine and cosine together": lambda u: math.sin(u) * math.cos(u) - math.cos(2 * u),
    "exp twice": lambda u: math.exp(u) + math.expm1(u),
}


@pytest.mark.parametrize("name", INNER)
def test_the_series_of_every_function(name):
    """For an argument that rises and falls, two methods agree that share only the values of the function."""
    inner = INNER[name]

    def rates(t, y):
        return inner(0.5 + 0.2 * math.cos(y[1])), 1.0 + 0.1 * y[0] * y[0] / (1 + y[0] * y[0])

    t = np.linspace(0, 12, 9)
    taylor, plain = (solve(rates, t, [0.1, 0.2], rtol=1e-13, method=m) for m in ("compiled", "python"))
    assert np.abs(taylor - plain).max() < 1e-11 * np.abs(plain).max()


@pytest.mark.parametrize("rtol", [1e-3, 1e-5, 1e-7, 1e-9, 1e-11, 1e-13, 1e-15])
def test_a_tolerance_is_kept_at_every_order(rtol):
    t = np.linspace(0, 6, 200)
    states = solve(lambda t, y: (y[1], -y[0]), t, [1.0, 0.0], rtol=rtol, method="compiled")
    exact = np.stack([np.cos(t), -np.sin(t)], 1)
    assert np.abs(states - exact).max() < 10 * rtol + 2e-15  # samples inside the steps too


@pytest.mark.parametrize("power", [1, 2, 4, 8, 16, 40])
@pytest.mark.parametrize("rtol", [1e-5, 1e-12])
def test_gaps_between_the_coefficients_are_no_accuracy(power, rtol):
    """y' = 1 + t^power has one coefficient far from the first; y' = 1 + y^power has every power-th."""
    plain = solve(lambda t, y: (1.0 + t**power,), [0, 2.0], [0.0], rtol=rtol, method="compiled")[-1, 0]
    assert plain == pytest.approx(2 + 2.0 ** (power + 1) / (power + 1), rel=10 * rtol)
    grow = partial(solve, lambda t, y: (1.0 + y[0] ** power,), [0.0, 0.5, 0.9], [0.0])
    curved, best = grow(rtol=rtol, method="compiled"), grow(rtol=1e-15, method="python")
    assert curved == pytest.approx(best, rel=100 * rtol)  # it becomes infinite at t = 1.6, 1.1, ...


def test_a_step_is_judged_at_its_end():
    """1 / (1 + t^8) has no coefficient between the first and the ninth: at a low order, no step seems too long."""
    end = solve(lambda t, y: (1 / (1 + t**8),), [0, 100.0], [1.0], rtol=1e-3, method="compiled")[-1, 0]
    assert end == pytest.approx(1 + math.pi / 8 / math.sin(math.pi / 8), rel=1e-2)  # 7 if it is not


def test_motions_together_are_each_alone():
    rng = np.random.default_rng(570)
    starts, t = rng.uniform(-1, 1, (37, 4)), np.linspace(0, 3, 5)
    starts[:9, 2:], starts[3] = 0.0, 0.0  # at rest; in equilibrium
    run = partial(solve, convergence.rates, t, parameters=convergence.EXAMPLE, rtol=1e-12, method="compiled")
    together, alone = run(starts), np.array([run(start) for start in starts])
    assert np.abs(together - alone).max() < 1e-10
    assert (together[:, 0] == starts).all()
