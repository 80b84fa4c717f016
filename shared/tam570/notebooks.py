"""The code of a notebook as plain Python: cells without magics and shell lines."""

import ast
import io
import json
import re
import tokenize
from types import CodeType
from typing import Any

__all__ = ["Cells", "code_cells", "compiled", "plain", "text_of"]

# %timeit, files = !ls, f?
MAGIC = re.compile(r"(\s*)(?:%time\s+(.*)|[%!?].*|[\w, ]+=\s*[%!].*|.*\?\s*)$", re.DOTALL)
# their body is Python; other cell magics hold another language
TIMED_CELLS = ("%%time", "%%capture", "%%prun")
Cells = list[tuple[int, str]]  # number, counted from 1 over all cells, and text


def code_cells(source: bytes) -> Cells:
    """The code cells that are Python, in a notebook of format 4 or 3. ValueError if it is not a notebook."""
    book: dict[str, Any] = json.loads(source)
    cells = book["cells"] if "cells" in book else [c for sheet in book["worksheets"] for c in sheet["cells"]]
    code = [
        (n, "".join(cell["source"] if "source" in cell else cell["input"]))
        for n, cell in enumerate(cells, start=1)
        if cell["cell_type"] == "code"
    ]
    return [(n, text) for n, text in code if not text.startswith("%%") or text.startswith(TIMED_CELLS)]


def text_of(source: bytes, suffix: str) -> str:
    """The Python in a module or notebook; of a cell that does not compile nothing."""
    if suffix == ".py":
        return source.decode(tokenize.detect_encoding(io.BytesIO(source).readline)[0])
    return "\n".join(plain(text) for _, text in code_cells(source))


def compiled(text: str, name: str) -> CodeType:
    """The code of a cell. SyntaxError where it is not Python."""
    return compile(plain(text) or text, name, "exec", dont_inherit=True)


def plain(text: str) -> str:
    """A cell without the lines at which Python's syntax ends, a `% 3` in a sum stays; "" if no Python is left."""
    lines = text.split("\n")
    while True:
        try:
            ast.parse("\n".join(lines))
            return "\n".join(lines)
        except SyntaxError as error:
            at = min(error.lineno or len(lines), len(lines)) - 1
            magic = MAGIC.match(lines[at])
            if not magic:
                return ""
            while lines[at].endswith("\\") and at + 1 < len(lines):  # the line goes on
                lines[at], at = "", at + 1
            lines[at] = magic[1] + (magic[2] or "pass")
