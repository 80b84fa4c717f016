"""The same source compiled by numba (`pip install tam570[fast]`), kept on disk for the next process."""

import hashlib
import importlib.util
import inspect
import os
import sys
from collections.abc import Callable
from functools import lru_cache
from pathlib import Path
from typing import Any

from tam570.integrate import drive
from tam570.integrate.source import Formulas, functions

__all__ = ["available", "kept", "seconds_to_compile", "walker"]

_HEAD = '''"""Written by tam570 for one right-hand side; may be deleted at any time."""

from math import *

from numba import njit
'''

_TAIL = """
inner = njit(error_model="numpy", no_cpython_wrapper=True, no_cfunc_wrapper=True)
rhs, raised, step, dense, at = map(inner, (rhs, raised, step, dense, at))
advance = njit(cache=True, error_model="numpy")(advance)
"""


def available() -> bool:
    """Whether numba is installed; it is not imported for that."""
    return importlib.util.find_spec("numba") is not None


def kept(formulas: Formulas) -> bool:
    """Whether some process has compiled these formulas."""
    return any(_folder().joinpath("__pycache__").glob(f"{_name(source(formulas))}*.nbi"))


def seconds_to_compile(formulas: Formulas) -> float:
    """Fitted to the time that numba 0.6 took for systems of size 2 to 15 on a machine of 2024."""
    thousand_characters = len(source(formulas)) / 1000
    return 0.5 + 0.05 * thousand_characters + 0.0008 * thousand_characters**2


@lru_cache(maxsize=64)
def source(formulas: Formulas) -> str:
    """A module of its own with the driver and the functions of these formulas."""
    return "\n\n".join([_HEAD, inspect.getsource(drive), functions(formulas, forgiving=False), _TAIL])


def _name(text: str) -> str:
    return "tam570_" + hashlib.sha256(text.encode()).hexdigest()[:24]


@lru_cache(maxsize=64)
def walker(formulas: Formulas) -> Callable[..., Any]:
    """`drive.advance` for these formulas, compiled at its first call."""
    text = source(formulas)
    name = _name(text)
    path = _folder() / f"{name}.py"
    if not path.exists():
        fresh = path.with_suffix(f".{os.getpid()}")
        fresh.write_text(text, encoding="utf-8")
        fresh.replace(path)  # at once: another process may want to read it
    spec = importlib.util.spec_from_file_location(name, path)
    assert spec is not None and spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    sys.modules[name] = module  # numba looks its functions up by module
    spec.loader.exec_module(module)
    advance: Callable[..., Any] = module.advance
    return advance


def _folder() -> Path:
    base = os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache"
    folder = Path(base) / "tam570"
    folder.mkdir(parents=True, exist_ok=True)
    return folder
