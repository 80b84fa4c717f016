"""An instructor's desk: a folder with tables and downloads, and the grader's commands given there."""

import csv

import pytest
from classes import HW08

from tam570_grader import cli


class Desk:
    """`desk(*command)` -> exit code and what was said; tables are written and read as spreadsheets do."""

    def __init__(self, place, course, capsys):
        self.place, self._course, self._capsys = place, course, capsys

    def __call__(self, *command, root=None):
        code = cli.main(["--root", str(root or self._course), *map(str, command)])
        return code, "".join(self._capsys.readouterr())

    def write(self, name, content):
        if isinstance(content, bytes):
            (self.place / name).write_bytes(content)
        elif isinstance(content, str):
            (self.place / name).write_text(content)
        else:
            with open(self.place / name, "w", newline="", encoding="utf-8-sig") as file:
                csv.writer(file).writerows(content)

    def read(self, name):
        with open(self.place / name, newline="", encoding="utf-8-sig") as file:
            return list(csv.reader(file))

    def write_grades(self, scores, slug=HW08):
        """Write grades.csv: {student: score}, of ten points."""
        rows = [(student, slug, "graded", score, 10) for student, score in scores.items()]
        self.write("grades.csv", [("student", "assignment", "status", "score", "max_score"), *rows])

    @property
    def collected(self):
        """The text of each student's module of hw08."""
        return {path.parts[-3]: path.read_text() for path in (self.place / "submitted").glob(f"*/{HW08}/*.py")}


@pytest.fixture
def desk(tmp_path, monkeypatch, course, capsys):
    monkeypatch.chdir(tmp_path)
    return Desk(tmp_path, course, capsys)
