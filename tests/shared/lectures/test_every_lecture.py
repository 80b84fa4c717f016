"""What holds for every lecture. A new module comes under these laws by being there."""

import inspect
import math
import re
import subprocess
import sys

import numpy as np
import pytest
from parameters import first
from scipy.integrate import solve_ivp

from tam570 import cli
from tam570.course import Unknown
from tam570.integrate import solve
from tam570.lectures import catalogue, load, names
from tam570.show import show
from tam570.show.page import page

LARGEST = 250_000  # bytes of a page
LONGEST = 150  # lines of a module
MOVING = [name for name in names() if hasattr(load(name), "rates")]
EXACT = [name for name in names() if hasattr(load(name), "exact")]

CHARACTERISTIC_TIMES = 1000
# Some motions end, or lose what they began with; they are followed for as long as their film.
ENDING = {
    "quadratic_drag": "at terminal speed the velocity across, by which the invariant divides, is exponentially small",
    "rocket": "the tank is empty",
}


def parts(name):
    """rates and invariants of a lecture with its parameters in place, and its start."""
    module = load(name)

    def rates(t, state):
        return module.rates(t, state, **module.EXAMPLE)

    laws = {law: lambda state, f=f: f(state, **module.EXAMPLE) for law, f in module.INVARIANTS.items()}
    return rates, laws, np.array(module.START)


def duration(name):
    """s; a characteristic time is one radian of the fastest small motion about the start."""
    rates, _, start = parts(name)
    if name in ENDING:
        return load(name).SECONDS
    h = 1e-5 * (1 + np.abs(start))
    nearby = [(np.array(rates(0.0, start + d)) - rates(0.0, start - d)) / (2 * d.max()) for d in np.diag(h)]
    return CHARACTERISTIC_TIMES / np.abs(np.linalg.eigvals(np.transpose(nearby))).max()


def wandered(invariant, states):
    """How far an invariant goes from its start, relative to its size, or to what one number of the state adds to it.

    A momentum that is zero has no size of its own.
    """
    values = np.array([np.ravel(invariant(state)) for state in states])
    worth = [np.ravel(invariant(states[0] * (1 - 0.1 * one))) - values[0] for one in np.eye(states.shape[1])]
    size = max(np.linalg.norm(values, axis=1).max(), 10 * np.linalg.norm(worth, axis=1).max())
    return np.linalg.norm(values - values[0], axis=1).max() / size


# Where they are


def test_they_are_listed_by_date(capsys):
    assert cli.main(["list", "--lectures"]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert [line.split("  ")[0] for line in lines] == [lecture.date for lecture in catalogue().values()]
    days = [lecture.day for lecture in catalogue().values()]
    assert days == sorted(days) and len(lines) == len(names()) > 0


def test_a_wrong_name_is_told_with_the_right_ones(capsys):
    with pytest.raises(Unknown, match="'tpo'.*oscillator"):
        load("tpo")
    for command in ("show", "start"):
        assert cli.main([command, "tpo"]) == 2
        assert re.search("neither.*did you mean top.*list --lectures", " ".join(capsys.readouterr().err.split()))


@pytest.mark.parametrize("name", first(8, names()))
def test_one_is_loaded_without_the_others(name):
    code = f"import sys; from tam570.lectures import load; load({name!r}); print(*sys.modules)"
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    modules = set(run.stdout.split())
    assert not modules & {f"tam570.lectures.{other}" for other in names() if other != name}
    assert not {module.partition(".")[0] for module in modules} & {"matplotlib", "sympy", "scipy", "PIL"}


@pytest.mark.parametrize("name", names())
def test_it_is_short(name):
    assert len(catalogue()[name].file.read_text().splitlines()) <= LONGEST


# What they have


@pytest.mark.parametrize("name", MOVING)
def test_state_start_and_parameters_fit_together(name):
    module = load(name)
    assert len(module.STATE) == len(module.START) and isinstance(module.START, tuple)
    assert all(type(value) is float for value in (*module.START, module.SECONDS)) and module.SECONDS > 0
    assert all(isinstance(unit, str) for unit in module.STATE.values())
    for function in (module.rates, *module.INVARIANTS.values(), *([module.exact] if name in EXACT else [])):
        keywords = [p for p in inspect.signature(function).parameters.values() if p.kind is p.KEYWORD_ONLY]
        assert {p.name for p in keywords} == set(module.EXAMPLE) and all(p.default is p.empty for p in keywords)


@pytest.mark.parametrize("name", MOVING)
def test_rates_are_plain_floats(name):
    rates, _, start = parts(name)
    found = rates(0.0, tuple(start.tolist()))
    assert len(found) == len(start) and all(type(rate) is float for rate in found)


@pytest.mark.parametrize("name", MOVING)
@pytest.mark.parametrize("wrong", [math.nan, math.inf, "many", None])
def test_a_parameter_that_is_no_number_is_refused_by_name(name, wrong):
    module = load(name)
    for parameter in module.EXAMPLE:
        with pytest.raises(ValueError, match=rf"\b{parameter}\b"):
            module.rates(0.0, module.START, **{**module.EXAMPLE, parameter: wrong})


@pytest.mark.parametrize("name", MOVING)
def test_a_mass_of_zero_is_refused(name):
    module = load(name)
    for parameter in {"mass", "masses"} & set(module.EXAMPLE):
        zero = 0.0 * np.asarray(module.EXAMPLE[parameter])
        for function in (module.rates, *([module.exact] if name in EXACT else [])):
            with pytest.raises(ValueError, match=rf"\b{parameter}\b"):
                t = 0.0 if function is module.rates else [0.0, 1.0]
                function(t, module.START, **{**module.EXAMPLE, parameter: zero if zero.ndim else 0.0})


@pytest.mark.parametrize("name", MOVING)
def test_a_state_of_another_shape_is_refused_by_name(name):
    module = load(name)
    for wrong in (module.START[:-1], [*module.START, 0.0], [module.START], 1.0):
        with pytest.raises(ValueError, match=r"\bstate\b"):
            module.rates(0.0, wrong, **module.EXAMPLE)


@pytest.mark.parametrize("name", MOVING)
def test_a_trial_state_beyond_the_physical_gives_numbers(name):
    """An integrator may ask anywhere; it takes the step again."""
    module = load(name)
    start = np.array(module.START)
    trials = [0 * start, np.ones_like(start), -start, 1e3 * start[::-1], *(start * (1 - np.eye(len(start))))]
    for function in (module.rates, *([module.wrong_rates] if hasattr(module, "wrong_rates") else [])):
        for trial in trials:
            found = function(0.0, trial.tolist(), **module.EXAMPLE)
            assert len(found) == len(start) and all(type(rate) is float for rate in found)


@pytest.mark.parametrize("name", first(8, MOVING))
def test_any_integrator_may_call_its_rates(name):
    module = load(name)
    for method in ("RK45", "DOP853", "Radau", "LSODA"):
        with np.errstate(all="ignore"):
            run = solve_ivp(
                lambda t, y: module.rates(t, y, **module.EXAMPLE), (0, module.SECONDS / 4), module.START, method=method
            )
        assert run.success


# What they keep


@pytest.mark.parametrize("name", first(8, MOVING))
def test_invariants_stay_for_a_thousand_characteristic_times(name):
    rates, laws, start = parts(name)
    times = np.linspace(0.0, duration(name), 60)
    states = solve(rates, times, start, rtol=1e-13)
    for law, invariant in laws.items():
        assert wandered(invariant, states) < 1e-9, law  # a thousand times rtol would be 1e-10 if all errors added up


@pytest.mark.parametrize("name", MOVING)
def test_rates_that_are_a_thousandth_off_break_a_law(name):
    """One rate after the other, of all those that an invariant depends on."""
    rates, laws, start = parts(name)
    short = load(name).SECONDS if name in ENDING else min(duration(name) / 30, load(name).SECONDS)
    times = np.linspace(0.0, short, 60)
    for j, one in enumerate(np.eye(len(start))):
        if all(np.allclose(law(start + 0.01 * one), law(start), rtol=1e-9) for law in laws.values()):
            continue
        at_rest = rates(0.0, start.tolist())[j] == 0.0
        states = solve(wrong, times, start, parameters={"rates": rates, "one": one, "at_rest": at_rest}, rtol=1e-9)
        assert max(wandered(law, states) for law in laws.values()) > 1e-6, j


def wrong(t, state, *, rates, one, at_rest):
    """One of the rates a thousandth too large; where it may stay zero, by a thousandth."""
    return (1 + 0.001 * one) * rates(t, state) + 0.001 * at_rest * one


@pytest.mark.parametrize("name", EXACT)
@pytest.mark.parametrize("begin", [0.0, -2.5])
def test_the_exact_motion_is_the_solved_one(name, begin):
    module = load(name)
    rates, _, start = parts(name)
    times = begin + np.linspace(0.0, module.SECONDS, 40)
    exact, solved = module.exact(times, start, **module.EXAMPLE), solve(rates, times, start, rtol=1e-12)
    assert exact.shape == solved.shape and exact[0] == pytest.approx(start, rel=1e-14, abs=1e-14)
    assert np.abs(exact - solved).max() < 1e-8 * np.abs(solved).max()  # what the solution loses in these seconds


# What is seen of them


@pytest.mark.parametrize("name", names())
def test_its_film_shows_its_laws_on_a_small_page(name):
    shown = show(load(name))
    assert shown.scene is not None, shown.trouble
    scenes = shown.scene.slider.scenes if shown.scene.slider else [shown.scene]
    assert not any(scene.notes or any(time_plot.alarm for time_plot in scene.time_plots) for scene in scenes)
    assert len(shown.scene.alt_text) > 60
    assert len(page(shown.scene).encode()) < LARGEST


@pytest.mark.parametrize("name", MOVING)
def test_its_film_solves_for_the_samples_that_it_shows(name, monkeypatch):
    module, asked = load(name), []

    def counted(rates, t, *rest, **options):
        if rates is module.rates and len(t) > 2:
            asked.append(len(t))
        return solve(rates, t, *rest, **options)

    monkeypatch.setattr(module, "solve", counted, raising=False)
    scene = show(module).scene
    shown = {len(one.times) for one in (scene.slider.scenes if scene.slider else [scene])}
    assert set(asked) <= shown


@pytest.mark.parametrize("name", names())
def test_a_copy_plays_with_other_numbers(name, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    module = load(name)
    number = next((p for p, value in module.EXAMPLE.items() if isinstance(value, float)), None)
    change = ["--set", f"{number}={1.01 * module.EXAMPLE[number]}"] if number else []
    assert cli.main(["start", name]) == 0 and cli.main(["start", name]) == 0
    assert cli.main(["show", f"{name}.py", *change, "--save", "copy.html"]) == 0
    said = capsys.readouterr()
    assert "stays as it is" in said.out and not said.err
    assert (tmp_path / "copy.html").stat().st_size < LARGEST


def test_what_cannot_be_shown_is_said(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    wrong = {
        "mass=0": (1, "mass: must be positive|mass: must be a positive"),
        "seconds=-1": (1, "seconds: "),
        "seconds=1e9": (1, "seconds: at most"),
        "start.vx=nan": (1, "start.vx: "),
        "weight=2": (2, "'weight'.*mass, stiffness, start.x"),
        "mass": (2, "NAME=VALUE"),
    }
    for text, (code, said) in wrong.items():
        assert cli.main(["show", "oscillator", "--set", text, "--save", "a.html"]) == code
        assert re.search(said, " ".join(capsys.readouterr().err.split()))
    assert not (tmp_path / "a.html").exists()
