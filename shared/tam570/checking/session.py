"""Run the visible tests of an assignment on a student's file, in a process that may be killed."""

import contextlib
import io
import sys
import time
import warnings
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from tam570.bans import HERE
from tam570.checking import report
from tam570.checking.changes import by_parameters, calls, keys, uses
from tam570.checking.deadline import CALL, TooLong, limited
from tam570.checking.examples import Examples, load_examples
from tam570.checking.functions import Functions
from tam570.checking.mistakes import BEGINNING, Candidate, candidates, reversed_argument
from tam570.checking.trail import Trail
from tam570.checking.visible import Outcomes, Test, collect_tests
from tam570.course import Stub, contract, folder, stubs
from tam570.loading import Trouble, guarded_import, loaded, not_utf8, replaced, source_of
from tam570.notebooks import code_cells, text_of
from tam570.progress import PASSED, Progress, progress, remember, remembered

MOST_VARIANTS = 2000  # most runs of a test in a search for mistakes
SLOW_IMPORT = (
    f"{{file}} takes longer than {CALL:g} s to import. Does it run a simulation by itself?\n"
    'Put that below `if __name__ == "__main__":`, so that it runs only when you start the file.'
)
ENDED = "{name} ended the process that tests it: it exits, crashes or uses too much memory."
OUT_OF_TIME = f"{{name}} did not return within {CALL:g} s, and cannot be interrupted. Is there an endless loop?"
Remembered = Mapping[str, tuple[str, str]]  # by test: a digest of all that its outcome depends on, and the outcome


@dataclass(frozen=True)
class TestModule:
    """A module of tests: the released one, that of the examples, or the student's beside the work."""

    path: Path
    text: str
    examples: Examples | None = None


@dataclass(frozen=True)
class Work:
    """A student's file, and the tests that call its functions."""

    file: Path
    slug: str
    code: str
    used: Mapping[str, set[str]]  # by test, the functions that it calls
    examples: Examples | None


def check(
    file: Path,
    slug: str,
    trail: Trail,
    *,
    changed: bool = False,
    functions: Collection[str] = (),
    lost: Mapping[str, bool],
) -> bool:
    """Run the released tests, and those that a student has added beside the file; return whether all pass.

    trail     : records which test and which function runs
    changed   : run only tests whose outcome may have changed since they were last run
    functions : run only tests that call one of these; default: all
    lost      : the functions that have ended a process, and whether they ran out of time
    """
    trail.enter(slug=slug, test="", function="")
    modules = tests_of(file, slug)
    released = stubs((folder(slug) / f"{slug}.py").read_bytes())
    used = {name: of for module in modules for name, of in calls(module.text, slug).items()}
    try:
        if file.suffix == ".py" and (empty := _untouched(file, released)):
            report.untouched(slug, empty)
            remember(file, {}, progress(slug, {}, used))
            return False
        student, skipped, printed = _functions(file, slug)
        code = text_of(source_of(file), file.suffix)
        now = {name: key for module in reversed(modules) for name, key in keys(module.text, code, slug).items()}
        tests = _collected(modules)
    except Trouble as trouble:
        report.trouble(slug, str(trouble))
        return False
    report.imported(_own_cells(skipped, file, slug), printed, not_utf8(file))
    before = remembered(file) if changed or functions else {}
    valid = {test: was for test, was in before.items() if was[0] == now.get(_function(test))}
    tests = _chosen(tests, used, valid if changed else {}, functions)
    student.trail = trail
    student.hanging |= {name: (OUT_OF_TIME if slow else ENDED).format(name=name) for name, slow in lost.items()}
    outcomes = Outcomes(student, report.terminal())
    outcomes.run(tests)
    report.cleared(outcomes.terminal)
    valid |= {test: (now.get(_function(test), ""), outcome) for test, outcome in outcomes.passed.items()}
    lasted = time.time() - file.stat().st_mtime
    since = f"      {len(tests)} tests run, {lasted:.2f} s after saving\n" if changed else ""
    examples = next((module.examples for module in modules if module.examples), None)
    return _report(Work(file, slug, code, used, examples), valid, outcomes, functions, since)


def _chosen(
    tests: Sequence[Test], used: Mapping[str, set[str]], remembered: Remembered, functions: Collection[str]
) -> list[Test]:
    """Return the tests to run: those of these functions whose outcome is not known."""
    wanted = by_parameters(used, [test.name for test in tests])
    chosen = [test for test in tests if not functions or wanted[test.name] & set(functions)]
    chosen = [test for test in chosen if test.name not in remembered]
    if not chosen:
        print("Nothing has changed that a test sees." if remembered else "No visible test calls it.")
    return chosen


def _report(work: Work, valid: Remembered, outcomes: Outcomes, functions: Collection[str], since: str) -> bool:
    """Print and store the outcomes of the tests; return whether all pass."""
    results = {test: outcome for test, (_, outcome) in valid.items()}
    calling = by_parameters(work.used, results)
    causes = {test: _cause(test, outcomes, calling, results) for test in outcomes.failures}
    reached = progress(work.slug, results, calling, causes)
    remember(work.file, valid, reached)
    explanations = dict[str, str]()
    for test in outcomes.failures:
        names = calling.get(test, set())
        if work.examples and len(names) == 1 and (mistake := work.examples.mistake(*names)):
            explanations[test] = f"{BEGINNING}{mistake}"
    explanations |= _explained(outcomes, calling, causes, reached, work.code)  # from more numbers than examples have
    report.failures(outcomes, explanations)
    report.slow(outcomes.functions.longest, outcomes.functions.total)
    if functions:
        passed = [*outcomes.passed.values()].count(PASSED)
        print(f"{work.slug[:4]}: {passed} of {len(outcomes.passed)} pass")
    else:
        report.before(
            [name for name, outcome in results.items() if outcome != PASSED and name not in outcomes.failures]
        )
        report.progressed(work.slug, reached, since)
    return bool(results) and not outcomes.failures and (bool(functions) or all(r == PASSED for r in results.values()))


def _cause(test: str, outcomes: Outcomes, used: Mapping[str, set[str]], results: Mapping[str, str]) -> str | None:
    """Return the function at fault: the one that raised, or the only one whose tests of it alone do not all pass."""
    if function := outcomes.failures[test].function:
        return function
    alone = {name: [test for test, names in used.items() if names == {name}] for name in used.get(test, ())}
    doubtful = [name for name, tests in alone.items() if not tests or any(results[test] != PASSED for test in tests)]
    return doubtful[0] if len(doubtful) == 1 else None


def run_tests(file: Path, slug: str, names: Sequence[str]) -> Outcomes:
    """Run the tests with these names on a file and return the outcomes. Raise Trouble if it cannot be tested."""
    functions, _, _ = _functions(file, slug)
    outcomes = Outcomes(functions, None)
    outcomes.run([test for test in _collected(tests_of(file, slug)) if _function(test.name) in names])
    return outcomes


def tests_of(file: Path, slug: str) -> list[TestModule]:
    """Return the released tests, the examples, and the student's tests.

    The module of tests beside the file counts only if it has tests that are not released.
    """
    released, beside = (where / f"test_{slug}.py" for where in (folder(slug), file.parent))
    modules = [TestModule(released, released.read_text(encoding="utf-8"))] if released.exists() else []
    if examples := load_examples(folder(slug)):
        modules.append(TestModule(released.with_name("test_examples.py"), examples.module(slug), examples))
    with contextlib.suppress(OSError, SyntaxError, ValueError):  # ignore tests that cannot be read
        text = beside.read_text(encoding="utf-8")
        if set(calls(text, slug)) - {name for module in modules for name in calls(module.text, slug)}:
            modules.append(TestModule(beside, text))
    return modules


def _collected(modules: Sequence[TestModule]) -> list[Test]:
    """Return all tests, the released ones first. Raise Trouble if there is none."""
    tests: dict[str, Test] = {}
    for number, module in enumerate(modules):
        try:
            with contextlib.redirect_stderr(io.StringIO()):
                names = {"_example": module.examples.run} if module.examples else {}
                for test in collect_tests(module.path, module.text, names):
                    tests.setdefault(test.name, test)
        except Exception as error:
            if number == 0:
                raise
            print(f"{module.path.name} beside your file is left out: {type(error).__name__}: {error}")
    if not tests:
        raise Trouble("There are no visible tests of this assignment here.")
    return list(tests.values())


def _functions(file: Path, slug: str) -> tuple[Functions, list[str], str]:
    """Return the student's functions, the skipped notebook cells, and the output. Raise Trouble if it cannot run."""
    agreed = contract(slug)
    banned = agreed["off_limits"].get("*", ())
    importing = guarded_import(slug, banned)
    quiet = contextlib.redirect_stderr(io.StringIO())
    with contextlib.redirect_stdout(io.StringIO()) as printed, quiet, replaced(banned, HERE):
        try:
            with limited():
                module, skipped = loaded(file, slug, {"__import__": importing})
        except TooLong:
            raise Trouble(SLOW_IMPORT.format(file=file.name)) from None
    functions = Functions(module, file, agreed["results"], agreed["off_limits"])
    if file.suffix == ".ipynb" and not any(hasattr(module, name) for name in agreed["results"]):
        raise Trouble(f"{file.name} defines none of the functions. Are they in {slug}.py?")
    sys.modules[slug] = functions.stand_in()
    return functions, skipped, printed.getvalue()


def _own_cells(skipped: Sequence[str], file: Path, slug: str) -> list[str]:
    """Return the skipped cells that the student wrote; the kit's notebook does not have them."""
    kit = folder(slug) / "notebook" / f"{slug}.ipynb"
    released = {text for _, text in code_cells(kit.read_bytes())} if skipped and kit.exists() else set()
    ours = {f"cell {number}" for number, text in code_cells(source_of(file)) if text in released} if released else set()
    return [cell for cell in skipped if cell.partition(":")[0] not in ours]


def _untouched(file: Path, released: Mapping[str, Stub]) -> list[str]:
    """Return the functions to be written if none of them is written and none is added; else an empty list."""
    with contextlib.suppress(SyntaxError, ValueError):
        written = stubs(file.read_bytes())
        to_write = [name for name, stub in released.items() if not stub.written]
        if written.keys() == released.keys() and to_write == [name for name in released if not written[name].written]:
            return to_write
    return []


def _function(test: str) -> str:
    """Return the name of a test without its parameters."""
    return test.partition("[")[0]


def _explained(
    outcomes: Outcomes, used: Mapping[str, set[str]], causes: Mapping[str, str | None], reached: Progress, code: str
) -> dict[str, str]:
    """Return a message for each failed test that passes if one mistake of one function is undone.

    A function whose tests of it alone pass is not blamed if the test uses, directly or not, one whose tests fail.
    """
    budget, explanations, functions = MOST_VARIANTS, dict[str, str](), outcomes.functions
    mistakes: list[Candidate] = []
    wrong = set().union(*(used[test] for test in outcomes.failures if len(used.get(test, ())) == 1))
    for name in reached["missing"]:
        failed = [
            test
            for test, failure in outcomes.failures.items()
            if not failure.function
            and name in used.get(test, ())
            and (name in wrong or not wrong & uses(code, used[test]))
        ]
        alone = [test for test, names in used.items() if names == {name} and outcomes.passed.get(test) == PASSED]
        # The mistake must explain all of these: in them only the test calls the function, not the student's code.
        its_own = {test for test in failed if causes[test] == name not in uses(code, used[test] - {name})}
        best: list[str] = []
        best_mistake: Candidate | None = None
        if not failed or name not in functions.observed:
            continue
        observed = functions.results[name], functions.plain(name), functions.observed[name], functions.longest[name]
        for mistake in candidates(name, *observed):
            budget -= len(failed)
            if budget < 0:
                break
            mended, informative = list[str](), mistake.repair is None
            functions.parameters.clear()
            for test in failed:
                functions.informative = False
                if _passes(outcomes, mistake, test):
                    mended, informative = [*mended, test], informative or functions.informative
            key = reversed_argument(mistake)
            is_as_good = best_mistake and mended == best and reversed_argument(best_mistake) and key
            if (
                informative  # zeros agree with many mistakes
                and (is_as_good or len(mended) > len(best))
                and its_own <= {*mended}
                and not (
                    mistake.is_a_number and len(functions.parameters) == 1 and functions.observed[name].case.kwargs
                )
                and all(_passes(outcomes, mistake, test) for test in alone)
            ):
                if best_mistake and is_as_good:  # both arguments explain the same tests
                    mistake = replace(best_mistake, message=f"{best_mistake.message[:-1]}, or {key} has it.")
                best, best_mistake = mended, mistake
        if best_mistake:
            mistakes.append(best_mistake)
            explanations |= dict.fromkeys(best, best_mistake.message)
    return explanations | _consequences(outcomes, mistakes, used, code)


def _consequences(
    outcomes: Outcomes, mistakes: Sequence[Candidate], used: Mapping[str, set[str]], code: str
) -> dict[str, str]:
    """Return a message for each failed test that passes if a mistake in what its only function calls is undone."""
    explanations = dict[str, str]()
    for mistake in (mistake for mistake in mistakes if mistake.repair):
        for test, failure in outcomes.failures.items():
            names = used.get(test, set())
            callers = [name for name in names if mistake.function in uses(code, [name])]
            if mistake.function in names or len(callers) != 1 or failure.function or test in explanations:
                continue
            if _passes(outcomes, mistake, test, everywhere=True):
                explanations[test] = f"Your {callers[0]} uses or repeats the mistake in {mistake.function}."
    return explanations


def _passes(outcomes: Outcomes, mistake: Candidate, test: str, *, everywhere: bool = False) -> bool:
    """Return whether a test passes with a mistake undone; with `everywhere`, also in calls by the module itself."""
    import numpy as np

    tried = outcomes.functions.tried(mistake, everywhere=everywhere)
    try:
        with tried, contextlib.redirect_stdout(io.StringIO()), np.errstate(all="ignore"), warnings.catch_warnings():
            warnings.simplefilter("ignore")
            outcomes.repeat[test]()
    except (KeyboardInterrupt, GeneratorExit):
        raise
    except BaseException:  # a student's code may raise anything for changed numbers
        return False
    return True
