"""Parse submissions without running them: a notebook's cells as plain text of limited length, a module's statements."""

import io
import json
import tokenize
from typing import Any

MOST_CELLS, MOST_OUTPUTS = 500, 50
LONGEST_TEXT = 10_000  # characters of a text cell; rendering may take quadratic time
MOST_TEXT = 100_000  # characters of all text cells
LONGEST_CODE, LONGEST_OUTPUT, LONGEST_PICTURE = 50_000, 10_000, 3 * 2**20
CUT = "\n\n(cut: this is too long to show)"
SILENT = (tokenize.ENCODING, tokenize.COMMENT, tokenize.NL, tokenize.INDENT, tokenize.DEDENT)
SHOWN = ("text/plain", "image/png", "image/jpeg")

CellRecord = dict[str, Any]  # of nbformat


def plain_cells(source: bytes) -> list[CellRecord]:
    """Return the cells of a notebook of format 4 or 3: kind, source, id, grade_id, outputs, attachments of each."""
    book = json.loads(source)
    cells = book["cells"] if "cells" in book else [c for sheet in book["worksheets"] for c in sheet["cells"]]
    plain = [_plain(cell) for cell in cells[:MOST_CELLS]]
    if len(cells) > MOST_CELLS:
        plain.append({**_plain({}), "source": f"({len(cells) - MOST_CELLS} more cells are left out)"})
    remaining = MOST_TEXT
    for cell in plain:
        if cell["kind"] == "markdown":
            cell["source"] = _cut(cell["source"], min(remaining, LONGEST_TEXT))
            remaining = max(0, remaining - len(cell["source"]))
    return plain


def statements(source: bytes) -> str:
    """Return a module's tokens, a statement per line, without comments, blank lines and lone strings (docstrings).

    Raise SyntaxError if it is not Python. There is no syntax tree, because a sum of a thousand terms is too deep.
    """
    lines: list[list[str]] = [[]]
    try:
        for token in tokenize.tokenize(io.BytesIO(source).readline):
            if token.type in (tokenize.NEWLINE, tokenize.ENDMARKER):
                lines += [[]] if lines[-1] else []
            elif token.type not in SILENT:
                lines[-1].append(token.string)
    except tokenize.TokenError as error:
        raise SyntaxError(str(error)) from None
    return "".join(f"{' '.join(line)}\n" for line in lines if line and not (len(line) == 1 and line[0][-1] in "'\""))


def _plain(cell: CellRecord) -> CellRecord:
    code = cell.get("cell_type") == "code"
    source = _text(cell["source"] if "source" in cell else cell.get("input", ""))
    noted = cell.get("metadata", {}).get("nbgrader")
    name = noted.get("grade_id") if isinstance(noted, dict) else None
    outputs = cell.get("outputs", []) if code else []
    return {
        "kind": "code" if code else "raw" if cell.get("cell_type") == "raw" else "markdown",
        "source": _cut(source, LONGEST_CODE),
        "id": _text(cell.get("id", ""))[:100],
        "grade_id": _text(name)[:100],
        "outputs": [shown for output in outputs[:MOST_OUTPUTS] if (shown := _output(output))],
        "attachments": {
            str(key)[:100]: _bundle(output)
            for key, output in list((cell.get("attachments") or {}).items())[:MOST_OUTPUTS]
        },
    }


def _output(output: object) -> CellRecord | None:
    """Return an output in nbformat's form, with texts of limited length; None if it is not an output."""
    if not isinstance(output, dict):
        return None
    if output.get("output_type") == "stream":
        return {"output_type": "stream", "text": _cut(_text(output.get("text")), LONGEST_OUTPUT)}
    if output.get("output_type") == "error":
        texts = {key: _cut(_text(output.get(key)), LONGEST_OUTPUT) for key in ("ename", "evalue")}
        return {"output_type": "error", **texts}
    return {"output_type": "display_data", "data": _bundle(output.get("data"))}


def _bundle(data: object) -> dict[str, str]:
    """Return the text, cut, and the pictures, if they are not too large, in an output's data."""
    texts = {mime: _text(data[mime]) for mime in SHOWN if mime in data} if isinstance(data, dict) else {}
    plain = {"text/plain": _cut(texts.pop("text/plain"), LONGEST_OUTPUT)} if "text/plain" in texts else {}
    return plain | {mime: text for mime, text in texts.items() if len(text) <= LONGEST_PICTURE}


def _text(value: object) -> str:
    texts = [text for text in (value if isinstance(value, list) else [value]) if isinstance(text, str)]
    return "".join(texts).encode("utf-8", "replace").decode()  # replaces lone surrogates


def _cut(text: str, most: int) -> str:
    return text if len(text) <= most else text[:most] + CUT
