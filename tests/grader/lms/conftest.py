"""An instructor's desk: a folder with tables and downloads, and the grader's commands given there."""

import csv

import classes
import pytest
from classes import HW08, packed, result

from tam570_grader import cli
from tam570_grader.results.store import ResultStore


class Desk:
    """`desk(*command)` -> exit code and what was printed; tables are written and read as spreadsheets do."""

    def __init__(self, folder, course, capsys):
        self.folder, self._capsys, self._root = folder, capsys, ["--root", str(course)]

    def __call__(self, *command):
        code = cli.main([*self._root, *map(str, command)])
        return code, "".join(self._capsys.readouterr())

    def trust(self, text):
        """Write and trust course.toml, which the commands obey from now on."""
        self.write("course.toml", text)
        self._root = []
        assert self("trust")[0] == 0

    def write(self, name, content):
        if isinstance(content, bytes):
            (self.folder / name).write_bytes(content)
        elif isinstance(content, str):
            (self.folder / name).write_text(content)
        else:
            with open(self.folder / name, "w", newline="", encoding="utf-8-sig") as file:
                csv.writer(file).writerows(content)

    def read(self, name):
        with open(self.folder / name, newline="", encoding="utf-8-sig") as file:
            return list(csv.reader(file))

    def rows(self, name):
        return classes.rows(self.folder / name)

    def write_grades(self, scores, slug=HW08):
        """Write grades.csv: {student: score}, of ten points."""
        rows = [(student, slug, "graded", score, 10) for student, score in scores.items()]
        self.write("grades.csv", [("student", "assignment", "status", "score", "max_score"), *rows])

    def write_results(self, scores):
        """Write results of no checks: {(student, assignment): score}, of ten points."""
        store = ResultStore(self.folder / "results")
        for (student, slug), score in scores.items():
            store.add(result(student, slug=slug, score=score).record())
        store.close()

    def scores(self, slug=HW08):
        """{student: score} of an assignment, by results/grades.csv."""
        rows = self.rows("results/grades.csv")
        return {row["student"]: float(row["score"]) for row in rows if row["assignment"] == slug}

    @property
    def collected(self):
        """The text of each student's module of hw08, beside which nothing is collected."""
        files = list((self.folder / "submitted").glob(f"*/{HW08}/*"))
        assert {path.name for path in files} <= {f"{HW08}.py"}
        return {path.parts[-3]: path.read_text() for path in files}


@pytest.fixture
def desk(here, course, capsys):
    return Desk(here, course, capsys)


@pytest.fixture
def download(desk):
    """`download(system, files, roster, *more)` -> exit code and what was printed, of a download of these files."""

    def download(system, files, roster=None, *more):
        desk.write("a.zip", packed(files))
        if roster:
            desk.write("roster.csv", roster)
        return desk("collect", "a.zip", "--from", system, *["--roster", "roster.csv"] * bool(roster), *more)

    return download
