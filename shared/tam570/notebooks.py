"""Convert the code of a notebook to plain Python: cells as IPython reads them, without magics and shell commands."""

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

# lines such as x = %time f(), %timeit f(), files = !ls, f?
MAGIC = re.compile(
    r"(\s*)(?:(\w+\s*=\s*)?%time\s+(.+)|(\w+\s*=\s*)[%!].*|[%!?].*|[\w, ]+=\s*[%!].*|[%\w.*\[\]]+\s*\?+\s*)"
)
# cell magics whose body is Python; the body of others is another language or a file
PYTHON_CELLS = ("%%time", "%%capture", "%%prun")
WRITTEN = re.compile(r"%%writefile +(?:-a +)?\S*\bhw\d\d\w*\.py\s")  # a cell that writes the module that is graded
PYLAB = "from matplotlib.pylab import *; import numpy as np; from matplotlib import pyplot as plt"  # for %pylab
PROMPT = re.compile(r"(?:>>>|\.\.\.)(?: |$)|In \[\d+\]: ?|\s*\.\.\.: ?")  # pasted together with the code after it
LARGEST, LARGEST_WITH_OUTPUTS = 10 * 2**20, 100 * 2**20  # bytes of a file, of a notebook with its outputs
OUTPUTS = rb'outputs"\s*:\s*(?=\[)|attachments"\s*:\s*(?=\{)'  # outputs of a cell, pictures in its text
# A string without an end goes to the end of the file: the search is linear and never goes back. Each alternative begins
# with one character, so that the search skips all others at once.
TOKENS = re.compile(rb'"(' + OUTPUTS + rb')|"[^"\\]*+(?:\\.[^"\\]*+)*+"?|\[|\{|\]|\}', re.DOTALL)
MOST_TOKENS = 3_000_000  # read in a notebook; outputs beyond are kept
DECLARED = re.compile(rb"(?:.*\r?\n)?[ \t\f]*#.*coding[:=]")  # an encoding, declared as in PEP 263
Cells = list[tuple[int, str]]  # number, counted from 1 over all cells, and text


def in_utf8(source: bytes) -> bytes:
    """Return the source of a module or notebook in UTF-8.

    Source that is not UTF-8 is read as UTF-16 if it begins with a byte order mark. Else it is returned unchanged if it
    declares its encoding, and read as Latin-1 if it does not.
    """
    try:
        source.decode()
    except UnicodeDecodeError:
        if source.startswith((codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)):
            return source.decode("utf-16", "replace").encode()
        return source if DECLARED.match(source) else source.decode("latin-1").encode()
    return source


def without_outputs(source: bytes) -> bytes:
    """Return the notebook with the same code, without its cells' outputs and the pictures in their text.

    It is searched and not parsed, so that a hostile file needs no more memory than its bytes.
    """
    parts, begin, depth, first = list[bytes](), 0, 0, 0  # first: start of the outputs being removed, or 0
    for token in itertools.islice(TOKENS.finditer(source), MOST_TOKENS):
        if token[1] and not first:
            depth, first = 0, token.end()
        elif token[0] in (b"[", b"{"):
            depth += 1
        elif first and token[0] in (b"]", b"}"):
            depth -= 1
            if depth == 0:
                parts += [source[begin:first], b"[]" if token[0] == b"]" else b"{}"]
                begin, first = token.end(), 0
    return b"".join([*parts, source[begin:]])


def code_cells(source: bytes) -> Cells:
    """Return the Python cells of a notebook in format 4 or 3. Raise ValueError if it is not a notebook."""
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
    """Remove the first line's indentation from all lines, and prompts if the first line has one."""
    lines = text.split("\n")
    first = next(filter(str.strip, lines), "")
    indent = first[: len(first) - len(first.lstrip())]
    lines = [line.removeprefix(indent) for line in lines]
    if PROMPT.match(first.removeprefix(indent)):
        lines = [line[prompt.end() :] if (prompt := PROMPT.match(line)) else line for line in lines]
    return "\n".join(lines)


def text_of(source: bytes, suffix: str) -> str:
    """Return the Python source of a module or notebook, without cells that do not compile."""
    if suffix == ".py":
        source = in_utf8(source)
        return source.decode(tokenize.detect_encoding(io.BytesIO(source).readline)[0])
    return "\n\n".join(plain(text) for _, text in code_cells(source))


def compiled(text: str, name: str) -> CodeType:
    """Compile a cell. Raise SyntaxError if it is not Python."""
    awaiting: int = ast.PyCF_ALLOW_TOP_LEVEL_AWAIT
    code: CodeType = compile(plain(text) or text, name, "exec", awaiting, dont_inherit=True)
    return code


def run(code: CodeType, names: Json) -> None:
    """Run a compiled cell to its end, with any `await` outside of functions."""
    awaited = eval(code, names)
    if code.co_flags & inspect.CO_COROUTINE:
        import asyncio  # not at the top: it takes 0.05 s

        asyncio.run(awaited)


def plain(text: str) -> str:
    """Return a cell without magics and shell commands; "" if the rest is not Python.

    Only a line at which the parser fails is replaced, so that a line `% 3` in a sum stays.
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
            while lines[at].endswith("\\") and at + 1 < len(lines) and not magic[3]:  # continuation lines
                lines[at], at = "", at + 1
            lines[at] = magic[1] + _python(magic)
        except (ValueError, MemoryError, RecursionError):  # a null byte, or nested too deeply
            return ""


def _python(magic: re.Match[str]) -> str:
    """Return the replacement for a magic: the code that it times, a dummy as its result, %pylab's imports, or pass."""
    _, timed_to, timed, returned_to = magic.groups()
    if timed:
        return f"{timed_to or ''}{timed}"
    return f"{returned_to}get_ipython()" if returned_to else PYLAB if "%pylab" in magic[0] else "pass"


class _Kernel:
    """Dummy for a notebook's kernel, whose attributes and calls do nothing."""

    def __getattr__(self, attribute: str) -> "_Kernel":
        return self

    def __call__(self, *args: object, **kwargs: object) -> "_Kernel":
        return self

    def __contains__(self, item: object) -> bool:
        return False


# built-in names in a notebook and in a module exported from it
KERNEL = {"display": lambda *shown, **how: None, "get_ipython": _Kernel()}
COLAB = "google.colab"


def kernel_module(name: str) -> object:
    """Return a dummy for a module that only a notebook service (Colab) has; None for any other module."""
    return KERNEL["get_ipython"] if name == COLAB or name.startswith(f"{COLAB}.") else None
