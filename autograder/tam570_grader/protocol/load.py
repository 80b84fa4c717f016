"""Load a submission as a module: Python source, or the code cells of a notebook."""

import ast
import builtins
import sys
from collections.abc import Callable, Sequence
from types import CodeType, ModuleType
from typing import cast

from tam570 import notebooks
from tam570.bans import HERE, IN_ONE, Unusable, must_be_allowed, must_be_there
from tam570.values import Json

CodeCell = tuple[str, CodeType]  # name of a notebook's cell, or "" for a module, and its code

__builtins__ = dict(vars(builtins))  # type: ignore[assignment]  # as in wire


def compiled(source: bytes, name: str, *, notebook: bool) -> tuple[list[CodeCell], list[str]]:
    """Return the code to run, and the notebook cells that are not Python, as "cell 3: SyntaxError: ...".

    None of the code is run.
    """
    if not notebook:
        return [("", compile(notebooks.in_utf8(source), f"{name}.py", "exec", dont_inherit=True))], []
    pieces, skipped = [], []
    for number, text in notebooks.code_cells(source):
        cell = f"cell {number}"
        try:
            pieces.append((cell, notebooks.compiled(text, cell)))
        except Exception as error:
            skipped.append(f"{cell}: {_in_words(error)}")
    return pieces, skipped


def load(
    pieces: Sequence[CodeCell],
    source: bytes,
    name: str,
    *,
    notebook: bool,
    forbidden: Sequence[str],
    uncallable: Sequence[str],
) -> tuple[ModuleType, list[str]]:
    """Load the student's module; return it and the notebook cells that raised, as "cell 3: NameError: ...".

    forbidden  : modules that must not be imported
    uncallable : modules of which nothing can be called; statements of the file that call them during the import
                 are skipped (they run in the process for other functions)
    """
    module = ModuleType(name)
    module.__dict__["__builtins__"] = _builtins_without(forbidden, name)
    module.__dict__["__file__"] = f"{name}.py"
    sys.modules[name] = module
    for where, names in ((HERE, forbidden), (IN_ONE, uncallable)):
        for banned in names:
            _replace(banned, Unusable(banned, where))
    skipped = []
    for cell, code in (pending := [*pieces]):
        try:
            notebooks.run(code, module.__dict__)
        except BaseException as error:
            if not (notebook or (uncallable and isinstance(error, Exception))):
                raise
            skipped.append(f"{cell}: {_in_words(error)}")
            if not notebook and len(pending) == 1:
                pending += _statements_after(error, code, notebooks.in_utf8(source))
    return module, skipped if notebook else []


def _statements_after(error: BaseException, code: CodeType, source: bytes) -> list[CodeCell]:
    """Return the statements of a module after the one that raised, each compiled separately."""
    trace = error.__traceback__
    while trace is not None and trace.tb_frame.f_code is not code:
        trace = trace.tb_next
    line = trace.tb_lineno if trace is not None else sys.maxsize
    statements = ast.parse(source).body
    future = [node for node in statements if isinstance(node, ast.ImportFrom) and node.module == "__future__"]
    rest = [node for node in statements if (node.end_lineno or 0) >= line][1:]
    alone = (ast.Module([*future, statement], type_ignores=[]) for statement in rest)
    return [("", compile(node, code.co_filename, "exec", dont_inherit=True)) for node in alone]


def _in_words(error: BaseException) -> str:
    try:
        return f"{type(error).__name__}: {error}"
    except Exception:
        return type(error).__name__


def _builtins_without(forbidden: Sequence[str], module_name: str) -> Json:
    """Return the built-ins with an `__import__` that refuses forbidden modules and those not in `bans.LIBRARIES`."""
    import_module = builtins.__import__

    def guarded_import(
        name: str, globals: Json | None = None, locals: Json | None = None, fromlist: Sequence[str] = (), level: int = 0
    ) -> ModuleType:
        must_be_allowed(name, fromlist, forbidden)
        if stand_in := notebooks.kernel_module(name):
            return cast(ModuleType, stand_in)
        if not level:
            must_be_there(name, module_name)
        try:
            return import_module(name, globals, locals, fromlist, level)
        finally:
            _without_windows()

    return {**vars(builtins), **notebooks.KERNEL, "__import__": guarded_import}


_tamed: set[str] = set()


def _without_windows() -> None:
    """Let imported Matplotlib always use Agg, which opens no window, and IPython the stand-in for a kernel."""
    for name, attribute in (("matplotlib", "use"), ("matplotlib.pyplot", "switch_backend")):
        module = sys.modules.get(name)
        if name not in _tamed and hasattr(module, attribute):
            _tamed.add(name)
            setattr(module, attribute, _with_agg(getattr(module, attribute)))
    if "IPython" in sys.modules:
        sys.modules["IPython"].get_ipython = notebooks.KERNEL["get_ipython"]  # type: ignore[attr-defined]


def _with_agg(choose: Callable[[str], object]) -> Callable[..., None]:
    def use(*names: object, **how: object) -> None:
        choose("agg")

    return use


def _replace(name: str, module: ModuleType) -> None:
    """Replace a module, its loaded submodules and the attribute of its parent, so that the real one is unreachable.

    If it is not loaded, it has no submodules; the search for them would copy pages of memory shared with the zygote.
    """
    for loaded in [other for other in sys.modules if other.startswith(name + ".")] if name in sys.modules else ():
        del sys.modules[loaded]
    sys.modules[name] = module
    parent, _, last = name.rpartition(".")
    if parent in sys.modules:
        setattr(sys.modules[parent], last, module)
