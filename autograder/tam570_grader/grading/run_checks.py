"""Grade one submission: run the checks of its assignment in order and return the result."""

import functools
import re
import time
from collections.abc import Callable, Container, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field, replace
from functools import partial
from types import SimpleNamespace

import numpy as np
from numpy.typing import NDArray

from tam570.checking.transforms import parts
from tam570.meter import Exhausted
from tam570.values import Numbers
from tam570_grader.checks import assignments
from tam570_grader.checks.assignments import LoadedAssignment
from tam570_grader.checks.case import Call, Case
from tam570_grader.checks.check import Check
from tam570_grader.checks.expect import LONGEST_FAULT, Failed, NotWritten, check_context
from tam570_grader.checks.failure import Failure
from tam570_grader.checks.motions import OF_ROWS, OF_TIMES, flat
from tam570_grader.checks.returns import FreeBodyDiagram
from tam570_grader.checks.student import StudentFunction
from tam570_grader.checks.trajectory import SETTING_OFF
from tam570_grader.diagnosis.cause import Cause
from tam570_grader.diagnosis.diagnose import diagnose, follows, is_refuted
from tam570_grader.diagnosis.helper_factor import same_factor
from tam570_grader.diagnosis.mistakes import (
    CANCELLED,
    WITHIN,
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
from tam570_grader.grading.seeds import derive
from tam570_grader.grading.speed import speed_of
from tam570_grader.reports.sentences import full_message
from tam570_grader.results.records import CheckResult, Result
from tam570_grader.sandbox.function import WORK_ON_COPIES
from tam570_grader.sandbox.imports import NotLoaded
from tam570_grader.sandbox.launch import isolation
from tam570_grader.sandbox.pool import ONLY, Attempt
from tam570_grader.sandbox.student import BudgetSpent, Source, Student
from tam570_grader.sandbox.zygote import Zygote

OUR_FAULT = "The grader failed here, not you; your teacher has been told."
TOO_MUCH = "what it returns takes the grader too much {} to judge"
FOLLOWING_SHARE = 2 / 3  # of the points, if the only fault is a mistake that an earlier check already charged
UNFIT = TypeError, ValueError, LookupError, ArithmeticError, AttributeError  # arguments or results differ in form
HELPER = re.compile(r"\bdef (\w+)\(")
REMEMBERS = "You keep something from one call to the next, in a global or a default argument; called first, {} is right"
SMALLER = 1e-3  # of its error is left if a call is right in a new process
MOST_HELPERS, MOST_ASKED, MOST_BESIDE = 30, 4, 8  # helpers of a file, calls compared, passing calls added to a search
Recorder = Callable[[str, float], None]
Unnamed = tuple[Check, Failed, tuple[Call, ...]]


@dataclass(frozen=True)
class CheckOptions:
    """Options of a run of the checks; audits of the grader switch parts of it off.

    enough    : number of failed checks after which the rest are not run; None: run all
    recorder  : called with the name of the check and each error divided by its limit; then no comparison fails
    naming    : diagnose each failed check
    speed     : also measure the run time of the simulation, after the checks
    attempt   : which try of the submission this is
    """

    enough: int | None = None
    recorder: Recorder | None = None
    naming: bool = True
    speed: bool = False
    attempt: Attempt = ONLY


@dataclass(frozen=True)
class _Run:
    """State of grading one submission: results and causes by check, and failures without a cause."""

    student: Student
    assignment: LoadedAssignment
    seed: int
    options: CheckOptions
    results: dict[str, CheckResult] = field(default_factory=dict)
    causes: dict[str, Cause] = field(default_factory=dict)
    unnamed: list[Unnamed] = field(default_factory=list)
    passing: list[Call] = field(default_factory=list)  # calls of checks that passed
    failing: list[Call] = field(default_factory=list)  # calls of checks that failed

    def perform(self, check: Check, recorder: Callable[[float], None] | None = None) -> None:
        """Run a check; `student.calls` then contains only this check's calls."""
        self.student.calls.clear()
        wrong_before = not all(self.results[other.name].unlocks_dependents for other in check.after)
        context = check_context(recorder=recorder, aside=self.student.aside, wrong_before=wrong_before)
        with budget(), np.errstate(all="ignore"), context:
            check.run(self.student, generator(self.seed, self.assignment.slug, check))


def graded(
    name: str,
    source: Source,
    assignment: LoadedAssignment,
    zygote: Zygote,
    seed: int,
    options: CheckOptions = CheckOptions(),  # noqa: B008  it is frozen
) -> Result:
    """Grade one submission of the student `name`; the same submission and seed give the same score."""
    started = time.perf_counter()
    student = Student(source, assignment, zygote, options.attempt)
    run = _Run(student, assignment, seed, options)
    status, message, speed = "graded", "", None
    try:
        student.load()
        for check in assignment.checks:
            failed = sum(result.outcome == "failed" for result in run.results.values())
            if not options.enough or failed < options.enough:
                run.results[check.name] = _check_result(run, check)
        if student.skipped:
            message = f"Notebook cells that raised were skipped: {'; '.join(student.skipped)}"
        speed = speed_of(student, assignment, zygote) if options.speed else None
        if not options.enough:
            _judge_consequences(run)
    except (NotLoaded, BudgetSpent) as ended:
        status, message = ended.status, str(ended)
    finally:
        student.leave()
    message = " ".join(filter(None, (source.remark, message)))
    rest = tuple(run.results.get(check.name) or _not_run(check, message) for check in assignment.checks)
    seconds = time.perf_counter() - started
    return replace(_result(name, assignment, status, message, seed, rest), seconds=round(seconds, 3), speed=speed)


@dataclass(frozen=True)
class _NoStudent:
    """Stand-in for a student in `rehearse`: its functions have only `name` and `returns`, which comparisons read."""

    assignment: LoadedAssignment

    def __getattr__(self, name: str) -> SimpleNamespace:
        return SimpleNamespace(name=name, returns=self.assignment.returns[name])


def rehearse(assignment: LoadedAssignment, seed: int) -> None:
    """Run all checks without a submission, so that this process caches their expected results.

    A check that needs more of a student than results to compare ends early. Errors are ignored here: they recur, and
    are reported, when a submission is graded.
    """
    with np.errstate(all="ignore"):
        for check in assignment.checks:
            with suppress(Exception), budget(), check_context(is_rehearsal=True):
                check.run(_NoStudent(assignment), generator(seed, assignment.slug, check))


def not_graded(name: str, assignment: LoadedAssignment, status: str, message: str, seed: int) -> Result:
    """Return the result of a missing or unreadable submission: score 0, no check run."""
    check_results = tuple(_not_run(check, message) for check in assignment.checks)
    return _result(name, assignment, status, message, seed, check_results)


def failed_by_us(name: str, assignment: LoadedAssignment, error: str, seed: int) -> Result:
    """Return the result if the grader failed: no score."""
    check_results = tuple(_grader_error(check, error) for check in assignment.checks)
    return _result(name, assignment, "graded", OUR_FAULT, seed, check_results)


def generator(seed: int, slug: str, check: Check) -> np.random.Generator:
    """Return the random generator of a check's hidden inputs."""
    return np.random.Generator(np.random.PCG64(_seeds(seed, slug, check.name)))


@functools.lru_cache(maxsize=1024)
def _seeds(seed: int, slug: str, name: str) -> np.random.SeedSequence:
    """Return the seed sequence of a check's generator; cached because it takes longer to make than the generator."""
    return np.random.SeedSequence(derive(seed, slug, name))


def _result(
    name: str,
    assignment: LoadedAssignment,
    status: str,
    message: str,
    seed: int,
    check_results: tuple[CheckResult, ...],
) -> Result:
    points = [check_result.points for check_result in check_results]
    score = None if None in points else round(sum(p for p in points if p is not None), 6)
    most = assignment.max_score
    return Result(name, assignment.slug, status, score, most, seed, 0.0, isolation(), check_results, message)


def _check_result(run: _Run, check: Check) -> CheckResult:
    """Run one check and diagnose its failure; do not run it if a prerequisite is wrong or missing."""
    for other in check.after:
        before = run.results[other.name]
        if not (before.unlocks_dependents or (check.refusals and other.function in run.student.worked)):
            return _not_run(check, f"Not run: it needs “{other.title.rstrip('.')}” to pass first.")
    student, options = run.student, run.options
    try:
        run.perform(check, options.recorder and partial(options.recorder, check.name))
    except NotWritten as unwritten:
        return _not_run(check, student.describe_missing(str(unwritten)), unwritten=str(unwritten))
    except Failed as failed:
        run.failing.extend(student.calls)
        cause, fault = _cause(run, check, failed) if options.naming else (None, "")
        if options.naming and not (cause and cause.follows_from) and (source := _shared_helper(run, cause, failed)):
            cause = replace(source, answers=cause.answers, calls=cause.calls) if cause else source
        if cause and cause.message and _is_told_before(run, check, cause):
            cause = replace(cause, message="", follows_from=cause.function)
        if cause := _earned(run, cause):
            run.causes[check.name] = cause
        else:
            run.unnamed.append((check, failed, tuple(student.calls)))
        if options.naming and not (cause and cause.follows_from):
            _tell_what_followed(run, check)
        return _failed(check, failed, cause, fault)
    except (Exhausted, MemoryError) as spent:
        what = "memory" if isinstance(spent, MemoryError) else "work"
        failure = Failure(message=TOO_MUCH.format(what), at=student.calls[-1].case if student.calls else None)
        return _failed(check, Failed(**vars(failure)), None)
    except Exception as error:
        return _grader_error(check, repr(error))
    run.passing.extend(student.calls)
    return _passed(check)


def _cause(run: _Run, check: Check, failed: Failed) -> tuple[Cause | None, str]:
    """Return the mistake that explains a failed check's calls, or None, and the grader's error in the search, or ""."""
    earlier, assignment = _earlier(run.causes), run.assignment
    try:
        with budget():
            solution = assignment.solution
            calls = [call for call in run.student.calls if not _is_drawn(assignment, call)]
            folder = assignments.checks_folder(assignment.root, assignment.slug)
            done = [check for check in assignment.checks if check.name in run.results]
            wrong = {check.function for check in done if run.results[check.name].outcome != "passed"}
            passed = {check.function for check in done} - wrong - {call.name for call in calls}
            is_told = failed.failure.hint in OF_TIMES
            search = partial(diagnose, solution, folder, earlier=earlier, is_told=is_told, passed=passed)
            following = follows(solution, calls, earlier)
            own_source = None if following else _own_source(run, check, failed)
            cause = following or own_source or search(calls)
            if cause and not (following or own_source) and is_refuted(cause, run.passing):
                beside = [call for call in run.passing if call.name == cause.function and not is_motion(call)]
                cause = search([*calls, *beside[:MOST_BESIDE]])
                cause = None if cause and is_refuted(cause, run.passing) else cause
            pairs = {(before.function, before.follows_from) for before in run.causes.values()}
            is_new = cause and (cause.function, cause.follows_from) not in pairs
            if cause and is_new and not own_source and cause.follows_from not in ("", cause.function):
                common = _earlier({check.name: cause})
                if not _following(run, check, [*earlier, *common]):
                    cause = _own_source(run, check, failed) or search(calls, may_follow=False)
            cause = cause or _memory(run, failed)
            if cause is None and failed.failure.hint in OF_ROWS:
                cause = Cause(failed.failure.function, "", "rule")
            return cause, ""
    except (Exhausted, MemoryError):
        return None, ""
    except Exception as error:  # a fault of the diagnosis must not cost the student the score
        return None, repr(error)[:LONGEST_FAULT]


def _own_source(run: _Run, check: Check, failed: Failed) -> Cause | None:
    """Return a cause that names the student's wrong function behind this failure, as the check or a solution shows."""
    calls, assignment, failure = run.student.calls, run.assignment, failed.failure
    before = [(result.failure.function, result.failure.hint) for result in run.results.values() if result.failure]
    is_rule = failure.hint in OF_ROWS or (failure.hint == WORK_ON_COPIES and _passes_on_copies(run, check))
    repeats_rule = is_rule and (failure.function, failure.hint) in before
    if source := failure.follows_from or (failure.function if repeats_rule else ""):
        return Cause(failure.function, "", "own", follows_from=source)
    if len({call.name for call in calls}) != 1 or any(_is_drawn(assignment, call) for call in calls):
        return None
    name = calls[0].name
    failures = (check.function for check in assignment.checks if _has_failed(run.results.get(check.name)))
    allowed = (other for other in dict.fromkeys(failures) if other not in assignment.forbidden.get(name, ()))
    source = next((other for other in allowed if _is_consequence(run, other, calls)), "")
    return Cause(name, "", "own", follows_from=source) if source else None


def _memory(run: _Run, failed: Failed) -> Cause | None:
    """Return the cause if the failed call is right in a new process, in which it is the first one."""
    failure, calls = failed.failure, run.student.calls
    call = next((call for call in calls if call.case is failure.at and call.name == failure.function), None)
    if call is None or _is_drawn(run.assignment, call):
        return None
    expected = right_answer(run.assignment.solution, call)
    with run.student.afresh(), suppress(Failed):
        result = getattr(run.student, call.name)(*call.case.args, **call.case.kwargs)
        if same(result, expected, tolerance_of(call)) and _error(result, expected) <= SMALLER * _error(
            call.result, expected
        ):
            is_known = any(cause.source == "memory" and cause.function == call.name for cause in run.causes.values())
            message, source = ("", call.name) if is_known else (REMEMBERS.format(call.name), "")
            return Cause(call.name, message, "memory", follows_from=source)
    return None


def _error(result: Numbers, expected: Numbers) -> float:
    """Return the largest error of a result; infinite if it has another form."""
    pairs = [*zip(parts(result), _parts_like(result, expected), strict=False)] if result is not None else []
    if any(np.shape(number) != np.shape(true) for number, true in pairs) or not pairs:
        return np.inf
    return max(float(np.abs(np.subtract(number, true)).max(initial=0.0)) for number, true in pairs)


def _passes_on_copies(run: _Run, check: Check) -> bool:
    """Return whether a check passes if the functions may change the arrays that they are given."""
    with run.student.aside(), run.student.on_copies():
        try:
            run.perform(check)
        except Exception:  # of any kind: the check does not pass
            return False
        return True


def _is_consequence(run: _Run, wrong: str, calls: Sequence[Call]) -> bool:
    """Return whether a solution that calls `wrong`, with the student's functions in place, reproduces all calls."""
    name, assignment = calls[0].name, run.assignment
    causes = [cause for cause in run.causes.values() if not cause.follows_from]
    zeros = {cause.function for cause in causes if cause.source == "result" and not cause.answers}
    zeros -= {cause.function for cause in causes if cause.answers}  # these return zeros only in special cases
    sources = {wrong, *(cause.function for cause in run.causes.values() if cause.follows_from == wrong)}
    if any(is_motion(call) for call in calls):
        return False
    for text in assignment.solutions:
        used, asked_for = (names_reached(text, name) & assignment.returns.keys()) - {name}, set[str]()
        if wrong not in used or used & zeros:
            continue
        module = solution_with.__wrapped__(text, "")  # not the cached module: its functions are replaced
        for function in used:
            setattr(module, function, partial(_call_aside, asked_for, getattr(run.student, function)))
        try:
            with budget():
                if explains(assignment.solution, partial(computed, module), calls) and asked_for & sources:
                    return True
        except Exception:  # a solution may raise anything when a function that it calls is wrong
            continue
    return False


def _shared_helper(run: _Run, cause: Cause | None, failed: Failed) -> Cause | None:
    """Return a cause that names an earlier wrong function with the same mistake, else None.

    One of the two must call the other, or both the same helper. In addition, both got the same diagnosis, or both fail
    with the same message at inputs with the same label, or they return the same wrong number where the right numbers
    are equal, or a solution that uses the other function (although the student may not call it) reproduces these
    results, or one mutant of code that a solution shares explains both, or one factor on what the helper returns makes
    both right.
    """
    student, results, calls = run.student, run.assignment.returns, run.student.calls
    name = calls[0].name if calls else ""
    if not calls or {call.name for call in calls} != {name} or any(_is_drawn(run.assignment, call) for call in calls):
        return None
    case = at if isinstance(at := _input_with_numbers(run, failed.failure), Case) else calls[0].case
    helpers = [helper for helper in dict.fromkeys(HELPER.findall(student.text)) if helper not in results][:MOST_HELPERS]
    failures: dict[str, Failure] = {}  # first failure of each function
    for before in run.results.values():
        if _has_failed(before) and before.failure:
            failures.setdefault(before.failure.function, before.failure)
    for other, failure in failures.items():
        other_case = _input_with_numbers(run, failure)
        if failure.follows_from or other in ("", name) or not isinstance(other_case, Case):
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
                calls_other = function.uses(other, own_case) or other_function.uses(name, its_case)
                if (calls_other or of_both) and (
                    (cause and cause.repeats == other)
                    or _same_words(failure, failed.failure)
                    or (other in run.assignment.forbidden.get(name, ()) and _is_consequence(run, other, calls))
                    or _same_mutant(run, Call(other, other_case, None), calls)
                    or any(
                        same_factor(run.assignment.solution, helper, function, other_function, other_case, calls)
                        for helper in of_both
                    )
                    or _same_number(run, other, calls)
                ):
                    return Cause(name, "", "own", follows_from=other)
        except (Failed, NotWritten, Exhausted, *UNFIT):
            continue
    return None


def _input_with_numbers(run: _Run, failure: Failure) -> object:
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


def _same_number(run: _Run, other: str, calls: Sequence[Call]) -> bool:
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


def _same_mutant(run: _Run, before: Call, calls: Sequence[Call]) -> bool:
    """Return whether one mutant of code that two functions share in a solution explains calls of both."""
    name, solution = calls[0].name, run.assignment.solution
    for text in run.assignment.solutions if not any(is_motion(call) for call in calls) else ():
        if answers := shared_mutants(text, name, before.name, calls):
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


def _earned(run: _Run, cause: Cause | None) -> Cause | None:
    """Return the cause, but without a share if the function, or the one with the mistake, ignores its inputs."""
    if cause and cause.follows_from and any(_is_constant(run, name) for name in (cause.function, cause.follows_from)):
        return replace(cause, follows_from="") if cause.message else None
    return cause


def _is_constant(run: _Run, name: str) -> bool:
    """Return whether a function gives the same numbers, or rows, for all inputs, although the right ones differ."""
    calls = [call for call in (*run.failing, *run.passing) if call.name == name and call.result is not None]
    calls = [call for call in calls if not _is_drawn(run.assignment, call)]
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
            numbers = np.concatenate([np.ravel(np.asarray(part, float)) for part in parts(result)])
            rows.extend(numbers[:, None] if call.case.points else [numbers])
    fewest = min(map(len, rows))
    numbers = np.array([row[:fewest] for row in rows])
    return not np.ptp(numbers, axis=0).max(initial=0.0) <= CANCELLED * max(1.0, np.abs(numbers).max(initial=0.0))


def _has_failed(result: CheckResult | None) -> bool:
    return result is not None and result.outcome == "failed" and not result.unlocks_dependents


def _earlier(causes: Mapping[str, Cause]) -> list[Cause]:
    """Return the causes from which later failures may follow, each with the function that has the mistake."""
    return [replace(cause, function=cause.follows_from or cause.function) for cause in causes.values() if cause.answers]


def _is_told_before(run: _Run, check: Check, cause: Cause) -> bool:
    """Report the cause at an undiagnosed earlier failure of this function if it explains that; return whether."""
    for before, failed, calls in run.unnamed:
        if before.function == check.function and follows(run.assignment.solution, calls, [cause]):
            _tell(run, (before, failed, calls), cause)
            return True
    return False


def _tell_what_followed(run: _Run, check: Check) -> None:
    """Report the cause of earlier undiagnosed failures that follow from this check's function."""
    for before, failed, calls in [*run.unnamed]:
        allowed = {before.function, *run.assignment.forbidden.get(before.function, ())}.isdisjoint([check.function])
        is_alone = {call.name for call in calls} == {before.function}
        cause = Cause(before.function, "", "own", follows_from=check.function)
        if allowed and is_alone and _is_consequence(run, check.function, calls) and _earned(run, cause):
            _tell(run, (before, failed, calls), cause)


def _tell(run: _Run, unnamed: Unnamed, cause: Cause) -> None:
    """Replace the result of an undiagnosed failure by one with this cause."""
    check, failed, _ = unnamed
    run.unnamed.remove(unnamed)
    run.causes[check.name] = cause
    run.results[check.name] = _failed(check, failed, cause)


def _following(run: _Run, check: Check, earlier: Sequence[Cause]) -> Cause | None:
    """Run a failed check to its end; return the earlier cause that explains all its calls, else None."""
    with run.student.aside():
        try:
            run.perform(check, recorder=lambda error: None)
        except Exception:  # past its failure, the check computes with wrong numbers, such as rows of zeros
            return None
        if any(_is_drawn(run.assignment, call) for call in run.student.calls):
            return None
        return follows(run.assignment.solution, run.student.calls, earlier)


def _judge_consequences(run: _Run) -> None:
    """Run the checks that a failure blocked: full points if they pass, a share if they fail only by its cause.

    A failure without a cause still blocks if the function was wrong for all inputs: later checks may pass by chance.
    """
    passable = {*run.causes, *(check.name for check, _, calls in run.unnamed if _is_right_once(run.assignment, calls))}
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


def _is_right_once(assignment: LoadedAssignment, calls: Sequence[Call]) -> bool:
    """Return whether a call gave the right numbers, other than zeros."""
    return any(
        largest(call.result) > CANCELLED
        and same(call.result, answer(assignment.solution, "", call), tolerance_of(call))
        for call in calls
        if not _is_drawn(assignment, call)
    )


def _consequence(run: _Run, check: Check, unclear: Container[str]) -> CheckResult | None:
    """Return the result of a check that depends on wrong functions; None if it fails for a reason of its own.

    unclear : functions that are wrong throughout, such as zeros; a check that calls only these may pass by chance
    """
    try:
        run.perform(check)
    except Failed as failed:
        function = failed.failure.function  # if it hung before, it is not called again
        hung = (cause for cause in run.causes.values() if cause.function == function in run.student.broken)
        cause = _following(run, check, _earlier(run.causes)) or next(hung, None) or _own_source(run, check, failed)
        cause = cause or _shared_helper(run, None, failed) or _memory(run, failed)
        run.failing.extend(run.student.calls)
        if (cause := _earned(run, cause)) is None:
            return None
        run.causes[check.name] = cause
        return _failed(check, failed, cause)
    except Exception:  # the check stays "not run"
        return None
    function_names = {call.name for call in run.student.calls} or {check.function}
    return _passed(check) if any(name not in unclear for name in function_names) else None


def _is_drawn(assignment: LoadedAssignment, call: Call) -> bool:
    """Return whether a call returns a free body diagram, which has no numbers to compare."""
    return isinstance(assignment.returns[call.name], FreeBodyDiagram)


def _passed(check: Check) -> CheckResult:
    return CheckResult(check.name, check.part, check.points, check.points, "passed", check.title)


def _failed(check: Check, failed: Failed, cause: Cause | None, fault: str = "") -> CheckResult:
    suspect, follows_from = (cause.message or None, cause.follows_from) if cause else (None, "")
    share = max(failed.share, FOLLOWING_SHARE) if follows_from else failed.share
    failure = failed.failure
    failure = replace(failure, suspect=suspect, follows_from=follows_from, fault=fault or failure.fault)
    points, message = round(share * check.points, 6), full_message(failure)
    return CheckResult(check.name, check.part, points, check.points, "failed", message, suspect, failure)


def _not_run(check: Check, message: str, unwritten: str = "") -> CheckResult:
    return CheckResult(check.name, check.part, 0.0, check.points, "not_run", message, unwritten=unwritten)


def _grader_error(check: Check, error: str) -> CheckResult:
    return CheckResult(
        check.name, check.part, None, check.points, "grader_error", OUR_FAULT, error=error[:LONGEST_FAULT]
    )
