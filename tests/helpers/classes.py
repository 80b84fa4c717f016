"""Write the submissions of a class (files, notebooks, zip files), and read the tables and results of grading."""

import csv
import io
import json
import zipfile

from tam570_grader.results.records import CheckResult, Result

HW08 = "hw08_axis_angle"


def hand_in(folder, texts, slug=HW08, file="{0}/{0}.py"):
    """Write each student's text into the file `file` (formatted with slug) of the student's folder; return `folder`."""
    for student, text in texts.items():
        path = folder / student / file.format(slug)
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(text if isinstance(text, bytes) else text.encode())
    return folder


def notebook(*cells):
    """Return the text of a notebook with these code cells."""
    code = [{"cell_type": "code", "metadata": {}, "outputs": [], "source": text} for text in cells]
    title = {"cell_type": "markdown", "metadata": {}, "source": ["# hw08"]}
    return json.dumps({"cells": [title, *code], "metadata": {}, "nbformat": 4, "nbformat_minor": 5})


def packed(files):
    """Return the bytes of a zip file with these files ({name: text})."""
    data = io.BytesIO()
    with zipfile.ZipFile(data, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, text in files.items():
            archive.writestr(name, text)
    return data.getvalue()


def check_result(name="a", outcome="failed", points=0.0, message="", **fields):
    """Return the result of a check of part a with five points at most."""
    return CheckResult(name, "a", points, 5.0, outcome, message, **fields)


def result(student, *checks, slug=HW08, **fields):
    """Return the result of a submission, with the points of these checks."""
    points = [check.points for check in checks]
    fields = {"status": "graded", "score": None if None in points else sum(points, 0.0), **fields}
    sizes = {"max_score": 10.0, "seed": 1, "seconds": 0.1, "isolation": "bubblewrap"}
    return Result(student, slug, **{**sizes, **fields}, checks=checks)


def rows(path):
    """Return the rows of a CSV table as dictionaries."""
    with open(path, newline="", encoding="utf-8-sig") as file:
        return list(csv.DictReader(file))


def results(folder):
    """Return the records of a run, sorted by student and assignment."""
    records = [json.loads(line) for line in (folder / "results.jsonl").read_text().splitlines()]
    return sorted(records, key=lambda record: (record["student"], record["assignment"]))


def outcome(folder):
    """Return what must be equal in two runs: the results without their seconds, the grades, and the pages."""
    lines = [json.dumps({**record, "seconds": 0}) for record in results(folder)]
    pages = {path.relative_to(folder): path.read_text() for path in sorted((folder / "feedback").rglob("*.*"))}
    return lines, (folder / "grades.csv").read_text(), pages
