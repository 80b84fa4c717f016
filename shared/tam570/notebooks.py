"""The code of a notebook as plain Python: cells as IPython reads them, without magics and shell lines."""

import ast
import codecs
import inspect
import io
import itertools
import json
import re
import tokenize
from types import CodeType

from tam570.values import Json

# x = %time f(), %timeit, files = !ls, f?
MAGIC = re.compile(
    r"(\s*)(?:(\w+\s*=\s*)?%time\s+(.+)|(\w+\s*=\s*)[%!].*|[%!?].*|[\w, ]+=\s*[%!].*|[%\w.*\[\]]+\s*\?+\s*)"
)
# their body is Python; other cell magics hold another language, or a file
PYTHON_CELLS = ("%%time", "%%capture", "%%prun")
WRITTEN = re.compile(r"%%writefile +(?:-a +)?\S*\bhw\d\d\w*\.py\s")  # a cell that writes the module that is graded
PYLAB = "from matplotlib.pylab import *; import numpy as np; from matplotlib import pyplot as plt"  # what %pylab does
PROMPT = re.compile(r"(?:>>>|\.\.\.)(?: |$)|In \[\d+\]: ?|\s*\.\.\.: ?")  # copied with what stood behind it
LARGEST, LARGEST_WITH_OUTPUTS = 10 * 2**20, 100 * 2**20  # bytes, of a module, of a notebook that is read
OUTPUTS = rb'"outputs"\s*:\s*(?=\[)|"attachments"\s*:\s*(?=\{)'  # what a cell has shown, pictures in its text
TOKENS = re.compile(rb"(" + OUTPUTS + rb')|"[^"\\]*(?:\\.[^"\\]*)*"|([\[{])|[\]}]', re.DOTALL)
MOST_TOKENS = 3_000_000  # of a notebook that is worth reading
DECLARED = re.compile(rb"(?:.*\r?\n)?[ \t\f]*#.*coding[:=]")  # a line as PEP 263 has it
Cells = list[tuple[int, str]]  # number, counted from 1 over all cells, and text


def in_utf8(source: bytes) -> bytes:
    """Return the source of a module or notebook.

    What is not UTF-8 is read as UTF-16 if it begins as that does, and as Latin-1 if it does not say what it is.
    """
    try:
        source.decode()
    except UnicodeDecodeError:
        if source.startswith((codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)):
            return source.decode("utf-16", "replace").encode()
        return source if DECLARED.match(source) else source.decode("latin-1").encode()
    return source


def without_outputs(source: bytes) -> bytes:
    """Return the notebook without what its cells have shown, and without pictures in their text; its code is untouched.

    It is not parsed: of a hostile file no more is held than its bytes.
    """
    parts, begin, depth, first = list[bytes](), 0, 0, 0  # first: where outputs begin that are being left out, or 0
    for token in itertools.islice(TOKENS.finditer(source), MOST_TOKENS):
        outputs, opening = token.groups()
        if outputs and not first:
            depth, first = 0, token.end()
        elif opening:
            depth += 1
        elif first and token[0] in (b"]", b"}"):
            depth -= 1
            if depth == 0:
                parts += [source[begin:first], b"[]" if token[0] == b"]" else b"{}"]
                begin, first = token.end(), 0
    return b"".join([*parts, source[begin:]])


def code_cells(source: bytes) -> Cells:
    """Return the code cells that are Python, in a notebook of format 4 or 3. ValueError if it is not a notebook."""
    try:
        book: Json = json.loads(in_utf8(source))
        cells = book["cells"] if "cells" in book else [c for sheet in book["worksheets"] for c in sheet["cells"]]
        numbered = [(n, cell) for n, cell in enumerate(cells, start=1) if cell.get("cell_type") == "code"]
        code = [(n, _cleaned("".join(cell.get("source") or cell.get("input") or ""))) for n, cell in numbered]
    except (ValueError, LookupError, TypeError, AttributeError) as error:
        raise ValueError("this is no notebook that Jupyter opens") from error
    return [(n, text) for n, text in code if _is_python(text.lstrip())]


def _is_python(text: str) -> bool:
    return not text.startswith("%%") or text.split(maxsplit=1)[0] in PYTHON_CELLS or bool(WRITTEN.match(text))


def _cleaned(text: str) -> str:
    """Without the indent of the first line, and without prompts if that has one."""
    lines = text.split("\n")
    first = next(filter(str.strip, lines), "")
    indent = first[: len(first) - len(first.lstrip())]
    lines = [line.removeprefix(indent) for line in lines]
    if PROMPT.match(first.removeprefix(indent)):
        lines = [line[prompt.end() :] if (prompt := PROMPT.match(line)) else line for line in lines]
    return "\n".join(lines)


def text_of(source: bytes, suffix: str) -> str:
    """Return the Python in a module or notebook; of a cell that does not compile nothing."""
    if suffix == ".py":
        source = in_utf8(source)
        return source.decode(tokenize.detect_encoding(io.BytesIO(source).readline)[0])
    return "\n\n".join(plain(text) for _, text in code_cells(source))


def compiled(text: str, name: str) -> CodeType:
    """Return the code of a cell. SyntaxError where it is not Python."""
    awaiting: int = ast.PyCF_ALLOW_TOP_LEVEL_AWAIT
    code: CodeType = compile(plain(text) or text, name, "exec", awaiting, dont_inherit=True)
    return code


def run(code: CodeType, names: Json) -> None:
    """Run what was compiled, and wait for what it awaits outside of functions."""
    awaited = eval(code, names)
    if code.co_flags & inspect.CO_COROUTINE:
        import asyncio  # .05 s

        asyncio.run(awaited)


def plain(text: str) -> str:
    """Return a cell without the lines at which Python's syntax ends, a `% 3` in a sum stays.

    "" if no Python is left.
    """
    lines = text.split("\n")
    while True:
        try:
            ast.parse("\n".join(lines))
            return "\n".join(lines)
        except SyntaxError as error:
            at = min(error.lineno or len(lines), len(lines)) - 1
            magic = MAGIC.fullmatch(lines[at])
            if not magic:
                return ""
            while lines[at].endswith("\\") and at + 1 < len(lines) and not magic[3]:  # the line goes on
                lines[at], at = "", at + 1
            lines[at] = magic[1] + _python(magic)
        except (ValueError, MemoryError, RecursionError):  # no text, or nested too deep
            return ""


def _python(magic: re.Match[str]) -> str:
    """Return what stands for a magic: what it times, a kernel that does nothing for what it would return."""
    _, timed_to, timed, returned_to = magic.groups()
    if timed:
        return f"{timed_to or ''}{timed}"
    return f"{returned_to}get_ipython()" if returned_to else PYLAB if "%pylab" in magic[0] else "pass"


class _Kernel:
    """In place of a notebook's kernel: does nothing, whatever is asked of it."""

    def __getattr__(self, attribute: str) -> "_Kernel":
        return self

    def __call__(self, *args: object, **kwargs: object) -> "_Kernel":
        return self

    def __contains__(self, item: object) -> bool:
        return False


# built in, in a notebook and what it exports
KERNEL = {"display": lambda *shown, **how: None, "get_ipython": _Kernel()}
COLAB = "google.colab"


def kernel_module(name: str) -> object:
    """Return what an import of a notebook's service gives: something that does nothing; None for any other module."""
    return KERNEL["get_ipython"] if name == COLAB or name.startswith(f"{COLAB}.") else None
