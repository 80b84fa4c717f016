"""Print the results of `check`: failures in a student's words, in lines of 80 columns."""

import os
import sys
import textwrap
from collections.abc import Iterable, Mapping, Sequence

from tam570.checking.deadline import CALL, CPU
from tam570.checking.visible import Outcomes, TestFailure
from tam570.progress import Progress, said

WIDTH = 80
MOST_LINES = 12  # of a message
MOST_PRINTED = 3  # lines of a student's output
SLOW = 0.3  # of a time limit; other inputs, or a slower machine, may need the rest
RED, GREEN = 31, 32  # ANSI codes


def untouched(slug: str, functions: Sequence[str]) -> None:
    """Print one line for an assignment of which nothing is written yet."""
    count = f"{len(functions)} functions" if len(functions) > 1 else "1 function"
    print(f"{slug[:4]}: nothing is written yet; {count} to fill in, first {functions[0]}")


def trouble(slug: str, message: str) -> None:
    """Print why a file cannot be tested, and what that would cost."""
    print(_wrapped(f"{slug[:4]}: {message}"), file=sys.stderr)
    print("The grader would give this file 0 points.", file=sys.stderr, flush=True)


def imported(skipped: Iterable[str], printed: str, remark: str) -> None:
    """Print what happened while the file was imported, and a note on the file itself."""
    if remark:
        print(_wrapped(remark))
    for cell in skipped:
        print(_wrapped(f"left out, as where it is graded: {cell}", "", "    "))
    if printed:
        print(_printed(printed, "your file prints when it is imported", ""))


def failures(outcomes: Outcomes, explanation: Mapping[str, str]) -> None:
    """Print each failure once, with the tests that fail by it; then, on one line, what is not written yet."""
    tests: dict[str, list[str]] = {}
    for test, failure in outcomes.failures.items():
        if not failure.unwritten:
            tests.setdefault(failure.message, []).append(test)
    for names in tests.values():
        print(f"\n{_coloured(_names(names), RED)}")
        _failure(outcomes.failures[names[0]], explanation.get(names[0]))
    if tests:
        print()
    missing = dict.fromkeys(failure.function for failure in outcomes.failures.values() if failure.unwritten)
    if missing:
        print(_wrapped(f"not written yet: {', '.join(str(name) for name in missing)}", "", "    "))


def _failure(failure: TestFailure, explanation: str | None) -> None:
    if failure.where and not failure.function:
        print(_wrapped(failure.where, "    "))
    print(_short(failure.message))
    if explanation:
        print(_wrapped(explanation, "    "))
    if failure.printed:
        print(_printed(failure.printed, "your code prints", "    "))


def before(names: Sequence[str]) -> None:
    """Print the tests that failed before and were not run again."""
    if names:
        print(_wrapped(f"As before, these fail: {', '.join(map(_words, names))}."))


def slow(longest: Mapping[str, float], total: float) -> None:
    """Print which functions use much of the grader's time limit for a call, and whether all calls together do."""
    for name, seconds in longest.items():
        if seconds > SLOW * CALL:
            print(_wrapped(f"{name} takes {seconds:.1f} s of the {CALL:g} s that the grader gives a call.", "", "    "))
    if total > SLOW * CPU:
        print(f"All calls together take {total:.0f} s; the grader ends a file after {CPU:g} s.")


def progressed(slug: str, come: Progress, since: str) -> None:
    """Print the student's progress and what is next."""
    print(_coloured(f"{slug[:4]}: {said(come)}", RED if come["next"] else GREEN))
    done = "all done here; other inputs are hidden: --final says which"
    ahead = f"next: {come['next']}" if come["next"] else done
    print(f"{since}      {ahead}", flush=True)


def terminal() -> int | None:
    """Return a file descriptor of the terminal, unaffected by redirection; None if stderr is no terminal."""
    return os.dup(2) if sys.stderr.isatty() else None


def cleared(where: int | None) -> None:
    """Clear the line that shows the running test, and close the terminal's descriptor."""
    if where is not None:
        os.write(where, b"\r\x1b[K")
        os.close(where)


def _coloured(text: str, colour: int) -> str:
    """Return the text in colour on a terminal, unless NO_COLOR is set."""
    plain = os.environ.get("NO_COLOR") or not sys.stdout.isatty()
    return text if plain else f"\x1b[{colour}m{text}\x1b[0m"


def _names(tests: Sequence[str]) -> str:
    shown = [_wrapped(f"- {_words(test)}", "", "  ") for test in tests[:3]]
    return "\n".join([*shown, f"  and {len(tests) - 3} more"] if len(tests) > 3 else shown)


def _words(test: str) -> str:
    """Return the name of a test as a sentence."""
    name, bracket, parameters = test.partition("[")
    return name.removeprefix("test_").replace("_", " ") + bracket.replace("[", " [") + parameters


def _short(message: str) -> str:
    """Return the first lines of a message, indented."""
    lines = [line.rstrip() for line in message.splitlines() if line.strip()]
    lines[MOST_LINES:] = ["..."] if len(lines) > MOST_LINES else []
    return "\n".join(_wrapped(line, "    ") for line in lines)


def _printed(text: str, what: str, indent: str) -> str:
    lines = text.rstrip().splitlines()
    title = f"{indent}{what}" + (f" ({len(lines)} lines, the last are)" if len(lines) > MOST_PRINTED else "")
    return "\n".join([f"{title}:", *(f"{indent}    {line[: WIDTH - 8]}" for line in lines[-MOST_PRINTED:])])


def _wrapped(text: str, indent: str = "", more: str | None = None) -> str:
    """Return the text in lines of at most 80 columns."""
    lines = []
    for line in text.splitlines():
        lead = indent + line[: len(line) - len(line.lstrip())]
        lines.append(
            textwrap.fill(
                line.strip(),
                WIDTH,
                initial_indent=lead,
                subsequent_indent=lead if more is None else more,
                break_on_hyphens=False,
            )
        )
    return "\n".join(lines)
