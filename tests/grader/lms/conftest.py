"""Fixtures: an instructor's folder with tables and downloads, in which the grader's commands run."""

import csv

import classes
import pytest
from classes import HW08, packed, result

from tam570_grader import cli
from tam570_grader.results.store import ResultStore


class Desk:
    """An instructor's folder. `desk(*command)` -> (exit code, output); tables are written as spreadsheets do."""

    def __init__(self, folder, course, capsys):
        self.folder, self._capsys, self._root = folder, capsys, ["--root", str(course)]

    def __call__(self, *command):
        code = cli.main([*self._root, *map(str, command)])
        return code, "".join(self._capsys.readouterr())

    def trust(self, text):
        """Write course.toml and trust it; later commands use it."""
        self.write("course.toml", text)
        self._root = []
        assert self("trust")[0] == 0

    def write(self, name, content):
        if isinstance(content, bytes | str):
            (self.folder / name).write_bytes(content if isinstance(content, bytes) else content.encode())
        else:
            with open(self.folder / name, "w", newline="", encoding="utf-8-sig") as file:
                csv.writer(file).writerows(content)

    def read(self, name):
        with open(self.folder / name, newline="", encoding="utf-8-sig") as file:
            return list(csv.reader(file))

    def rows(self, name):
        return classes.rows(self.folder / name)

    def write_grades(self, scores, slug=HW08):
        """Write grades.csv from {student: score}, of ten points each."""
        rows = [(student, slug, "graded", score, 10) for student, score in scores.items()]
        self.write("grades.csv", [("student", "assignment", "status", "score", "max_score"), *rows])

    def write_results(self, scores):
        """Write results without checks from {(student, assignment): score}, of ten points each."""
        store = ResultStore(self.folder / "results")
        for (student, slug), score in scores.items():
            store.add(result(student, slug=slug, score=score).record())
        store.close()

    def scores(self, slug=HW08):
        """Return {student: score} of an assignment in results/grades.csv."""
        rows = self.rows("results/grades.csv")
        return {row["student"]: float(row["score"]) for row in rows if row["assignment"] == slug}

    @property
    def collected(self):
        """{student: text of the collected module of hw08}; assert that no other file was collected with it."""
        files = list((self.folder / "submitted").glob(f"*/{HW08}/*"))
        assert {path.name for path in files} <= {f"{HW08}.py"}
        return {path.parts[-3]: path.read_text() for path in files}


@pytest.fixture
def desk(here, course, capsys):
    return Desk(here, course, capsys)


@pytest.fixture
def download(desk):
    """`download(system, files, roster, *more)` -> (exit code, output) of `collect` with a zip file of these files."""

    def download(system, files, roster=None, *more):
        desk.write("a.zip", packed(files))
        if roster:
            desk.write("roster.csv", roster)
        return desk("collect", "a.zip", "--from", system, *["--roster", "roster.csv"] * bool(roster), *more)

    return download
