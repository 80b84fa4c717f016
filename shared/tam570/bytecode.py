"""A cache of compiled code for later processes, beside Python's own."""

import importlib.util
import marshal
import sys
from collections.abc import Callable
from contextlib import suppress
from importlib.machinery import SourceFileLoader
from types import CodeType


def cached_code(file: str, name: str, inputs: bytes, compiled: Callable[[], CodeType]) -> CodeType:
    """Return `compiled()`, or its result for the same inputs from a cache beside the byte code of `file`.

    inputs : everything that the code depends on
    """
    loader, path = SourceFileLoader(name, file), importlib.util.cache_from_source(file, optimization=name)
    key = importlib.util.MAGIC_NUMBER + importlib.util.source_hash(bytes([sys.flags.optimize]) + inputs)
    with suppress(OSError):
        if (stored := loader.get_data(path)).startswith(key):
            code: CodeType = marshal.loads(stored[len(key) :])
            return code
    code = compiled()
    if not sys.dont_write_bytecode:
        loader.set_data(path, key + marshal.dumps(code))  # atomic: it renames a temporary file
    return code
