"""Events, motions as functions of time, times that decrease, and reports."""

import math

import numpy as np
import pytest
from systems import EPS, oscillator

from tam570.integrate import solve


def thrown(t, y):
    """Return the rates of a throw, whose motion is a polynomial: one step covers any time."""
    return y[1], -10.0


def event(value, direction=0.0, terminal=False):
    value.direction, value.terminal = direction, terminal
    return value


def height(level):
    return lambda t, y: y[0] - level


@pytest.mark.parametrize("rtol", [1e-6, 1e-10, 1e-13])
def test_zeros_are_found_to_the_tolerance(rtol):
    motion = solve(oscillator, [0, 30], [1.0, 0.0], events=event(lambda t, y: y[0]), rtol=rtol)
    exact = math.pi * (np.arange(len(motion.events[0].t)) + 0.5)
    assert len(exact) == 10  # 30 / pi
    assert np.abs(motion.events[0].t - exact).max() < 100 * rtol
    assert np.abs(motion.events[0].states[:, 0]).max() < 4 * EPS  # the polynomial locates the zeros to rounding


def test_a_direction_is_that_of_the_crossing():
    both, up, down = (event(lambda t, y: y[0], direction) for direction in (0.0, 1.0, -1.0))
    motion = solve(oscillator, [0, 30], [1.0, 0.0], events=[both, up, down])
    assert [len(crossings.t) for crossings in motion.events] == [10, 5, 5]
    assert np.sort(np.concatenate([motion.events[1].t, motion.events[2].t])).tolist() == motion.events[0].t.tolist()
    assert (motion.events[1].states[:, 1] > 0).all()
    assert (motion.events[2].states[:, 1] < 0).all()


def test_two_crossings_in_one_step_are_two():
    """Both crossings of a level near the top are events, though they are in a single step."""
    waves = event(lambda t, y: math.sin(50 * t))
    motion = solve(thrown, [0, 2.0], [0.0, 10.0], events=[event(height(4.95)), event(height(5 - 5e-6)), waves])
    assert motion.events[0].t == pytest.approx([0.9, 1.1], abs=1e-12)
    assert motion.events[1].t == pytest.approx([0.999, 1.001], abs=1e-11)
    assert motion.events[2].t == pytest.approx(np.arange(1, 32) * math.pi / 50, abs=1e-12)
    assert motion.report.steps < 20


def test_a_terminal_event_ends_the_run():
    t = np.linspace(0, 10, 101)
    motion = solve(thrown, t, [0.0, 10.0], events=event(height(0.0), terminal=True), dense=True)
    assert motion.events[0].t == pytest.approx([2.0], abs=1e-12)
    assert motion.t.tolist() == t[: len(motion.t)].tolist()
    assert motion.t[-1] <= motion.events[0].t[0] < motion.t[-1] + 0.1
    assert motion.states[:, 0] == pytest.approx(10 * motion.t - 5 * motion.t**2, abs=1e-11)
    with pytest.raises(ValueError, match=r"^t: the motion is known from 0 to 2, not at 2.5"):
        motion.at(2.5)


def test_a_touch_is_no_crossing_and_an_event_may_know_time_and_parameters():
    def touching(t, y, *, rate):
        return (t - 1.0) ** 2

    def timed(t, y, *, rate):
        return t - 0.3 * rate

    motion = solve(lambda t, y, *, rate: (rate,), [0, 2.0], [0.0], parameters={"rate": 2.0}, events=[touching, timed])
    assert len(motion.events[0].t) == 0
    assert motion.events[0].states.shape == (0, 1)
    assert motion.events[1].t == pytest.approx([0.6], abs=1e-15)


NO_COUNTS = [event(height(0.5), terminal=terminal) for terminal in (-1, 3.5, "yes", math.nan)]
NO_VALUES = [lambda t, y, value=value: value for value in (np.ones(1), True, np.False_, "up", None, 1j)]


@pytest.mark.parametrize("events", [lambda t: t, [1.0], *NO_COUNTS, *NO_VALUES])
def test_what_is_no_event_is_refused(events):
    with pytest.raises(ValueError, match="^events: "):
        solve(rising, [0, 1], [0.0], events=events)


def test_a_motion_as_a_function_of_time_is_the_motion():
    t = np.linspace(0, 20, 77)
    motion = solve(oscillator, t, [1.0, 0.0], dense=True, rtol=1e-12)
    assert (motion.at(t) == motion.states).mean() > 0.9  # except for rounding where a sample ends a step
    assert motion.at(t) == pytest.approx(motion.states, abs=4 * EPS)
    fine = np.linspace(0, 20, 1001)
    assert np.abs(motion.at(fine) - np.stack([np.cos(fine), -np.sin(fine)], 1)).max() < 1e-10
    assert motion.at(0.0).tolist() == [1.0, 0.0]
    assert motion.at(3.0).shape == (2,)
    assert motion.events == ()


def test_events_and_dense_change_no_step():
    t = np.linspace(0, 20, 77)
    plain = solve(oscillator, t, [1.0, 0.0], method="python")
    with_events = solve(oscillator, t, [1.0, 0.0], dense=True, events=lambda t, y: y[0])
    assert (with_events.states == plain).all()


def test_times_may_decrease():
    t = np.linspace(3.0, -2.0, 26)
    states = solve(lambda t, y: (y[0] * math.sin(t),), t, [math.exp(-math.cos(3.0))], rtol=1e-12)
    assert states[:, 0] == pytest.approx(np.exp(-np.cos(t)), rel=1e-10)
    for method in ("gauss", "python"):
        ends = solve(oscillator, [1.0, 0.0], [math.cos(1), -math.sin(1)], method=method, rtol=1e-12)[-1]
        assert ends == pytest.approx([1.0, 0.0], abs=1e-11)
    starts = np.array([[math.cos(1), -math.sin(1)]] * 20)
    assert solve(oscillator, [1.0, 0.0], starts)[:, -1] == pytest.approx(np.array([[1.0, 0.0]] * 20), abs=1e-8)


def test_events_of_a_run_that_goes_back_have_their_times():
    motion = solve(oscillator, [3.0, -3.0], [math.cos(3), -math.sin(3)], events=lambda t, y: y[0], dense=True)
    assert motion.events[0].t == pytest.approx([math.pi / 2, -math.pi / 2], abs=1e-8)
    assert motion.t.tolist() == [3.0, -3.0]
    assert motion.at(0.5) == pytest.approx([math.cos(0.5), -math.sin(0.5)], abs=1e-9)
    with pytest.raises(ArithmeticError, match=r"t = -1"):
        solve(lambda t, y: (-(y[0] ** 2),), [0, -2], [1.0])


def test_a_report_tells_how_the_run_went():
    calls = np.zeros(1)

    def branching(t, y):
        calls[0] += 1
        return (y[1], -y[0]) if y[0] > -9 else (0.0, 0.0)

    report = solve(branching, [0, 20.0], [1.0, 0.0], report=True).report
    assert report.engine == "Python"
    assert report.untraced_reason == "it may change what it keeps"
    assert report.evaluations == 12 * (report.steps + report.refusals)
    before, looks = 60, report.steps  # calls before the first step and in refused steps; one per step finds switches
    assert report.evaluations <= calls[0] < report.evaluations + before + looks
    assert solve(oscillator, [0, 20.0], [1.0, 0.0], report=True).report.untraced_reason == ""
    assert "spacing" in solve(lambda t, y: (np.spacing(t),), [0, 2], [0.0], report=True).report.unseen_reason
    assert report.atol.shape == (2,) and 0 < report.atol[0] <= 2e-10


def rising(t, y):
    return (1.0,)


def test_an_event_at_the_very_end_counts_by_its_direction():
    at_end = [event(lambda t, y: t - 1, direction) for direction in (0.0, 1.0, -1.0)]
    motion = solve(rising, [0, 1], [0.0], events=at_end)
    assert [crossings.t.tolist() for crossings in motion.events] == [[1.0], [1.0], []]


def test_of_two_terminal_events_the_earlier_ends_the_run_backwards_too():
    first, second = event(height(-0.4), terminal=True), event(height(-0.5), terminal=True)
    motion = solve(rising, [0, -1], [0.0], events=[second, first], dense=True)
    assert [crossings.t.size for crossings in motion.events] == [0, 1]
    assert motion.events[1].t[0] == pytest.approx(-0.4, abs=1e-12)
    assert motion.at(-0.2)[0] == pytest.approx(-0.2, abs=1e-12)
