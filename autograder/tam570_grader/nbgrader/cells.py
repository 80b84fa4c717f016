"""The cells of a graded notebook: the grader's outputs, and the parts of a student's outputs that are safe to keep."""

import re
from collections.abc import Iterable
from typing import Any

import nbformat

from tam570.values import Json
from tam570_grader.errors import printable
from tam570_grader.grading.submissions import Submission
from tam570_grader.release.notebook import FORMAT
from tam570_grader.reports.feedback import SIGNS, AssignmentInfo, overall, shown, template
from tam570_grader.results.records import Result

Notebook = Any  # nbformat has no types

# Kept in a student's outputs; HTML and SVG could contain scripts that run in the instructor's browser.
PICTURES = ("image/png", "image/jpeg")
CELL_ID = re.compile(r"[A-Za-z0-9_-]{1,64}")  # nbformat's rule
BASE64 = re.compile(r"[A-Za-z0-9+/=\s]*")
NO_MODULE = "No {slug}.py with functions is in the folder; the grader looked for them in {name}."


def rebuilt(cells: Iterable[Json]) -> Notebook:
    """Return a notebook of a student's cells, which the sandbox has parsed, with safe outputs only."""
    ours = []
    for number, cell in enumerate(cells):
        noted = {"nbgrader": {"grade_id": cell["grade_id"]}} if cell["grade_id"] else {}
        name = cell["id"] if CELL_ID.fullmatch(cell["id"]) else f"cell-{number}"
        fields = {"cell_type": cell["kind"], "id": name, "metadata": noted, "source": cell["source"]}
        if cell["kind"] == "code":
            fields |= {"execution_count": None, "outputs": [*filter(None, map(safe, cell["outputs"]))]}
        elif cell["attachments"]:
            fields["attachments"] = cell["attachments"]
        ours.append(fields)
    return node({**FORMAT, "metadata": {}, "cells": ours})


def remark(submission: Submission, result: Result) -> str:
    """Return the sentences on a submission as a whole; "" if there are none."""
    slug, path = submission.slug, submission.path
    elsewhere = path is not None and path.name != f"{slug}.py"
    sentence = NO_MODULE.format(slug=slug, name=printable(path.name)) if elsewhere and path else ""
    return " ".join(filter(None, (sentence, overall(result.status, result.message))))


def marked(result: Result, part: str, info: AssignmentInfo, sentence: str) -> list[Notebook]:
    """Return a locked cell's outputs: messages and pictures of the part, then its points, which nbgrader reads."""
    checks = [check for check in result.checks if check.part == part]
    marks = [shown(check, info, result.message) for check in checks]
    earned = round(sum(check.points or 0.0 for check in checks), 6)
    page = template("part.html").render(slug=result.assignment, marks=marks, remark=sentence)
    plain = "\n".join([*([sentence] if sentence else []), *map(_plain, marks)])
    return [
        _output("display_data", data={"text/html": page, "text/plain": plain}, metadata={}),
        _output("execute_result", data={"text/plain": repr(earned)}, metadata={}, execution_count=1),
    ]


def _plain(check: Json) -> str:
    messages = [check["message"], check["suspect"]] if check["outcome"] != "passed" else []
    first = f"{SIGNS[check['outcome']]} {check['points']}/{check['max_points']} {check['line']}"
    return "\n  ".join([first, *filter(None, messages)])


def safe(output: Notebook) -> Notebook | None:
    """Return an output reduced to plain text and pictures, which no browser executes; None if nothing is left."""
    output_type = output.get("output_type")
    if output_type == "stream":
        return _output("stream", name="stdout", text=_text(output.get("text")))
    if output_type == "error":
        return _output("stream", name="stdout", text=f"{output.get('ename')}: {output.get('evalue')}")
    bundle = output.get("data")
    data = {mime: text for mime, text in bundle.items() if _picture(mime, text)} if isinstance(bundle, dict) else {}
    if not data and isinstance(bundle, dict) and "text/plain" in bundle:
        data = {"text/plain": _text(bundle["text/plain"])}
    return _output("display_data", data=data, metadata={}) if data else None


def pictures_only(attachments: object) -> bool:
    """Return whether all attachments of a text cell are pictures."""
    return isinstance(attachments, dict) and all(
        isinstance(attachment, dict) and all(_picture(mime, text) for mime, text in attachment.items())
        for attachment in attachments.values()
    )


def _picture(mime: str, text: object) -> bool:
    return mime in PICTURES and isinstance(text, str) and bool(BASE64.fullmatch(text))


def _text(value: object) -> str:
    return "".join(map(str, value)) if isinstance(value, list) else str(value)


def _output(output_type: str, **content: object) -> Notebook:
    return node({"output_type": output_type, **content})


def node(content: Json) -> Notebook:
    """Return nbformat's node for a notebook or a part of one."""
    return nbformat.from_dict(content)  # type: ignore[no-untyped-call]


def grade_id(cell: Notebook) -> str:
    """Return nbgrader's grade id of a cell, "" if it has none."""
    noted = cell.metadata.get("nbgrader")
    name = noted.get("grade_id") if isinstance(noted, dict) else None
    return name if isinstance(name, str) else ""
