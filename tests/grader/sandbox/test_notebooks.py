"""`cells_of` reads a notebook in another process; it returns short plain cells, or raises Unshown."""

import json

import pytest

from tam570_grader.protocol import cells as protocol_cells
from tam570_grader.sandbox.notebooks import Unshown, cells_of


def book(*cells, **other):
    return json.dumps({"cells": cells, **other}).encode()


def words(text, cell_type="markdown", **other):
    return {"cell_type": cell_type, "metadata": {}, "source": text, **other}


def test_what_is_shown_of_a_cell():
    stream = {"output_type": "stream", "text": ["a", "b"]}
    picture = {"output_type": "display_data", "data": {"image/png": "aGk=", "text/html": "<script>"}}
    code = words(["x = 1\n", "x"], "code", outputs=[stream, picture, 3], metadata={"nbgrader": {"grade_id": "a"}})
    first, second = cells_of(book(words("text"), code))
    assert (first["kind"], first["source"]) == ("markdown", "text")
    assert (second["kind"], second["source"], second["grade_id"]) == ("code", "x = 1\nx", "a")
    assert [item.get("text") or item["data"] for item in second["outputs"]] == ["ab", {"image/png": "aGk="}]


@pytest.mark.parametrize("text", [b"[" * 3_000_000, b'{"cells": [3]}', b"[]", b"{}", b'{"cells": {"a": 1}}', b"\xff"])
def test_a_strange_notebook_is_told_and_harms_nobody(text):
    with pytest.raises(Unshown):
        cells_of(text)
    assert len(cells_of(book(words("the next")))) == 1


def test_many_cells_and_long_ones_are_cut():
    assert len(cells_of(book(*[words("x")] * 60_000))) == protocol_cells.MOST_CELLS + 1
    cells = cells_of(book(*[words(r"\begin{a} " * 16_000)] * 40, words("x" * 10**6, "code")))
    shown = sum(len(cell["source"]) - len(protocol_cells.CUT) for cell in cells if cell["kind"] == "markdown")
    assert shown <= protocol_cells.MOST_TEXT
    assert len(cells[0]["source"]) <= protocol_cells.LONGEST_TEXT + len(protocol_cells.CUT)
    assert len(cells[-1]["source"]) <= protocol_cells.LONGEST_CODE + len(protocol_cells.CUT)
