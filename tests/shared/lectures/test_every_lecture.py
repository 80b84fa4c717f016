"""Laws that hold for every lecture; the tests find a new lecture by its module."""

import inspect
import math

import numpy as np
import pytest
from parameters import first
from processes import imported_modules

from tam570 import cli
from tam570.course import Unknown
from tam570.integrate import solve
from tam570.lectures import load, names

MOVING = [name for name in names() if hasattr(load(name), "rates")]
EXACT = [name for name in names() if hasattr(load(name), "exact")]

# These motions end, or an invariant loses its digits; they run only as long as their film.
ENDING = {
    "quadratic_drag": "at terminal speed the velocity across, by which the invariant divides, is exponentially small",
    "rocket": "the tank is empty",
}


def parts(name):
    """Return rates(t, state) and {name: invariant(state)} of a lecture with its example parameters, and its start."""
    module = load(name)

    def rates(t, state):
        return module.rates(t, state, **module.EXAMPLE)

    laws = {name: lambda state, f=f: f(state, **module.EXAMPLE) for name, f in module.INVARIANTS.items()}
    return rates, laws, np.array(module.START)


def characteristic_time(name):
    """Return the time, s, of one radian of the fastest small motion about the start."""
    rates, _, start = parts(name)
    h = 1e-5 * (1 + np.abs(start))
    nearby = [(np.array(rates(0.0, start + d)) - rates(0.0, start - d)) / (2 * d.max()) for d in np.diag(h)]
    return 1 / np.abs(np.linalg.eigvals(np.transpose(nearby))).max()


def wandered(invariant, states):
    """Return the largest change of an invariant, relative to its size or to what one number of the state adds to it.

    The latter is for a momentum that is zero.
    """
    values = np.array([np.ravel(invariant(state)) for state in states])
    worth = [np.ravel(invariant(states[0] * (1 - 0.1 * unit))) - values[0] for unit in np.eye(states.shape[1])]
    size = max(np.linalg.norm(values, axis=1).max(), 10 * np.linalg.norm(worth, axis=1).max())
    return np.linalg.norm(values - values[0], axis=1).max() / size


def test_a_wrong_name_is_refused():
    with pytest.raises(Unknown, match="'tpo'.*oscillator"):
        load("tpo")


def test_no_lecture_loads_heavy_libraries_nor_does_a_film():
    code = "from tam570.lectures import load, names\nfrom tam570.show import show\nlist(map(load, names()))\n"
    assert not imported_modules(f"{code}show(load('least_action'))") & {"matplotlib", "sympy", "scipy", "PIL"}


@pytest.mark.parametrize("name", sorted({*names()} - {"inertia", "modes"}))  # where a matrix has the same name
@pytest.mark.parametrize("wrong", [math.nan, math.inf, 1e200, "many", None, [[1.0]]])
def test_a_parameter_that_is_no_number_is_refused_by_name(name, wrong):
    module = load(name)
    offered = {"t": [0.0, 1.0], "state": getattr(module, "START", None), **module.EXAMPLE}
    for function in (f for key, f in vars(module).items() if key[0] != "_" and inspect.isfunction(f)):
        accepted = {key: offered.get(key) for key in inspect.signature(function).parameters}
        for parameter in accepted.keys() & module.EXAMPLE if accepted.keys() <= offered.keys() else ():
            with pytest.raises(ValueError, match=rf"\b{parameter}\b"):
                function(**{**accepted, parameter: wrong})


@pytest.mark.parametrize("name", MOVING)
def test_a_mass_of_zero_and_a_state_of_another_shape_are_refused_by_name(name):
    module = load(name)
    for parameter in {"mass", "masses"} & set(module.EXAMPLE):
        zero = 0.0 if parameter == "mass" else (0.0,) * len(module.EXAMPLE[parameter])
        for function, t in ((module.rates, 0.0), *([(module.exact, [0.0, 1.0])] if name in EXACT else [])):
            with pytest.raises(ValueError, match=rf"\b{parameter}\b"):
                function(t, module.START, **{**module.EXAMPLE, parameter: zero})
    for wrong in (module.START[:-1], [*module.START, 0.0], [module.START], 1.0):
        with pytest.raises(ValueError, match=r"\bstate\b"):
            module.rates(0.0, wrong, **module.EXAMPLE)


@pytest.mark.parametrize("name", MOVING)
def test_rates_are_plain_floats_and_can_be_traced(name):
    """Rates are floats also at states that are not physical: an integrator may try one, and then repeat the step."""
    module = load(name)
    start = np.array(module.START)
    trials = [start, 0 * start, np.ones_like(start), -start, 1e3 * start[::-1], *(start * (1 - np.eye(len(start))))]
    for function in (module.rates, *([module.wrong_rates] if hasattr(module, "wrong_rates") else [])):
        for trial in trials:
            rates = function(0.0, trial.tolist(), **module.EXAMPLE)
            assert len(rates) == len(start) and all(type(rate) is float for rate in rates)
        report = solve(function, [0.0, 1e-3], start, parameters=module.EXAMPLE, report=True).report
        assert not report.untraced_reason or name == "rocket"  # which branches on its mass


@pytest.mark.parametrize("count", [10, pytest.param(1000, marks=pytest.mark.slow)])
@pytest.mark.parametrize("name", MOVING)
def test_invariants_stay_for_many_characteristic_times(name, count):
    rates, laws, start = parts(name)
    times = np.linspace(0.0, load(name).SECONDS if name in ENDING else count * characteristic_time(name), 60)
    states = solve(rates, times, start, rtol=1e-13)
    for name, invariant in laws.items():
        assert wandered(invariant, states) < 1e-9, name  # a thousand times rtol would be 1e-10 if all errors added up


@pytest.mark.parametrize("name", EXACT)
@pytest.mark.parametrize("begin", [0.0, -2.5])
def test_the_exact_motion_is_the_solved_one(name, begin):
    module = load(name)
    rates, _, start = parts(name)
    times = begin + np.linspace(0.0, module.SECONDS, 40)
    exact, solved = module.exact(times, start, **module.EXAMPLE), solve(rates, times, start, rtol=1e-12)
    assert exact.shape == solved.shape and exact[0] == pytest.approx(start, rel=1e-14, abs=1e-14)
    assert np.abs(exact - solved).max() < 1e-8 * np.abs(solved).max()  # the error of `solve` over these seconds


@pytest.mark.parametrize("name", first(4, names()))
def test_a_copy_plays_with_other_numbers(name, here, capsys):
    module = load(name)
    number = next((p for p, value in module.EXAMPLE.items() if isinstance(value, float)), None)
    change = ["--set", f"{number}={1.01 * module.EXAMPLE[number]}"] if number else []
    assert cli.main(["start", name]) == 0 and cli.main(["start", name]) == 0
    assert cli.main(["show", f"{name}.py", *change, "--save", "copy.html"]) == 0
    assert not capsys.readouterr().err
    assert (here / "copy.html").exists()


@pytest.mark.parametrize(
    ("name", "changes", "code"),
    [
        ("oscillator", "mass=0 mass=many mass=1,2 stiffness=1e99 seconds=-1 seconds=1e9 start.vx=nan", 1),
        ("oscillator", "weight=2 mass", 2),
        *((name, "start.R11=7.3", 1) for name in ("drifting_matrix", "wrong_coordinates")),  # not a rotation
    ],
)
def test_what_cannot_be_shown_is_not(name, changes, code, here, capsys):
    for change in changes.split():
        assert cli.main(["show", name, "--set", change, "--save", "a.html"]) == code
        assert change.partition("=")[0] in capsys.readouterr().err
    assert not (here / "a.html").exists()
