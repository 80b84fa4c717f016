"""What a student is told of an import that failed: the interpreter's own messages.

What runs while a file is imported may hold the inputs of an earlier submission, and can say whatever it likes. So its
words are told where they are a known message about words that stand in the file, and its line where the file has it.
What the interpreter says of the text itself comes before any of it runs, and is told as it is.
"""

import builtins
import re
from collections.abc import Sequence

from tam570.values import Json
from tam570_grader.checks.assignments import LoadedAssignment
from tam570_grader.errors import Over, printable
from tam570_grader.sandbox.replies import error_of

MOST_CELLS = 3  # of a notebook, that are named: which ones is the notebook's to choose
LONGEST_WORD = 60
WORD = r"[\w.]+"
MESSAGES = [
    re.escape(message).replace("@", f"({WORD})")  # compiled where a file fails
    for message in (
        "name '@' is not defined",
        "No module named '@'",
        "No module named '@'; '@' is not a package",
        "cannot import name '@' from '@' (unknown location)",
        "module '@' has no attribute '@'",
        "'@' object has no attribute '@'",
        "'@' object is not callable",
        "'@' object is not iterable",
        "'@' object is not subscriptable",
        "@() missing 1 required positional argument: '@'",
        "[Errno 2] No such file or directory: '@'",
        "division by zero",
        "float division by zero",
        "math domain error",
        "list index out of range",
        "maximum recursion depth exceeded",
        "@ is off limits in this assignment",  # in our words
        "@ is off limits in this assignment, even where nothing uses it",
        "attempted relative import with no known parent package",
    )
]
# what the system says of threads, processes, the semaphores between these (a file has its name behind it), and input
MISDEEDS = {
    r"can't start new thread|\[Errno 11\] Resource temporarily unavailable.*|\[Errno 30\] Read-only file system": (
        "starts a thread or a process{}, which is off limits"
    ),
    "EOF when reading a line": "calls input(){}, which gets nothing here",
}
PLACE = re.compile(r" \([^()]*, line \d+\)$")  # behind a SyntaxError, whose line is told before it
FROM_FILE = re.compile(rf"(cannot import name '{WORD}' from '{WORD}') \(.*\)")  # the place is the worker's own
SKIPPED = re.compile(r"cell ([1-9]\d{0,2}): (\w+)(?:: (.*))?", re.DOTALL)


class NotLoaded(Over):
    """The submission could not be imported; `status` is what the result line says."""

    def __init__(self, status: str, message: str) -> None:
        super().__init__(message)
        self.status = status


def not_compiled(reply: object) -> NotLoaded:
    """Return why the text is no Python, in the interpreter's words: nothing of it has run."""
    return _unreadable(error_of(reply), PLACE.sub("", error_of(reply)["text"]))


def not_imported(reply: object, text: bytes, assignment: LoadedAssignment, informed: bool) -> NotLoaded:
    """Return why it could not be imported; of one that is tried again, not even that."""
    error = error_of(reply)
    if informed:
        return NotLoaded("unreadable", "Your file could not be imported a second time: what does it do at import?")
    if "Forbidden" in error["kinds"] and (used := misused(error, assignment.forbidden.get("*", ()))):
        return NotLoaded("unreadable", f"Your file was not graded: it imports {used}, which is off limits")
    line = error["line"] if error["line"] <= text.count(b"\n") + 1 else 0
    if "SystemExit" in error["kinds"]:
        return NotLoaded("crashed", f"Your file ends itself{_at(line)}: is there a sys.exit() outside its functions?")
    if done := sentence_of_ban(error["text"], line):
        return NotLoaded("unreadable", f"Your file {done}")
    return _unreadable({**error, "line": line}, _own_words(error["text"], text))


def misused(error: Json, names: Sequence[str]) -> str:
    """Return what was used of the names that are off limits.

    All where that is not told: the text is the submission's.
    """
    return " or ".join([name for name in names if error["text"].startswith(f"{name} ")] or names)


def sentence_of_ban(said: str, line: int = 0) -> str:
    """Return what was done, where these words of an exception are the system's about what nobody may do; else ""."""
    return next((done.format(_at(line)) for words, done in MISDEEDS.items() if re.fullmatch(words, said)), "")


def python_class(error: Json) -> str:
    """Return the exception's first class that is Python's own: a name that a student chose could carry an input out."""
    return next((class_name for class_name in error["kinds"] if _is_python(class_name)), "an exception")


def skipped_cells(reports: Sequence[str], text: bytes) -> list[str]:
    """Return the first cells that were skipped, and why, by what ran in them."""
    matches = filter(None, map(SKIPPED.fullmatch, reports))
    sentences = []
    for match in matches:
        if _is_python(match[2]) or match[2] == "Forbidden":
            words = sentence_of_ban((match[3] or "").strip()) or _own_words(match[3] or "", text)
            sentences.append(f"cell {match[1]}: {match[2]}{': ' + words if words else ''}")
    return [*sentences[:MOST_CELLS], *(["and others"] if len(sentences) > MOST_CELLS else [])]


def _unreadable(error: Json, words: str) -> NotLoaded:
    where = python_class(error) + _at(error["line"])
    return NotLoaded("unreadable", ": ".join(filter(None, ("Your file cannot be imported", where, words))))


def _at(line: int) -> str:
    return f" at line {line}" if line > 0 else ""


def _is_python(class_name: str) -> bool:
    return isinstance(getattr(builtins, class_name, None), type)


def _own_words(said: str, text: bytes) -> str:
    """Return a message of the interpreter's about words of the file; "" for any other."""
    said = FROM_FILE.sub(r"\1 (unknown location)", said.strip())
    matches = filter(None, (re.fullmatch(message, said) for message in MESSAGES))
    is_python_text = any(all(_stands_in(word, text) for word in match.groups()) for match in matches)
    return printable(said.removesuffix(" (unknown location)")) if is_python_text else ""


def _stands_in(word: str, text: bytes) -> bool:
    """Return whether it is a word of the file, or the name of a type of Python's."""
    if len(word) > LONGEST_WORD:
        return False
    return _is_python(word) or word == "NoneType" or bool(re.search(rb"\b%b\b" % re.escape(word.encode()), text))
