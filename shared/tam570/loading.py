"""Run a student's file, a module or a notebook, as the grader will: separately, with the grader's libraries only."""

import builtins
import linecache
import sys
import traceback
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager, redirect_stdout
from contextvars import ContextVar
from io import StringIO
from pathlib import Path
from types import ModuleType
from typing import cast

from tam570.bans import LIBRARIES, Forbidden, Unusable, must_be_allowed, must_be_there
from tam570.notebooks import KERNEL, LARGEST, code_cells, compiled, in_utf8, kernel_module, run, without_outputs
from tam570.values import Json

SUFFIXES = (".py", ".ipynb")
Builtins = Mapping[str, object]
_loading: ContextVar[frozenset[Path]] = ContextVar("loading", default=frozenset())  # files that are being run


class Trouble(Exception):
    """A file that cannot be used; the message tells the student why."""


def source_of(file: Path) -> bytes:
    """Return the source of a module or notebook, in UTF-8. Raise Trouble if it is neither, or too large."""
    if file.suffix not in SUFFIXES:
        raise Trouble(f"{file.name} is neither a Python module (.py) nor a notebook (.ipynb).")
    source = file.read_bytes()
    if file.suffix == ".ipynb" and len(source) > LARGEST:
        source = without_outputs(source)
    if len(source) > LARGEST:
        raise Trouble(f"{file.name} is larger than {LARGEST // 2**20} MiB: is it the right file?")
    return in_utf8(source)


def not_utf8(file: Path) -> str:
    """Return a sentence about the first line that is not UTF-8; "" if Python can read the module, or for a notebook."""
    source = file.read_bytes()
    if source_of(file) == source or file.suffix != ".py":
        return ""
    line = next(k for k, text in enumerate(source.splitlines(), start=1) if in_utf8(text) != text)
    return f"{file.name}, line {line}: a character is not UTF-8, so Python cannot read the file; save it as UTF-8."


def loaded(file: Path, slug: str, replacements: Builtins | None = None) -> tuple[ModuleType, list[str]]:
    """Run a file as a module with the assignment's name; return it and the notebook cells that raised and were skipped.

    replacements : of built-in functions, by name
    Raise Trouble if the file cannot be run.
    """
    source, running = source_of(file), _loading.get()
    if file.resolve() in running:
        raise Trouble(f"{file.name} loads itself; move the line that shows it out of the file.")
    token = _loading.set(running | {file.resolve()})
    module = ModuleType(slug)
    module.__dict__["__builtins__"] = {**vars(builtins), **KERNEL, **(replacements or {})}
    module.__dict__["__file__"] = f"{slug}.py"
    before, sys.modules[slug] = sys.modules.get(slug), module  # where a dataclass looks for its module
    try:
        if file.suffix == ".ipynb":
            return module, list(_cells_run(source, module))
        linecache.checkcache(str(file))
        exec(compile(source, str(file), "exec", dont_inherit=True), module.__dict__)
        return module, []
    except (Exception, SystemExit) as error:
        raise Trouble(f"{file.name} cannot be imported.\n{said(error, str(file))}") from error
    finally:
        _loading.reset(token)
        if before is not None:
            sys.modules[slug] = before


def _cells_run(source: bytes, module: ModuleType) -> Iterator[str]:
    """Run the cells in order; yield the number and the error of each that raises."""
    for number, text in code_cells(source):
        name = f"cell {number}"
        linecache.cache[name] = (len(text), None, [f"{line}\n" for line in text.split("\n")], name)
        try:
            with redirect_stdout(StringIO()):
                run(compiled(text, name), module.__dict__)
        except (Exception, SystemExit) as error:
            yield f"{name}: {type(error).__name__}: {error}"


def guarded_import(slug: str, banned: Sequence[str]) -> Callable[..., ModuleType]:
    """Return an `__import__` that refuses banned names and libraries that the grader does not have."""
    import_module = builtins.__import__

    def guarded(
        name: str, globals: Json | None = None, locals: Json | None = None, fromlist: Sequence[str] = (), level: int = 0
    ) -> ModuleType:
        must_be_allowed(name, fromlist, banned)
        if stand_in := kernel_module(name):
            return cast(ModuleType, stand_in)
        try:
            if not level:
                must_be_there(name, slug)
        except ModuleNotFoundError as error:
            explanation = f"the grader does not have {error.name}; it has Python itself, {', '.join(LIBRARIES)}"
            raise ModuleNotFoundError(explanation, name=error.name) from None
        module = import_module(name, globals, locals, fromlist, level)
        if name.partition(".")[0] == "matplotlib":  # a backend with windows fails in the grader
            sys.modules["matplotlib"].use = lambda *backend, **how: None  # type: ignore[attr-defined]
        return module

    return guarded


@contextmanager
def replaced(names: Sequence[str], what: str) -> Iterator[None]:
    """Replace these modules by placeholders that raise Forbidden when called; `what` is the scope for its message."""
    before = {name: sys.modules.get(name) for name in names}
    try:
        for name in names:
            _place_module(name, Unusable(name, what))
        yield
    finally:
        for name, module in before.items():
            _place_module(name, module)


def _place_module(name: str, module: ModuleType | None) -> None:
    """Make every import of this name return the module; None removes the module."""
    parent, _, last = name.rpartition(".")
    members = vars(sys.modules[parent]) if parent in sys.modules else {}
    if module is None:
        sys.modules.pop(name, None)
        members.pop(last, None)
    else:
        sys.modules[name] = members[last] = module


def said(error: BaseException, file: str) -> str:
    """Describe an exception, with the line of the student's file that led to it."""
    if isinstance(error, SyntaxError):
        line = f"Line {error.lineno}: " if error.lineno else ""
        return f"{line}{type(error).__name__}: {error.msg}\n    {(error.text or '').strip()}".rstrip()
    trace = traceback.extract_tb(error.__traceback__)
    frames = [frame for frame in trace if frame.filename == file or frame.filename.startswith("cell ")]
    where = f", in {frames[-1].name}" if frames and not frames[-1].name.startswith("<") else ""
    line = f"Line {frames[-1].lineno}{where}: {frames[-1].line}\n" if frames else ""
    if isinstance(error, Forbidden):
        return f"{line}{error}."
    return line + traceback.format_exception_only(error)[-1].strip()
