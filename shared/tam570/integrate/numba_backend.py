"""The same source compiled by numba (`pip install tam570[fast]`), kept on disk for the next process."""

import hashlib
import importlib.util
import inspect
import os
import sys
import textwrap
from collections.abc import Callable
from functools import lru_cache
from pathlib import Path
from typing import Any

__all__ = ["available", "loaded", "loaded_already", "module_source", "wait"]

IMPORT = 0.5  # s, of numba
READY = 0.05  # s, to load what was compiled before

_HEAD = '''"""Written by tam570 for one right-hand side; may be deleted at any time."""

from __future__ import annotations

from math import *

from numba import njit

from tam570.integrate.{module} import *
'''

_TAIL = """
inner = njit(error_model="numpy", no_cpython_wrapper=True, no_cfunc_wrapper=True)
{inner}, = [inner(function) for function in ({inner},)]
{entry} = njit(cache=True, error_model="numpy")({entry})
"""


def available() -> bool:
    """Whether numba is installed, and not forbidden by TAM570_NUMBA=0; it is not imported for that."""
    return os.environ.get("TAM570_NUMBA") != "0" and importlib.util.find_spec("numba") is not None


def module_source(maker: Callable[..., Any], generated: str, inner: str, entry: str) -> str:
    """A module of its own: the loop that `maker` makes, the functions that it calls (`inner`), both to be compiled."""
    head = _HEAD.format(module=maker.__module__.rpartition(".")[2])
    definition = inspect.getsource(maker).partition("\n\n")[2].rpartition("\n\n")[0]  # what stands inside
    return "\n\n".join([head, textwrap.dedent(definition), generated, _TAIL.format(inner=inner, entry=entry)])


def loaded_already(source: str) -> bool:
    """Whether this process has the compiled code."""
    return _name(source) in sys.modules


def wait(source: str, compile_cost: float = 1.0) -> float:
    """Seconds until compiled code could start; infinite without numba, or without a folder to keep it in."""
    if not available():
        return float("inf")
    try:
        folder = _folder()
    except (OSError, RuntimeError):  # a home that may not be written, or none at all
        return float("inf")
    imported = 0.0 if "numba" in sys.modules else IMPORT
    kept = any((folder / "__pycache__").glob(f"{_name(source)}*.nbi"))
    return imported + (READY if kept else compile_cost * _seconds_to_compile(source))


def _seconds_to_compile(source: str) -> float:
    """Fitted to what numba 0.68 took for systems of 2 to 15 components, on two cores of a shared server."""
    thousand_characters = len(source) / 1000
    return 0.5 + 0.05 * thousand_characters + 0.0008 * thousand_characters**2


@lru_cache(maxsize=64)
def loaded(source: str, entry: str) -> Callable[..., Any]:
    """The function `entry` of a module of that source, compiled at its first call."""
    name = _name(source)
    path = _folder() / f"{name}.py"
    if not path.exists():
        fresh = path.with_suffix(f".{os.getpid()}")
        fresh.write_text(source, encoding="utf-8")
        fresh.replace(path)  # at once: another process may want to read it
    spec = importlib.util.spec_from_file_location(name, path)
    assert spec is not None and spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    sys.modules[name] = module  # numba looks its functions up by module
    spec.loader.exec_module(module)
    function: Callable[..., Any] = getattr(module, entry)
    return function


@lru_cache(maxsize=64)
def _name(source: str) -> str:
    return "tam570_" + hashlib.sha256(source.encode()).hexdigest()[:24]


def _folder() -> Path:
    base = os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache"
    folder = Path(base) / "tam570"
    folder.mkdir(parents=True, exist_ok=True)
    if not os.access(folder, os.W_OK):
        raise PermissionError(f"{folder} may not be written: set XDG_CACHE_HOME to a folder for compiled code")
    return folder
