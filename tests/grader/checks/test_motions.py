"""Comparison of motions: rates along the rows, errors that chaos amplifies, rows out of order, and their messages."""

from functools import cache, partial
from types import SimpleNamespace

import numpy as np
import pytest
from parameters import first
from scipy.integrate import solve_ivp

from tam570_grader.checks import motions
from tam570_grader.checks.case import Case
from tam570_grader.checks.compare import Column
from tam570_grader.checks.expect import Failed
from tam570_grader.checks.motions import BEHIND, NEARLY_FOLLOWS, ONE_ROW_AHEAD, TIGHT, ComparedMotion, diagnosed, obeys
from tam570_grader.checks.trajectory import OwnRates, compare_trajectory

LOOSE = """

def solve(rhs, t, y0, *, parameters=None, **_):
    from scipy.integrate import solve_ivp
    given = parameters or {}
    return solve_ivp(lambda s, y: rhs(s, y, **given), (t[0], t[-1]), y0, t_eval=t, rtol=1e-7, atol=1e-7).y.T
"""
TIMES = np.linspace(0, 30, 601)
START = np.array([1.0, 1.0, 20.0])
T = np.linspace(1, 7, 200)
RESTED = np.array([1.0, 0.0])
DAMPED = """

def simulate(t, phi, phi_dot, **cylinder):
    from scipy.integrate import solve_ivp
    def rates(_, y):
        return y[1], acceleration(*y, **cylinder) - {damping} * y[1]
    return solve_ivp(rates, (t[0], t[-1]), (phi, phi_dot), t_eval=t, rtol={tolerance}, atol={tolerance}).y.T
"""
FORGETS_WHERE_IT_STOPS = """
_right = simulate

def simulate(t, state, locked, **car):
    rows = _right(t, state, locked, **car)
    return rows * rows[:, 3:].any(axis=1)[:, None]
"""
CREEPING = """

def simulate(t, state, locked, **car):
    from scipy.integrate import solve_ivp
    arm = _axles(locked, car["front"], car["rear"])[1]
    def rates(s, y):
        sliding = math.hypot(y[3], arm * y[4])
        free = np.array(state_derivative(s, y, locked, **{**car, "friction": 0.0}))
        return free + sliding / math.hypot(sliding, 1e-2) * (np.array(state_derivative(s, y, locked, **car)) - free)
    return solve_ivp(rates, (t[0], t[-1]), state, "LSODA", t_eval=t, rtol=1e-9, atol=1e-9).y.T
"""


def lorenz(t, start, tolerance=1e-11):
    def rate(_, u):
        x, y, z = u
        return 10 * (y - x), x * (28 - z) - y, x * y - 8 / 3 * z

    return solve_ivp(rate, (t[0], t[-1]), start, "DOP853", t, rtol=tolerance, atol=tolerance).y.T


@cache
def exact():
    return lorenz(TIMES, START)


def leads(rows):
    return obeys(ComparedMotion(Case(TIMES, START), rows, exact(), np.full(3, 20.0), None, lorenz), everywhere=True)


@pytest.fixture(scope="module")
def careless():
    return lorenz(TIMES, START, 1e-5)


def grown(t, start, rate=-1):
    return start * np.exp(rate * (t - t[0]))[:, None]


@pytest.mark.parametrize(
    ("own", "are_its"),
    [
        (lambda t, start: grown(t, start, 60 + 1e-9 * len(t)), True),  # a motion without bounds
        (lambda t, start: grown(t, start, 60) if len(t) == 2 else 1e9 * np.arange(1, 12)[:, None], False),
    ],
)
def test_a_motion_is_that_of_its_rates_unless_they_are_integrated_for_two_times_alone(own, are_its):
    student = SimpleNamespace(aside=lambda case: own(*case.args))
    case = Case(np.linspace(0, 1, 11), RESTED[:1])
    wrong = ComparedMotion(case, student.aside(case), grown(*case.args), np.ones(1), student, grown)
    assert motions.has_rates(wrong, motions.Rates(lambda t, row: 60 * row, lambda: True)) == are_its


@pytest.mark.parametrize("factor", [1.0, 1.1])
def test_rows_on_a_constraint_follow_from_wrong_rates_unless_the_motion_adds_a_slip(factor):
    def on_parabola(t, start, rate=1.0):
        x = start[0] + rate * (t - t[0])
        return np.column_stack([x, x**2])

    student = SimpleNamespace(aside=lambda case: on_parabola(*case.args, 2 * factor))
    case = Case(np.linspace(0, 1, 11), np.ones(2))
    wrong = ComparedMotion(case, student.aside(case), on_parabola(*case.args), np.ones(2), student, on_parabola)
    rates = motions.Rates(
        lambda t, row: (2.0, 2 * row[0]),
        lambda: True,
        truth=lambda t, row: (1.0, 2 * row[0]),
        doubled=lambda index, case: on_parabola(*case.args, 2 * factor * (2 - index)),
    )
    assert motions.has_rates(wrong, rates) == (factor == 1)


def test_errors_that_chaos_makes_large_break_no_equation(careless):
    assert np.abs(careless - exact()).max() > 10
    assert leads(careless)


def test_rows_of_another_time_in_another_order_or_at_rest_break_them(careless):
    for row in (1, 300, 600):
        assert not leads(np.vstack([careless[:row], careless[(row + 100) % 601], careless[row + 1 :]]))
    assert not leads(careless[::-1])
    assert not leads(np.vstack([careless[:1], careless[:0:-1]]))
    assert not leads(np.tile(careless[0], (601, 1)))


@pytest.mark.parametrize("number", first(1, [0, 2]))
def test_the_energy_of_a_double_pendulum_is_judged_at_a_loose_tolerance(grade, solution_text, number):
    slug = "hw07_double_pendulum"
    marks = {check.name: check for check in grade(slug, solution_text(slug) + LOOSE, number, naming=False).checks}
    energy = marks["energy_is_conserved_from_horizontal"]
    assert energy.points >= 0.9 * energy.max_points


def swings(t, start, tolerance=1e-10, damping=0.0):
    """Return the motion of a pendulum of unit frequency."""

    def rate(_, y):
        return y[1], -np.sin(y[0]) - damping * y[1]

    return solve_ivp(rate, (t[0], t[-1]), start, "RK45", t, rtol=tolerance, atol=tolerance).y.T


def reported(simulate, t=T, near_miss=0.0):
    actual = simulate(t, RESTED)
    function = SimpleNamespace(aside=lambda case: simulate(*case.args))  # called with other times
    item = ComparedMotion(Case(t, RESTED), actual, swings(t, RESTED), np.ones(2), function, swings)
    return diagnosed(item, [item], [], near_miss)


@pytest.mark.parametrize("tolerance", first(1, [1e-5, 1e-4, 1e-6]))
@pytest.mark.parametrize("t", first(1, [T[[0, 199]], T]))
def test_a_loose_tolerance_is_told_from_a_small_term(tolerance, t):
    assert reported(partial(swings, tolerance=tolerance), t) == TIGHT
    assert reported(partial(swings, damping=tolerance), t, near_miss=1e-3) == ""
    assert reported(partial(swings, tolerance=1e-6, damping=tolerance), t, near_miss=1e-3) != TIGHT


def test_a_jump_is_told_from_a_loose_tolerance():
    def comes_to_rest(t, start):
        return np.where((t < t[0] + 0.8 * T[-1])[:, np.newaxis], swings(t, start, 1e-5), 0.0)

    assert reported(comes_to_rest, T[::10]) == ""


@pytest.mark.parametrize(("factor", "are_right"), [(1.0, True), (1.01, False), (None, False)])
def test_a_hint_tells_whether_the_students_own_rates_are_right(factor, are_right):
    def rates(case):
        if factor is None:
            raise Failed("it raised")
        return factor * np.flip(case.args[0])

    rows, function = swings(T, RESTED), SimpleNamespace(name="rates", returns=None, aside=rates)
    own_rates = OwnRates("rates", lambda row: np.flip(row), lambda t, row: (row,))
    simulate = SimpleNamespace(student=SimpleNamespace(rates=function))
    assert own_rates.are_right(ComparedMotion(Case(T, RESTED), rows, rows, np.ones(2), simulate, swings)) == are_right


def test_a_later_call_that_raises_follows_from_the_rates_along_its_motion():
    def many(cases):
        if len(cases) == 1:
            return [swings(*cases[0].args)]
        raise Failed("it raised", at=cases[-1])

    rates = SimpleNamespace(source=lambda motion, ends: f"rates of {len(motion.t)} times")
    returns = SimpleNamespace(columns=[Column("x", "m", [0, 1])], rates=rates)
    function = SimpleNamespace(name="swings", returns=returns, many=many)
    with pytest.raises(Failed) as failed:
        compare_trajectory(function, swings, [Case(T[:n], RESTED) for n in (200, 30, 20)], tolerance=1e-3)
    assert failed.value.failure.follows_from == "rates of 20 times"


def test_where_the_function_cannot_be_asked_nobody_is_told_that_the_physics_is_right():
    times = T[::20]

    def once(t, start):
        if len(t) != len(times):
            raise Failed("it raised")
        return swings(t, start, 1e-5)

    assert reported(once, times) == NEARLY_FOLLOWS


@pytest.mark.parametrize(
    ("change", "message"),
    [
        (lambda rows: np.vstack([rows[1:], rows[-1:]]), ONE_ROW_AHEAD),
        (lambda rows: np.vstack([rows[:1], rows[2:], rows[-1:]]), ONE_ROW_AHEAD),
        (lambda rows: np.vstack([rows[:1], rows[:-1]]), BEHIND),
        (lambda rows: rows[:, ::-1], "The columns are in another order"),
        (lambda rows: 0 * rows, "Every number is zero"),
        (lambda rows: 0 * rows + rows[0], "Every row is the start"),
        (lambda rows: 0 * rows + rows[-1], motions.ALL_THE_LAST),
        (lambda rows: np.vstack([rows[:1], swings(T[::20], RESTED + 0.5)[1:]]), motions.FROM_ELSEWHERE),
        (lambda rows: np.vstack([rows[:1] + 1, rows[1:]]), "Row 0 is not the start"),
        (lambda rows: np.column_stack([abs(rows[:, 0]), rows[:, 1]]), motions.SIGNS),
    ],
)
def test_rows_of_another_order_are_told(change, message):
    t = T[::20]
    assert reported(lambda t, start: change(swings(t, start)), t) == message


@pytest.mark.parametrize(
    ("slug", "text", "reference"),
    first(
        1,
        [
            ("hw13_rolling_cylinder", DAMPED.format(damping=1e-3, tolerance=1e-9), False),
            ("hw13_rolling_cylinder", DAMPED.format(damping=1e-5, tolerance=1e-9), False),
            ("hw13_rolling_cylinder", DAMPED.format(damping=0, tolerance=1e-5), True),
            ("hw06_braking", CREEPING, False),
        ],
    ),
)
def test_wrong_physics_of_small_effect_is_not_called_right(grade, solution_text, slug, text, reference):
    checks = grade(slug, solution_text(slug) + text, naming=False).checks
    said = " ".join(check.message for check in checks if check.failure)
    assert ("The physics is right" in said) == reference
    assert "is wrong by" in said


def test_rows_after_a_stop_are_wrong_in_the_check_of_stops_alone(grade, solution_text):
    text = solution_text("hw06_braking") + FORGETS_WHERE_IT_STOPS
    checks = grade("hw06_braking", text, 570, naming=False).checks
    assert [check.name for check in checks if check.outcome == "failed"] == ["simulate_comes_to_rest_and_stays"]


@pytest.mark.parametrize(("count", "step"), first(1, [(3, 0.2), (3, 2.3), (200, 0.011)]))
def test_rows_of_other_times_than_those_that_are_asked_for(count, step):
    t = np.linspace(1, 3, count) ** 1.5

    def own_times(t, start, factor=1.0):
        return swings(1 + step * np.arange(len(t)), start) * [1, factor]

    assert "at other times" in reported(own_times, t)
    assert "at other times" not in reported(partial(own_times, factor=1.01), t)
