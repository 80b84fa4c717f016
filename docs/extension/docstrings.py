"""Docstrings without sections, for Sphinx: a run of lines `name : text` becomes a list, examples stay."""

import re

__all__ = ["listed", "setup"]

ARGUMENT = re.compile(r"(?P<names>[A-Za-z_]\w*(, \w+)*) +: (?P<text>\S.*)")
ITEM = "- "


def setup(app):
    app.connect("autodoc-process-docstring", _process)
    return {"parallel_read_safe": True}


def _process(app, what, name, obj, options, lines):
    if not any(line and set(line) == {"-"} for line in lines):  # sections of numpydoc are napoleon's
        lines[:] = listed(lines)


def listed(lines):
    """The lines with each argument as an item of a list; other blocks that are indented are code."""
    result, previous = [], ""
    for line in lines:
        block = _kind(line, previous)
        if block != previous:
            result += ["", "::", ""] if block == "code" else [""]
        result.append(_written(line, block))
        previous = block
    return result


def _kind(line, before):
    """Argument, code, list, example or prose: what a line is, by what stands before it."""
    if ARGUMENT.fullmatch(line):
        return "argument"
    if line.startswith(" ") or not line:
        return before if before or not line else "code"
    if line.startswith((">>>", "...")) or before == "example":
        return "example"
    return "list" if line.startswith(ITEM) else ""


def _written(line, block):
    match = ARGUMENT.fullmatch(line)
    if match:
        return f"* ``{match['names']}`` : {_safe(match['text'])}"
    if block == "argument":
        return f"  {_safe(line.strip())}"
    return line if block in ("code", "example") else _safe(line)


def _safe(text):
    """The text with what reStructuredText would read as markup escaped; code in backticks stays."""
    return re.sub(r"(`[^`]*`)|([*|])|(\w)_(?!\w)", lambda m: m[1] or (f"\\{m[2]}" if m[2] else f"{m[3]}\\_"), text)
