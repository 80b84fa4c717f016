"""Makes a module of what a student handed in: Python source, or the code cells of a notebook."""

import builtins
import json
import re
import sys
from collections.abc import Sequence
from types import CodeType, ModuleType
from typing import Any

__all__ = ["Forbidden", "forbid_in_calls", "load"]

__builtins__ = dict(vars(builtins))  # type: ignore[assignment]  # as in wire

MAGIC = re.compile(r"\s*(?:[%!?]|[\w, ]+=\s*[%!])")  # %timeit, !ls, files = !ls
TIMED_CELLS = (
    "%%time",
    "%%capture",
    "%%prun",
)  # their body is Python; other cell magics hold another language


class Forbidden(ImportError):
    """An import, or a use, of what the assignment puts off limits."""


def load(
    source: bytes, name: str, *, notebook: bool, forbidden: Sequence[str]
) -> tuple[ModuleType, list[str]]:
    """The student's module, and the notebook cells that were skipped because they raised, as "cell 3: NameError"."""
    module = ModuleType(name)
    module.__dict__["__builtins__"] = _builtins_without(forbidden)
    module.__dict__["__file__"] = f"{name}.py"
    sys.modules[name] = module
    for banned in forbidden:
        _replace(banned, _Unusable(banned))
    if not notebook:
        exec(compile(source, f"{name}.py", "exec", dont_inherit=True), module.__dict__)
        return module, []
    return module, _run_cells(_code_cells(source), module)


def forbid_in_calls(modules: Sequence[str]) -> None:
    """Let these modules be imported, but nothing of them be called."""
    for name in modules:
        _replace(name, _Uncallable(name))


def _run_cells(cells: list[tuple[int, str]], module: ModuleType) -> list[str]:
    skipped = []
    for number, text in cells:
        try:
            exec(_compiled(text, f"cell {number}"), module.__dict__)
        except Forbidden:
            raise
        except BaseException as error:
            skipped.append(f"cell {number}: {type(error).__name__}")
    return skipped


def _code_cells(source: bytes) -> list[tuple[int, str]]:
    """Number and text of the code cells that are Python."""
    cells = json.loads(source)["cells"]
    code = [
        (n, "".join(cell["source"])) for n, cell in enumerate(cells, start=1) if cell["cell_type"] == "code"
    ]
    return [(n, text) for n, text in code if not text.startswith("%%") or text.startswith(TIMED_CELLS)]


def _compiled(text: str, name: str) -> CodeType:
    """The code of a cell, without magics and shell lines."""
    try:
        return compile(text, name, "exec", dont_inherit=True)
    except SyntaxError:
        plain = "\n".join("" if MAGIC.match(line) else line for line in text.split("\n"))
        return compile(plain, name, "exec", dont_inherit=True)


def _builtins_without(forbidden: Sequence[str]) -> dict[str, Any]:
    """The built-in functions with an import that refuses the forbidden modules."""
    import_module = builtins.__import__

    def guarded_import(
        name: str, globals: Any = None, locals: Any = None, fromlist: Any = (), level: int = 0
    ) -> ModuleType:
        wanted = {name, *(f"{name}.{item}" for item in fromlist or ())}
        for banned in forbidden:
            if any(item == banned or item.startswith(banned + ".") for item in wanted):
                raise Forbidden(f"{banned} is off limits in this assignment")
        return import_module(name, globals, locals, fromlist, level)

    return {**vars(builtins), "__import__": guarded_import}


def _replace(name: str, module: ModuleType) -> None:
    """Put the module where every other way of reaching the real one ends."""
    for loaded in [other for other in sys.modules if other.startswith(name + ".")]:
        del sys.modules[loaded]
    sys.modules[name] = module
    parent, _, last = name.rpartition(".")
    if parent in sys.modules:
        setattr(sys.modules[parent], last, module)


class _Unusable(ModuleType):
    """A module of which nothing can be had."""

    def __getattr__(self, attribute: str) -> Any:
        if attribute.startswith("__"):
            raise AttributeError(attribute)
        raise Forbidden(f"{self.__name__} is off limits in this assignment")


class _Uncallable(ModuleType):
    """A module whose parts can be named but not called."""

    def __getattr__(self, attribute: str) -> Any:
        if attribute.startswith("__"):
            raise AttributeError(attribute)
        return _Refusal()


class _Refusal:
    def __call__(self, *args: Any, **kwargs: Any) -> Any:
        raise Forbidden("this is off limits in this function")

    def __getattr__(self, attribute: str) -> Any:
        return self
