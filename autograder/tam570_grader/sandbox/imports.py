"""Messages for the student on an import that failed, from the interpreter's messages.

Code that runs at import may contain hidden inputs that an earlier submission saw, and can raise any text. So a text is
shown only if it is a known message of Python about words in the file, and a line number only if the file has the line.
The interpreter's messages on the text itself are made before any of it runs, and are shown unchanged. For an exception
in a later call, only its class is shown, and which one of KNOWN_TEXTS its text begins with.
"""

import builtins
import re
from collections.abc import Sequence

from tam570.values import Json
from tam570_grader.checks.assignments import LoadedAssignment
from tam570_grader.errors import Over, printable
from tam570_grader.sandbox.replies import error_of

MOST_CELLS = 3  # failed cells that are named, because a notebook can choose which cells fail
LONGEST_WORD = 60
WORD = r"[\w.]+"
MESSAGES = [
    re.escape(message).replace("@", f"({WORD})")  # compiled only if a file fails
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
        "@ is off limits in this assignment",  # the grader's message
        "@ is off limits in this assignment, even where nothing uses it",
        "attempted relative import with no known parent package",
    )
]
# beginnings of messages of Python, NumPy, SciPy and SymPy, by class; what follows them may contain numbers
KNOWN_TEXTS = {
    "ValueError": (
        "Values in `t_eval` are not within `t_span`",
        "Values in `t_eval` are not properly sorted",
        "`t_eval` must be 1-dimensional",
        "`y0` must be 1-dimensional",
        "All components of the initial state `y0` must be finite",
        "f(a) and f(b) must have different signs",
        "Singular matrix",
        "Last 2 dimensions of the array must be square",
        "Array must not contain infs or NaNs",
        "math domain error",
        "cannot convert float NaN to integer",
        "operands could not be broadcast together",
        "could not broadcast input array",
        "matmul: Input operand 1 has a mismatch in its core dimension",
        "matmul: Input operand 1 does not have enough dimensions",
        "incompatible dimensions for cross product",
        "setting an array element with a sequence",
        "can only convert an array of size 1 to a Python scalar",
        "The truth value of an array with more than one element is ambiguous",
        "all the input array dimensions except for the concatenation axis must match exactly",
        "all the input arrays must have same number of dimensions",
        "all input arrays must have the same shape",
        "cannot reshape array",
        "assignment destination is read-only",
        "not enough values to unpack",
        "too many values to unpack",
    ),
    "TypeError": (
        "only 0-dimensional arrays can be converted to Python scalars",
        "only length-1 arrays can be converted to Python scalars",
        "can only concatenate list",
        "can only concatenate tuple",
        "can't multiply sequence by non-int of type 'float'",
        "unsupported operand type(s)",
        "'NoneType' object is not subscriptable",
        "'NoneType' object is not iterable",
        "'float' object is not subscriptable",
        "'float' object is not iterable",
        "'float' object is not callable",
        "'float' object cannot be interpreted as an integer",
        "'tuple' object does not support item assignment",
        "must be real number, not complex",
        "cannot determine truth value of Relational",
        "Cannot convert expression to float",
        "loop of ufunc does not support argument 0 of type Symbol",
    ),
    "IndexError": (
        "list index out of range",
        "tuple index out of range",
        "too many indices for array",
        "only integers, slices (`:`), ellipsis (`...`), numpy.newaxis (`None`) and integer or boolean arrays",
    ),
    "ZeroDivisionError": (
        "division by zero",
        "float division by zero",
        "integer division or modulo by zero",
        "0.0 cannot be raised to a negative power",
    ),
    "OverflowError": ("math range error", "cannot convert float infinity to integer"),
    "RuntimeError": ("Failed to converge",),
    "RecursionError": ("maximum recursion depth exceeded",),
}
# system messages on threads, processes, their semaphores (on a file, the message would end in its name), and input
MISDEEDS = {
    r"can't start new thread|\[Errno 11\] Resource temporarily unavailable.*|\[Errno 30\] Read-only file system": (
        "starts a thread or a process{}, which is off limits"
    ),
    "EOF when reading a line": "calls input(){}, which gets nothing here",
}
PLACE = re.compile(r" \([^()]*, line \d+\)$")  # end of a SyntaxError's text; our message has the line before
FROM_FILE = re.compile(rf"(cannot import name '{WORD}' from '{WORD}') \(.*\)")  # with a path on the worker
SKIPPED = re.compile(r"cell ([1-9]\d{0,2}): (\w+)(?:: (.*))?", re.DOTALL)


class NotLoaded(Over):
    """The submission could not be imported; `status` is the status of the result."""

    def __init__(self, status: str, message: str) -> None:
        super().__init__(message)
        self.status = status


def not_compiled(reply: object) -> NotLoaded:
    """Return the exception for a file that is not Python, with the interpreter's message; no code of it has run."""
    return _unreadable(error_of(reply), PLACE.sub("", error_of(reply)["text"]))


def not_imported(reply: object, text: bytes, assignment: LoadedAssignment, informed: bool) -> NotLoaded:
    """Return the exception for a file that could not be imported; on a retry (`informed`), without the reason."""
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
    """Return which of the names that are off limits was used.

    Return all of them if the text of the error, which the submission may have written, does not name one.
    """
    return " or ".join([name for name in names if error["text"].startswith(f"{name} ")] or names)


def sentence_of_ban(said: str, line: int = 0) -> str:
    """Return what a submission did if an exception's text is a system message about something forbidden, else ""."""
    return next((done.format(_at(line)) for words, done in MISDEEDS.items() if re.fullmatch(words, said)), "")


def python_class(error: Json) -> str:
    """Return an exception's first built-in class: the name of a student's class could reveal a hidden input."""
    return next((class_name for class_name in error["kinds"] if _is_python(class_name)), "an exception")


def named_exception(error: Json) -> str:
    """Return an exception's first built-in class, with the beginning of its text if that is a known one."""
    name, said = python_class(error), error["text"]
    text = next((text for text in KNOWN_TEXTS.get(name, ()) if said.startswith(text)), "")
    return f"{name} ({text})" if text else name


def skipped_cells(reports: Sequence[str], text: bytes) -> list[str]:
    """Return sentences on the first skipped cells, from reports that code in the cells may have written."""
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
    """Return a text if it is a known message of the interpreter about words in the file, else ""."""
    said = FROM_FILE.sub(r"\1 (unknown location)", said.strip())
    matches = filter(None, (re.fullmatch(message, said) for message in MESSAGES))
    is_python_text = any(all(_stands_in(word, text) for word in match.groups()) for match in matches)
    return printable(said.removesuffix(" (unknown location)")) if is_python_text else ""


def _stands_in(word: str, text: bytes) -> bool:
    """Return whether a word is in the file, or is the name of a built-in type."""
    if len(word) > LONGEST_WORD:
        return False
    return _is_python(word) or word == "NoneType" or bool(re.search(rb"\b%b\b" % re.escape(word.encode()), text))
