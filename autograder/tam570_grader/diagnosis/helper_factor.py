"""One mistake in two functions, shown by the helper that both call: one factor on its result makes both right."""

import inspect
from collections.abc import Callable, Sequence
from functools import partial

import numpy as np

from tam570.values import Numbers
from tam570_grader.checks.case import Call, Case
from tam570_grader.checks.student import StudentFunction
from tam570_grader.diagnosis.mistakes import WITHIN, all_numbers, is_motion, right_answer, same, solution_with

PLACES = -1, 0, 1, 2  # numbers of a helper's result to which the factor is applied; -1: all
FEWEST, MOST = 2, 4  # wrong calls compared
MOST_STEPS, STEP = 8, 1.1  # of the secant method, and the factor of its second value
CLOSE = 1e-9  # relative error at which it ends
SMALL = 1e-4  # a smaller factor proves nothing: many products are right if they are zero


def same_factor(
    solution: str, helper: str, function: StudentFunction, other: StudentFunction, before: Case, calls: Sequence[Call]
) -> bool:
    """Return whether the factor on a helper's result that makes the other function right makes this one right, too.

    Both are compared at the same arguments, as far as these have the same names.

    before : arguments of a wrong call of the other function
    calls  : calls of this function
    """
    wrong = [call for call in calls if not same(call.result, right_answer(solution, call), WITHIN)][:MOST]
    if len(wrong) < FEWEST or any(is_motion(call) for call in wrong):
        return False

    def makes_right(index: int) -> bool:
        """Return whether each wrong call becomes right; leave out calls for which there is no factor."""
        remaining = len(wrong)
        for call in wrong:
            case = _with_shared(solution, Call(other.name, before, None), call)
            expected = right_answer(solution, Call(other.name, case, None))
            factor = _factor(expected, partial(other.scaled, helper, index, call=case))
            if not factor:
                remaining -= 1
            elif not same(function.scaled(helper, index, factor, call.case), right_answer(solution, call), WITHIN):
                return False
            if remaining < FEWEST:
                return False
        return True

    return any(map(makes_right, PLACES))


def _with_shared(solution: str, before: Call, call: Call) -> Case:
    """Return the arguments of the first call, with those of the second that have the same names in their index."""
    module = solution_with(solution, "")
    values, shared = (
        inspect.signature(getattr(module, each.name)).bind(*each.case.args, **each.case.kwargs).arguments
        for each in (before, call)
    )
    values |= {name: shared[name] for name in values if name in shared}
    args = [values.pop(name) for name in [*values][: len(before.case.args)]]
    return Case(*args, **values)


@np.errstate(all="ignore")
def _factor(expected: Numbers, function: Callable[[float], Numbers]) -> float | None:
    """Return the factor with which the function returns the right numbers, 1 if these are right; None: none found."""
    target = all_numbers(expected)
    for power in (1, -1):  # results are often linear in the factor, or in one over it
        powers = [1.0, STEP]
        values = [all_numbers(function(number**power)) for number in powers]
        for _ in range(MOST_STEPS):
            if any(value.shape != target.shape or not np.all(np.isfinite([value, target])) for value in values):
                break
            index = int(np.argmax(np.abs(values[0] - target)))
            slope = (values[1][index] - values[0][index]) / (powers[1] - powers[0])
            if not slope:
                break
            powers = [powers[1], powers[1] + float((target[index] - values[1][index]) / slope)]
            if abs(powers[1]) < SMALL or powers[1] == powers[0]:
                break
            values = [values[1], all_numbers(function(powers[1] ** power))]
            if values[1].shape == target.shape and same(values[1], target, CLOSE):
                return powers[1] ** power
    return None
