"""A check is a function about one function of the student; compare and check_domain judge it over cases."""

from types import SimpleNamespace

import numpy as np
import pytest

from tam570_grader.checks.case import Case
from tam570_grader.checks.check import check, once
from tam570_grader.checks.compare import check_domain, compare
from tam570_grader.checks.expect import Failed, check_context
from tam570_grader.checks.returns import number


def root(x):
    return x**0.5


def student(function, seen=None):
    """A student whose `root` is this function; what it is called with is noted in `seen`."""

    def many(cases):
        if seen is not None:
            seen.extend(cases)
        return [function(*case.args) for case in cases]

    def refused(x):
        try:
            function(x)
        except ValueError:
            return True
        return False

    def refusals(cases):
        return ((case, refused(*case.args)) for case in cases)

    return SimpleNamespace(root=SimpleNamespace(name="root", returns=number, many=many, refusals=refusals))


def drawn(rng):
    return [Case(rng.uniform(1, 2)).labelled("a random x")]


@check("root", points=2)
def root_is_positive(student, rng):
    """the positive root."""
    compare(student.root, root, drawn(rng), tolerance=1e-9)


@check("root", points=1, part="b", after=root_is_positive, line="root raises ValueError for a negative number.")
def negative_numbers_have_no_root(student, rng):
    calls = [*drawn(rng), Case(-1.0).labelled("x = -1")]
    check_domain(student.root, root, calls, tolerance=1e-9)


def run(item, function, seen=None):
    with check_context():
        item.run(student(function, seen), np.random.default_rng(1))


def test_it_passes_what_is_right_and_fails_what_is_not():
    run(root_is_positive, root)
    with pytest.raises(Failed):
        run(root_is_positive, lambda x: -root(x))


def test_a_function_raises_beyond_its_domain_and_is_right_within():
    def positive(x):
        if x < 0:
            raise ValueError
        return root(x)

    run(negative_numbers_have_no_root, positive)
    for wrong in (lambda x: root(abs(x)), lambda x: 2 * positive(x)):  # raises nothing; is wrong where it answers
        with pytest.raises(Failed):
            run(negative_numbers_have_no_root, wrong)


def test_a_call_is_cut_to_what_the_reference_takes():
    seen = []
    compare(student(root, seen).root, root, [Case(4.0, 7.0, mass=2.0).labelled("more than it takes")], tolerance=1e-9)
    assert seen == [Case(4.0).labelled("more than it takes")]


@pytest.mark.parametrize(("mine", "said"), [("", "Look at y^2."), ("Is it positive?", "Is it positive?")])
def test_the_hint_of_a_case_goes_before_that_of_the_check(mine, said):
    with check_context(), pytest.raises(Failed) as failed:
        calls = [Case(4.0).labelled("a root of 4", mine)]
        compare(student(lambda x: -root(x)).root, root, calls, tolerance=1e-9, hint="Look at y^2.")
    assert failed.value.failure.hint == said


def test_an_array_that_is_drawn_once_a_run_may_be_changed_in_place():
    axis = once(lambda rng: rng.normal(size=3))
    drawn = axis(np.random.default_rng(5))
    changed = axis(np.random.default_rng(5))
    changed[0] = 7.0
    assert (axis(np.random.default_rng(5)) == drawn).all() and drawn[0] != 7.0
