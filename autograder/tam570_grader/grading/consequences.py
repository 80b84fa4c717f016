"""Judge consequential errors: name the cause of each failure once, and charge only a part for what follows from it."""

import re
from collections import defaultdict
from collections.abc import Callable, Container, Iterable, Mapping, Sequence, Set
from contextlib import suppress
from dataclasses import dataclass, field, replace
from functools import partial

import numpy as np
from numpy.typing import NDArray

from tam570.checking.transforms import parts
from tam570.meter import Exhausted, Meter
from tam570.values import Numbers
from tam570_grader.checks.assignments import LoadedAssignment, checks_folder
from tam570_grader.checks.case import Call, Case
from tam570_grader.checks.check import Check
from tam570_grader.checks.expect import LONGEST_FAULT, Failed, NotWritten, check_context
from tam570_grader.checks.failure import Failure
from tam570_grader.checks.motions import OF_ROWS, OF_STEPS, OF_TIMES, flat
from tam570_grader.checks.returns import FreeBodyDiagram
from tam570_grader.checks.student import StudentFunction
from tam570_grader.checks.trajectory import SETTING_OFF
from tam570_grader.diagnosis.cause import Cause
from tam570_grader.diagnosis.diagnose import diagnose, follows, is_refuted
from tam570_grader.diagnosis.helper_factor import same_factor
from tam570_grader.diagnosis.mistakes import (
    CANCELLED,
    WITHIN,
    all_numbers,
    answer,
    computed,
    explains,
    is_motion,
    largest,
    right_answer,
    same,
    solution_with,
    tolerance_of,
)
from tam570_grader.diagnosis.mutants import names_reached
from tam570_grader.diagnosis.search import shared_mutants
from tam570_grader.grading.budget import budget
from tam570_grader.grading.seeds import generator
from tam570_grader.reports.sentences import full_message
from tam570_grader.results.records import CheckResult
from tam570_grader.sandbox.function import WORK_ON_COPIES
from tam570_grader.sandbox.student import BudgetSpent, Student

FOLLOWING_SHARE = 2 / 3  # of the points, if the only fault is a mistake that an earlier check already charged
UNFIT = TypeError, ValueError, LookupError, ArithmeticError, AttributeError  # arguments or results differ in form
HELPER = re.compile(r"\bdef (\w+)\(")
REMEMBERS = "You keep something from one call to the next, in a global or a default argument; called first, {} is right"
SMALLER = 1e-3  # of its error is left if a call is right in a new process
MOST_HELPERS, MOST_ASKED, MOST_BESIDE = 30, 4, 8  # helpers of a file, calls compared, passing calls added to a search
MOST_SHARED = 3_000_000  # steps for `_same_mutant` in a submission; a mistake in a helper takes a hundredth
Reproduced = tuple[tuple[Call, ...], Set[str]]


@dataclass(frozen=True)
class Unnamed:
    """A failure without a cause, with the calls of its check."""

    check: Check
    failed: Failed
    calls: tuple[Call, ...]


@dataclass(frozen=True)
class Run:
    """State of grading one submission: results and causes by check, and failures without a cause."""

    student: Student
    assignment: LoadedAssignment
    seed: int
    results: dict[str, CheckResult] = field(default_factory=dict)
    causes: dict[str, Cause] = field(default_factory=dict)
    unnamed: list[Unnamed] = field(default_factory=list)
    passing: list[Call] = field(default_factory=list)  # calls of checks that passed
    failing: list[Call] = field(default_factory=list)  # calls of checks that failed
    reproduced: dict[tuple[object, ...], Reproduced] = field(default_factory=dict)  # see `_asked_for`
    shared: Meter = field(default_factory=lambda: Meter(MOST_SHARED))  # steps left for `_same_mutant`

    def perform(self, check: Check, recorder: Callable[[float], None] | None = None) -> None:
        """Run a check; `student.calls` then contains only this check's calls."""
        self.student.calls.clear()
        wrong_before = not all(self.results[other.name].unlocks_dependents for other in check.after)
        context = check_context(recorder=recorder, aside=self.student.aside, wrong_before=wrong_before)
        with budget(), np.errstate(all="ignore"), context:
            check.run(self.student, generator(self.seed, self.assignment.slug, check))

    def with_numbers(self, calls: Iterable[Call]) -> list[Call]:
        """Return the calls without those that return a free body diagram, which has no numbers to compare."""
        return [call for call in calls if not isinstance(self.assignment.returns[call.name], FreeBodyDiagram)]

    def only_function(self, calls: Sequence[Call]) -> str:
        """Return the function of all these calls; "" if they call several, or return a diagram."""
        names = {call.name for call in calls}
        return names.pop() if len(names) == 1 and self.with_numbers(calls) else ""


def judge_failure(run: Run, check: Check, failed: Failed, *, naming: bool) -> CheckResult:
    """Return the result of a check that has just failed, with `naming` also its cause, which may explain earlier ones.

    An error in the search for the cause must not cost the student the score: the failure tells the instructor.
    """
    cause, fault = None, ""
    run.failing.extend(run.student.calls)
    if naming:
        try:
            with budget():
                cause = _cause(run, check, failed)
        except (Exhausted, MemoryError):
            pass
        except Exception as error:
            fault = repr(error)[:LONGEST_FAULT]
        cause = _earned(run, _told_once(run, check, failed, cause))
    if cause:
        run.causes[check.name] = cause
    else:
        run.unnamed.append(Unnamed(check, failed, tuple(run.student.calls)))
    if naming and not (cause and cause.follows_from):
        _tell_what_followed(run, check)
    return failure_result(check, failed, cause, fault)


def judge_blocked(run: Run) -> None:
    """Run the checks that a failure blocked: full points if they pass, a share if they fail only by its cause.

    A failure without a cause still blocks if the function was wrong for all inputs: later checks may pass by chance.
    """
    passable = {*run.causes, *(each.check.name for each in run.unnamed if _is_right_once(run, each.calls))}
    for check in run.assignment.checks if passable else ():
        before = {other.name: run.results[other.name] for other in check.after}
        ready = all(result.unlocks_dependents or name in passable for name, result in before.items())
        if run.results[check.name].outcome == "not_run" and ready and not run.results[check.name].unwritten:
            causes = [run.causes[name] for name in before if name in run.causes]
            causes = [cause for cause in causes if cause.follows_from != cause.function]  # the others repeat a cause
            unclear = [cause for cause in causes if not cause.answers and cause.source in ("own", "result")]
            try:
                with run.student.aside():
                    result = _consequence(run, check, {cause.follows_from or cause.function for cause in unclear})
            except BudgetSpent:
                return
            run.results[check.name] = result or run.results[check.name]
            passable |= run.causes.keys() & {check.name}


def passed_result(check: Check) -> CheckResult:
    """Return the result of a check that passed."""
    return CheckResult(check.name, check.part, check.points, check.points, "passed", check.title)


def failure_result(check: Check, failed: Failed, cause: Cause | None = None, fault: str = "") -> CheckResult:
    """Return the result of a check that failed; a share of the points is left if its cause was charged before."""
    suspect, follows_from = (cause.message or None, cause.follows_from) if cause else (None, "")
    share = max(failed.share, FOLLOWING_SHARE) if follows_from else failed.share
    failure = failed.failure
    failure = replace(failure, suspect=suspect, follows_from=follows_from, fault=fault or failure.fault)
    points, message = round(share * check.points, 6), full_message(failure)
    return CheckResult(check.name, check.part, points, check.points, "failed", message, suspect, failure)


def _cause(run: Run, check: Check, failed: Failed) -> Cause | None:
    """Return the mistake that explains a failed check's calls, or None."""
    earlier, assignment = _earlier(run.causes.values()), run.assignment
    solution, calls = assignment.solution, run.with_numbers(run.student.calls)
    done = [check for check in assignment.checks if check.name in run.results]
    wrong = {check.function for check in done if run.results[check.name].outcome != "passed"}
    search = partial(
        diagnose,
        solution,
        checks_folder(assignment.root, assignment.slug),
        earlier=earlier,
        is_told=failed.failure.hint in (*OF_TIMES, *OF_STEPS),
        passed={check.function for check in done} - wrong - {call.name for call in calls},
    )
    following = follows(solution, calls, earlier)
    own_source = None if following else _own_source(run, check, failed)
    cause = following or own_source or search(calls)
    if cause and not (following or own_source) and is_refuted(cause, run.passing):
        beside = [call for call in run.passing if call.name == cause.function and not is_motion(call)]
        cause = search([*calls, *beside[:MOST_BESIDE]])
        cause = None if cause and is_refuted(cause, run.passing) else cause
    pairs = {(before.function, before.follows_from) for before in run.causes.values()}
    is_new = cause and (cause.function, cause.follows_from) not in pairs
    is_common = cause and is_new and not own_source and cause.follows_from not in ("", cause.function)
    if cause and is_common and not _following(run, check, [*earlier, *_earlier([cause])]):
        cause = _own_source(run, check, failed) or search(calls, may_follow=False)
    if cause := cause or _memory(run, failed):
        return cause
    return Cause(failed.failure.function, "", "rule") if failed.failure.hint in OF_ROWS else None


def _told_once(run: Run, check: Check, failed: Failed, cause: Cause | None) -> Cause | None:
    """Return the cause, without words if a student reads them at an earlier failure, or if a helper has the mistake."""
    if not (cause and cause.follows_from) and (source := _shared_helper(run, check, cause, failed)):
        cause = replace(source, answers=cause.answers, calls=cause.calls) if cause else source
    if cause and cause.message:
        for before in run.unnamed:
            if before.check.function == check.function and follows(run.assignment.solution, before.calls, [cause]):
                _tell(run, before, cause)
                return replace(cause, message="", follows_from=cause.function)
    return cause


def _own_source(run: Run, check: Check, failed: Failed) -> Cause | None:
    """Return a cause that names the student's wrong function behind this failure, as the check or a solution shows."""
    calls, assignment, failure = run.student.calls, run.assignment, failed.failure
    before = [(result.failure.function, result.failure.hint) for result in run.results.values() if result.failure]
    is_rule = failure.hint in OF_ROWS or (failure.hint == WORK_ON_COPIES and _passes_on_copies(run, check))
    repeats_rule = is_rule and (failure.function, failure.hint) in before
    if source := failure.follows_from or (failure.function if repeats_rule else ""):
        return Cause(failure.function, "", "own", follows_from=source)
    if not (name := run.only_function(calls)):
        return None
    failures = (check.function for check in assignment.checks if _has_failed(run.results.get(check.name)))
    ruled_out = {*assignment.forbidden.get(name, ()), *_explained_by(run, name)}
    allowed = (other for other in dict.fromkeys(failures) if other not in ruled_out)
    source = next((other for other in allowed if _is_consequence(run, other, calls)), "")
    return Cause(name, "", "own", follows_from=source) if source else None


def _explained_by(run: Run, name: str) -> set[str]:
    """Return the functions whose failures follow, directly or not, from a mistake in this one."""
    explained = {name}
    while more := {cause.function for cause in run.causes.values() if cause.follows_from in explained} - explained:
        explained |= more
    return explained - {name}


def _memory(run: Run, failed: Failed) -> Cause | None:
    """Return the cause if the failed call is right in a new process, in which it is the first one."""
    failure, calls = failed.failure, run.with_numbers(run.student.calls)
    call = next((call for call in calls if call.case is failure.at and call.name == failure.function), None)
    if call is None:
        return None
    expected = right_answer(run.assignment.solution, call)
    with run.student.afresh(), suppress(Failed):
        result = getattr(run.student, call.name)(*call.case.args, **call.case.kwargs)
        is_right = same(result, expected, tolerance_of(call))
        if is_right and _error(result, expected) <= SMALLER * _error(call.result, expected):
            is_known = any(cause.source == "memory" and cause.function == call.name for cause in run.causes.values())
            message, source = ("", call.name) if is_known else (REMEMBERS.format(call.name), "")
            return Cause(call.name, message, "memory", follows_from=source)
    return None


def _error(result: Numbers, expected: Numbers) -> float:
    """Return the largest error of a result; infinite if it has another form."""
    pairs = [*zip(parts(result), _parts_like(result, expected), strict=False)] if result is not None else []
    if any(np.shape(number) != np.shape(true) for number, true in pairs) or not pairs:
        return np.inf
    with np.errstate(invalid="ignore"):  # infinity is right where infinity is expected
        errors = [np.where(np.equal(number, true), 0.0, np.abs(np.subtract(number, true))) for number, true in pairs]
    return max(float(error.max(initial=0.0)) for error in errors)


def _passes_on_copies(run: Run, check: Check) -> bool:
    """Return whether a check passes if the functions may change the arrays that they are given."""
    with run.student.aside(), run.student.on_copies():
        try:
            run.perform(check)
        except Exception:  # of any kind: the check does not pass
            return False
        return True


def _is_consequence(run: Run, wrong: str, calls: Sequence[Call]) -> bool:
    """Return whether a solution that calls `wrong`, with the student's functions in place, reproduces all calls."""
    name, assignment = calls[0].name, run.assignment
    causes = [cause for cause in run.causes.values() if not cause.follows_from]
    zeros = {cause.function for cause in causes if cause.source == "result" and not cause.answers}
    zeros -= {cause.function for cause in causes if cause.answers}  # these return zeros only in special cases
    sources = {wrong, *(cause.function for cause in run.causes.values() if cause.follows_from == wrong)}
    if any(is_motion(call) for call in calls):
        return False
    for text in assignment.solutions:
        used = (names_reached(text, name) & assignment.returns.keys()) - {name}
        if wrong in used and not used & zeros and _asked_for(run, text, used, calls) & sources:
            return True
    return False


def _asked_for(run: Run, text: str, used: Set[str], calls: Sequence[Call]) -> Set[str]:
    """Return which of these functions a solution calls that reproduces all calls with the student's in place, if any.

    Each earlier wrong function asks this of the same calls, so the answers are kept; the calls, too, for their ids.
    """
    key = text, *map(id, calls)
    if key not in run.reproduced:
        run.reproduced[key] = tuple(calls), (asked_for := set[str]())
        module = solution_with.__wrapped__(text, "")  # not the cached module: its functions are replaced
        for function in used:
            setattr(module, function, partial(_call_aside, asked_for, getattr(run.student, function)))
        try:
            with budget():
                is_reproduced = explains(run.assignment.solution, partial(computed, module), calls)
        except Exception:  # a solution may raise anything when a function that it calls is wrong
            is_reproduced = False
        if not is_reproduced:
            asked_for.clear()
    return run.reproduced[key][1]


def _shared_helper(run: Run, check: Check, cause: Cause | None, failed: Failed) -> Cause | None:
    """Return a cause that names an earlier wrong function with the same mistake, else None.

    If that one has no cause yet and calls this one, the mistake is here: report it as the cause there.

    One of the two must call the other, or both the same helper. In addition, both got the same diagnosis, or both fail
    with the same message at inputs with the same label, or they return the same wrong number where the right numbers
    are equal, or a solution that uses the other function (although the student may not call it) reproduces these
    results, or one mutant of code that a solution shares explains both, or one factor on what the helper returns makes
    both right.
    """
    student, results, calls = run.student, run.assignment.returns, run.student.calls
    if not (name := run.only_function(calls)):
        return None
    case = at if isinstance(at := _input_with_numbers(run, failed.failure), Case) else calls[0].case
    helpers = [helper for helper in dict.fromkeys(HELPER.findall(student.text)) if helper not in results][:MOST_HELPERS]
    explained, failures = _explained_by(run, name), dict[str, Failure]()  # first failure of each function
    refuted = defaultdict[str, set[str]](set)  # mutants of each solution that do not explain these calls
    for before in run.results.values():
        if _has_failed(before) and before.failure:
            failures.setdefault(before.failure.function, before.failure)
    for other, failure in failures.items():
        other_case = _input_with_numbers(run, failure)
        if failure.follows_from or other in ("", name, *explained) or not isinstance(other_case, Case):
            continue
        function, other_function = getattr(student, name), getattr(student, other)
        own_case, its_case = _shortened(function, case), _shortened(other_function, other_case)
        try:
            with budget():
                of_both = [
                    helper
                    for helper in helpers
                    if function.uses(helper, own_case) and other_function.uses(helper, its_case)
                ]
                calls_other, is_called = function.uses(other, own_case), other_function.uses(name, its_case)
                callers = [unnamed for unnamed in run.unnamed if unnamed.check.function == other]
                callers = callers if is_called and not calls_other else []
                if (calls_other or is_called or of_both) and (
                    (cause and cause.repeats == other)
                    or _same_words(failure, failed.failure)
                    or _all_change_arrays(run, [failure, failed.failure], [check, *(one.check for one in callers)])
                    or (other in run.assignment.forbidden.get(name, ()) and _is_consequence(run, other, calls))
                    or _same_mutant(run, Call(other, other_case, None), calls, refuted)
                    or any(
                        same_factor(run.assignment.solution, helper, function, other_function, other_case, calls)
                        for helper in of_both
                    )
                    or _same_number(run, other, calls)
                ):
                    for unnamed in callers:
                        _tell(run, unnamed, Cause(other, "", "own", follows_from=name))
                    return None if callers else Cause(name, "", "own", follows_from=other)
        except (Failed, NotWritten, Exhausted, *UNFIT):
            continue
    return None


def _input_with_numbers(run: Run, failure: Failure) -> object:
    """Return the input of a failure; if the failure has no numbers, an input that passed, if there is one."""
    passing = (call.case for call in run.passing if call.name == failure.function)
    return next(passing, failure.at) if failure.message else failure.at


def _shortened(function: StudentFunction, case: Case) -> Case:
    """Return the case; that of a motion with its first two times alone, close together: wrong ones may run away."""
    t = case.args[0] if case.args and getattr(function.returns, "rates", None) else None
    return case if t is None else case.replace(t[0] + SETTING_OFF * (t[:2] - t[0]))


def _same_words(before: Failure, failure: Failure) -> bool:
    """Return whether two functions fail with the same message at inputs with the same label (neither raises, say)."""
    is_same = before.message.replace(before.function, failure.function) == failure.message != ""
    return is_same and before.label == failure.label != ""


def _all_change_arrays(run: Run, failures: Iterable[Failure], checks: Iterable[Check]) -> bool:
    """Return whether functions fail only because they change the arrays that they are given."""
    return all(failure.hint == WORK_ON_COPIES for failure in failures) and all(
        _passes_on_copies(run, check) for check in checks
    )


def _same_number(run: Run, other: str, calls: Sequence[Call]) -> bool:
    """Return whether each wrong result equals a wrong result of function `other` whose right value is the same, too."""
    wrong, solution = 0, run.assignment.solution
    for call in calls[:MOST_ASKED]:
        other_result = getattr(run.student, other).aside(call.case)
        own_answer, other_answer = answer(solution, "", call), answer(solution, "", Call(other, call.case, None))
        others = list(zip(parts(other_result), _parts_like(other_result, other_answer), strict=True))
        for result, expected in zip(parts(call.result), _parts_like(call.result, own_answer), strict=True):
            if not same(result, expected, WITHIN):
                wrong += 1
                if not any(same(result, its, WITHIN) and same(expected, true, WITHIN) for its, true in others):
                    return False
    return wrong > 0


def _same_mutant(run: Run, before: Call, calls: Sequence[Call], refuted: Mapping[str, set[str]]) -> bool:
    """Return whether one mutant of code that two functions share in a solution explains calls of both."""
    name, solution = calls[0].name, run.assignment.solution
    is_possible = run.shared.remaining > 0 and not any(is_motion(call) for call in calls)
    for text in run.assignment.solutions if is_possible else ():
        with run.shared.running():
            answers = shared_mutants(text, name, before.name, calls, refuted[text])
        if answers:
            other = replace(before, result=getattr(run.student, before.name).aside(before.case))
            if any(explains(solution, answer, [other]) for answer in answers):
                return True
    return False


def _parts_like(result: Numbers, answer: Numbers) -> list[Numbers]:
    """Return the parts of an answer, as one array if the result is not a tuple (the answer may be one)."""
    return parts(answer) if isinstance(result, tuple) else [np.asarray(answer, float)]


def _call_aside(asked_for: set[str], function: StudentFunction, *args: Numbers, **kwargs: Numbers) -> Numbers:
    asked_for.add(function.name)
    try:
        return function.aside(Case(*args, **kwargs))
    except Failed as failed:  # `computed` turns ValueError into "no value"
        raise ValueError(str(failed)) from failed


def _earned(run: Run, cause: Cause | None) -> Cause | None:
    """Return the cause, but without a share if the function, or the one with the mistake, ignores its inputs."""
    if cause and cause.follows_from and any(_is_constant(run, name) for name in (cause.function, cause.follows_from)):
        return replace(cause, follows_from="") if cause.message else None
    return cause


def _is_constant(run: Run, name: str) -> bool:
    """Return whether a function gives the same numbers, or rows, for all inputs, although the right ones differ."""
    calls = run.with_numbers([*run.failing, *run.passing])
    calls = [call for call in calls if call.name == name and call.result is not None]
    with suppress(Exhausted, *UNFIT), budget():
        if calls and not _differ(calls, [call.result for call in calls]):
            expected = [right_answer(run.assignment.solution, call) for call in calls]
            pairs = [(call, value) for call, value in zip(calls, expected, strict=True) if value is not None]
            return bool(pairs) and _differ(*zip(*pairs, strict=True))
    return False


def _differ(calls: Sequence[Call], results: Sequence[Numbers]) -> bool:
    """Return whether numbers differ from call to call, between the rows of a motion, or between points, visibly."""
    rows = list[NDArray[np.float64]]()
    for call, result in zip(calls, results, strict=True):
        if is_motion(call):
            rows.extend(flat(result) - flat(result)[0])
        else:
            numbers = all_numbers(result)
            rows.extend(numbers[:, None] if call.case.points else [numbers])
    fewest = min(map(len, rows))
    numbers = np.array([row[:fewest] for row in rows])
    return not np.ptp(numbers, axis=0).max(initial=0.0) <= CANCELLED * max(1.0, np.abs(numbers).max(initial=0.0))


def _has_failed(result: CheckResult | None) -> bool:
    return result is not None and result.outcome == "failed" and not result.unlocks_dependents


def _earlier(causes: Iterable[Cause]) -> list[Cause]:
    """Return the causes from which later failures may follow, each with the function that has the mistake."""
    return [replace(cause, function=cause.follows_from or cause.function) for cause in causes if cause.answers]


def _tell_what_followed(run: Run, check: Check) -> None:
    """Report the cause of earlier undiagnosed failures that follow from this check's function."""
    for before in [*run.unnamed]:
        function, source = before.check.function, check.function
        is_allowed = source != function and source not in run.assignment.forbidden.get(function, ())
        is_alone = {call.name for call in before.calls} == {function}
        cause = Cause(function, "", "own", follows_from=source)
        if is_allowed and is_alone and _is_consequence(run, source, before.calls) and _earned(run, cause):
            _tell(run, before, cause)


def _tell(run: Run, unnamed: Unnamed, cause: Cause) -> None:
    """Replace the result of an undiagnosed failure by one with this cause."""
    name = unnamed.check.name
    run.unnamed.remove(unnamed)
    run.causes[name], run.results[name] = cause, failure_result(unnamed.check, unnamed.failed, cause)


def _following(run: Run, check: Check, earlier: Sequence[Cause]) -> Cause | None:
    """Run a failed check to its end; return the earlier cause that explains all its calls, else None."""
    with run.student.aside():
        try:
            run.perform(check, recorder=lambda error: None)
        except Exception:  # past its failure, the check computes with wrong numbers, such as rows of zeros
            return None
        calls = run.with_numbers(run.student.calls)
        return follows(run.assignment.solution, calls, earlier) if len(calls) == len(run.student.calls) else None


def _is_right_once(run: Run, calls: Sequence[Call]) -> bool:
    """Return whether a call gave the right numbers, other than zeros."""
    return any(
        largest(call.result) > CANCELLED
        and same(call.result, answer(run.assignment.solution, "", call), tolerance_of(call))
        for call in run.with_numbers(calls)
    )


def _consequence(run: Run, check: Check, unclear: Container[str]) -> CheckResult | None:
    """Return the result of a check that depends on wrong functions; None if it fails for a reason of its own.

    unclear : functions that are wrong throughout, such as zeros; a check that calls only these may pass by chance
    """
    try:
        run.perform(check)
    except Failed as failed:
        function = failed.failure.function  # if it hung before, it is not called again
        hung = (cause for cause in run.causes.values() if cause.function == function in run.student.broken)
        cause = _following(run, check, _earlier(run.causes.values())) or next(hung, None)
        cause = (
            cause or _own_source(run, check, failed) or _shared_helper(run, check, None, failed) or _memory(run, failed)
        )
        run.failing.extend(run.student.calls)
        if (cause := _earned(run, cause)) is None:
            return None
        run.causes[check.name] = cause
        return failure_result(check, failed, cause)
    except Exception:  # the check stays "not run"
        return None
    function_names = {call.name for call in run.student.calls} or {check.function}
    return passed_result(check) if any(name not in unclear for name in function_names) else None
