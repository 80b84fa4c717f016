"""`replies.checked` checks the types, depth, size and number of replies in each mode, before the grader uses them."""

import itertools

import numpy as np
import pytest
from classes import HW08 as SLUG

from tam570_grader.protocol.wire import DEEPEST, LONGEST_TEXT, Foreign
from tam570_grader.sandbox import replies
from tam570_grader.sandbox.function import MOST_SEARCHED, _strangers
from tam570_grader.sandbox.process import ProcessLost
from tam570_grader.sandbox.zygote import ResourceLimits

LINE = {"points": np.zeros((12, 2)), "label": "path", "scatter": False, "shows": 1.0, "within": 1.0, "extent": 0.5}
DRAWN = {"lines": [LINE], "xlabel": "x (m)", "ylabel": "y (m)"}
DRAWN |= {"labels_show": [True, True], "scales": [1.0, 1.0], "bent": 0.0}


def value(sent, mode="value"):
    (reply,) = replies.checked({"replies": [{"value": sent, "changed": False}]}, mode)
    return reply["value"]


def nested(depth):
    built = 1.0
    for _ in range(depth):
        built = [built]
    return built


def drawing(**other):
    return value({**DRAWN, **other}, "drawing")


@pytest.mark.parametrize("sent", ["text", b"bytes", {"a": 1.0}, ["x" * 10**6, ""], [[b""]], 3, nested(DEEPEST + 2)])
def test_what_is_no_number_is_no_reply_of_a_call(sent):
    with pytest.raises(ProcessLost):
        value(sent)


@pytest.mark.parametrize("shape", [(2**40, 0), (0, 1999, 1999), (1, 2**50, 0)])
def test_an_array_of_no_number_stands_for_few_lists(shape):
    assert value(np.empty(shape)).shape == (0,)


@pytest.mark.parametrize("sent", [nested(900), "x" * 10**6, [nested(900)], [{"a": 1.0}], ["1+2j"], {"strangers": 1}])
def test_a_formula_has_numbers_alone(sent):
    try:
        actual = value(sent, "formula")
    except ProcessLost:
        return
    assert actual == {"strangers": []} or all(isinstance(item, float | Foreign | np.ndarray) for item in actual)


OTHERS = [{"lines": "many"}, {"lines": [[]]}, {"scales": [1.0, 1.0, 1.0]}, {"scales": [1.0, "1"]}, {"bent": None}]
OTHERS += [{"lines": [LINE] * 2001}, {"lines": [{**LINE, "shows": True}]}, {"lines": [{**LINE, "extent": np.ones(3)}]}]
OTHERS += [{"lines": [{**LINE, "points": points}]} for points in ([[0.0, 0.0]], np.zeros((12, 3)))]
OTHERS += [{"lines": [{**LINE, "points": np.zeros((2**20, 2))}] * 2}, {"labels_show": [1.0, 1.0]}]


@pytest.mark.parametrize("other", OTHERS)
def test_a_drawing_of_too_much_or_of_something_else_is_none(other):
    assert drawing(**other) is None


def test_a_drawing_has_short_labels_and_a_scatter_few_points():
    scatter = {**LINE, "points": np.zeros((10**6, 2)), "scatter": True, "label": r"\hspace{" * 10**5}
    built = drawing(lines=[scatter], xlabel=r"\hspace{" * 10**6, ylabel=7)
    assert len(built.xlabel) == len(built.lines[0].label) == LONGEST_TEXT and built.ylabel == ""
    assert len(built.lines[0].points) <= replies.MOST_SCATTERED


def test_a_symbol_is_named_if_it_is_among_the_first_words_of_the_file():
    strange = {"strangers": ["other", "q", "phi(t)"]}
    assert _strangers(strange, "phi = q2") == "phi(t)" and _strangers(strange, "x = q") == "q"
    assert _strangers(strange, "a " * MOST_SEARCHED + "q") == ""


@pytest.mark.parametrize("sent", [{"replies": []}, {"replies": [{"value": 1.0}] * 3}, {"values": np.empty((2**40, 0))}])
def test_a_message_has_as_many_replies_as_calls_at_most(sent):
    with pytest.raises(ProcessLost):
        replies.checked(sent, "value", most=2)


def test_results_alike_come_as_one_array():
    numbers, rows = (replies.checked({"values": sent}, "value", most=2) for sent in (np.arange(2.0), np.eye(2)))
    assert [reply["value"] for reply in numbers] == [0.0, 1.0]
    np.testing.assert_equal([reply["value"] for reply in rows], np.eye(2))


def test_reading_replies_counts_as_the_submissions_time(grade, solution_text, monkeypatch):
    """With a clock that advances by 0.5 s at each reading, reading the replies exceeds the time limit."""
    ticks = itertools.count(step=0.5)
    monkeypatch.setattr("tam570_grader.sandbox.process.time.thread_time", lambda: next(ticks))
    monkeypatch.setattr("tam570_grader.sandbox.process.SHORT", 0)
    result = grade(SLUG, solution_text(SLUG), limits=ResourceLimits(cpu=3))
    assert result.status == "timeout" and "processor time" in result.message
