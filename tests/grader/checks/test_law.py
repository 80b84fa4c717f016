"""A law is a check: it judges the student's function of the right one's name over cases that are drawn in turn."""

from types import SimpleNamespace

import numpy as np
import pytest

from tam570_grader.checks.case import Case
from tam570_grader.checks.check import check
from tam570_grader.checks.compare import by_kind
from tam570_grader.checks.expect import Failed, check_context
from tam570_grader.checks.laws import law
from tam570_grader.checks.returns import number

WORTH = {"points": 2, "part": "b"}


def root(x):
    return x**0.5


def student(function, seen=None):
    """A student whose `root` is this function; what it is called with is noted in `seen`."""

    def each(cases):
        for case in cases:
            if seen is not None:
                seen.append(case)
            yield case, function(*case.args)

    def refused(x):
        try:
            function(x)
        except ValueError:
            return True
        return False

    def refusals(cases):
        return ((case, refused(*case.args)) for case in cases)

    return SimpleNamespace(root=SimpleNamespace(name="root", returns=number, each=each, refusals=refusals))


def drawn(rng):
    return [Case(rng.uniform(1, 2)).labelled("a random x")]


def judged(one, function, seen=None):
    with check_context():
        one.judge(student(function, seen), np.random.default_rng(1))


def test_a_law_is_a_check_with_the_line_that_a_student_reads():
    one = law("root: the positive root.", **WORTH).agrees(root, drawn, tolerance=1e-9)
    assert (one.line, one.points, one.part, one.after) == ("root: the positive root.", 2.0, "b", ())


def test_it_passes_what_is_right_and_fails_what_is_not():
    one = law("root: the positive root.", **WORTH).agrees(root, drawn, tolerance=1e-9)
    judged(one, root)
    with pytest.raises(Failed):
        judged(one, lambda x: -root(x))


def test_cases_are_drawn_in_turn_and_all_judged():
    seen, rng = [], np.random.default_rng(1)
    judged(law("root", **WORTH).agrees(root, drawn, drawn, tolerance=1e-9), root, seen)
    assert [case.args for case in seen] == [case.args for _ in range(2) for case in drawn(rng)]


def test_refusals_stand_behind_a_right_answer():
    one = law("root", **WORTH).refuses(root, drawn, lambda rng: [Case(-1.0).labelled("x = -1")], tolerance=1e-9)

    def positive(x):
        if x < 0:
            raise ValueError
        return root(x)

    judged(one, positive)
    for wrong in (lambda x: root(abs(x)), lambda x: 2 * positive(x)):  # refuses nothing; is wrong where it answers
        with pytest.raises(Failed):
            judged(one, wrong)


def test_also_judges_more_behind_what_was_judged():
    seen, beyond = [], lambda rng: [Case(-4.0)]
    one = law("root", **WORTH).agrees(root, drawn, tolerance=1e-9).also.refuses(root, beyond, tolerance=1e-9, allowed=0)
    assert (one.line, one.points, one.part) == ("root", 2.0, "b")
    for wrong in (root, lambda x: -root(x)):  # refuses nothing; is wrong from the start
        with pytest.raises(Failed):
            judged(one, wrong, seen)
    assert len(seen) == 2  # both were asked for the first case


def test_a_call_is_cut_to_what_the_right_function_takes():
    seen, more = [], lambda rng: [Case(4.0, 7.0, mass=2.0).labelled("more than it takes")]
    judged(law("root", **WORTH).agrees(root, more, tolerance=1e-9), root, seen)
    assert seen == [Case(4.0).labelled("more than it takes")]


def test_a_hint_may_depend_on_the_kind_of_input():
    hint = by_kind({"a root": "Is it positive?"}, "Look at y^2.")
    one = law("root", **WORTH).agrees(root, drawn, tolerance=1e-9, hint=hint)
    other = law("root", **WORTH).agrees(
        root, lambda rng: [Case(4.0).labelled("a root of 4")], tolerance=1e-9, hint=hint
    )
    for check_, message in ((one, "Look at y^2."), (other, "Is it positive?")):
        with pytest.raises(Failed) as failed:
            judged(check_, lambda x: -root(x))
        assert failed.value.failure.hint == message


def test_what_builds_on_a_check_names_it():
    @check(points=1, part="a")
    def first(student, rng):
        """The first."""

    second = law("root", **WORTH, after=first).agrees(root, drawn, tolerance=1e-9)
    assert second.after == (first,)
    assert second.then("root", **WORTH).agrees(root, drawn, tolerance=1e-9).after == (second,)


def test_a_judge_of_ones_own_is_given_the_function_and_what_was_drawn():
    told = []

    def judge(function, calls, *, tolerance):
        told.append((function.name, len(calls), tolerance))

    judged(law("root", **WORTH).judged(judge, "root", drawn, drawn, tolerance=1e-9), root)
    assert told == [("root", 2, 1e-9)]


def test_a_call_may_have_arguments_before_its_own():
    case = Case(2.0, mass=1.0).labelled("a random x").with_leading(0.5)
    assert (case.args, case.kwargs, case.label) == ((0.5, 2.0), {"mass": 1.0}, "a random x")
