"""The course in nbgrader, from release to feedback, by nbgrader's commands."""

import csv
import html
import json
import re
import warnings
from collections import Counter

import pytest

from tam570_grader import cli
from tam570_grader.checks import assignments
from tam570_grader.checks.failure import WHOLE
from tam570_grader.diagnosis.mistakes import overlays
from tam570_grader.reports.sentences import typeset

pytestmark = pytest.mark.slow  # minutes of nbgrader
MISTAKES = {  # slug: the mistake in ben's submission
    "hw07_double_pendulum": "too_few_steps",
    "hw08_axis_angle": "transposed_skew",
    "hw12_bead_on_wire": "motion_kept_for_other_wires",
}
TELLS = 8  # least characters of a hidden number; one as short as "0.0" may be on a page by chance
BY_HAND = 0.75  # share of the points of each part that is graded by hand


def regraded(course, checkout, slug, out):
    """Return the results of `tam570-grader grade` for the collected files, with the seed of autograde."""
    first = (course / "tam570_results" / slug / "results.jsonl").read_text().splitlines()[0]
    command = ["--root", str(checkout), "grade", str(course / "submitted"), "--only", slug, "--out", str(out)]
    assert cli.main([*command, "--seed", str(json.loads(first)["seed"])]) == 0
    return [json.loads(line) for line in (out / "results.jsonl").read_text().splitlines()]


class Term:
    """A course with two students: ann hands in the solution, ben the same with a mistake."""

    def __init__(self, checkout, folder, nbgrader, made_course):
        self.checkout, self.nbgrader = checkout, nbgrader
        self.course, config = made_course(folder, list(MISTAKES))
        self.homes = {name: folder / name for name in ("ann", "ben")}
        for home in self.homes.values():
            home.mkdir()
            (home / "nbgrader_config.py").write_text(config)

    def released(self):
        for slug in MISTAKES:
            self.nbgrader(self.course, "generate_assignment", slug)
            self.nbgrader(self.course, "release_assignment", slug)

    def handed_in(self, name, home):
        """Run a student's commands: list, fetch, validate (ann's solution must pass), submit."""
        listed = self.nbgrader(home, "list")
        assert all(slug in listed for slug in MISTAKES)
        self.nbgrader(home, "fetch_assignment", *MISTAKES)
        for slug, mistake in MISTAKES.items():
            wrong = overlays(assignments.checks_folder(self.checkout, slug))[mistake] if name == "ben" else ""
            solution = (self.checkout / "solutions" / f"{slug}.py").read_text()
            (home / slug / f"{slug}.py").write_text(f"{solution}\n\n{wrong}")
            answer_in_words(home / slug / f"{slug}.ipynb")
            if name == "ann":
                assert "Success" in self.nbgrader(home / slug, "validate", f"{slug}.ipynb")
            self.nbgrader(home, "submit", slug, "--student", name)
        cached = self.nbgrader(home, "list", "--cached")
        assert all(slug in cached for slug in MISTAKES)

    def graded(self):
        """Collect, autograde, grade parts by hand, release and fetch feedback, export the table."""
        for slug in MISTAKES:
            self.nbgrader(self.course, "collect", slug)
            self.nbgrader(self.course, "autograde", slug)
            grade_by_hand(self.course, slug)
            self.nbgrader(self.course, "generate_feedback", slug)
            self.nbgrader(self.course, "release_feedback", slug)
        for name, home in self.homes.items():
            for slug in MISTAKES:
                self.nbgrader(home, "fetch_feedback", slug, "--student", name)
        self.nbgrader(self.course, "export")

    def page(self, name, slug):
        """Return the feedback page that a student has fetched."""
        return next((self.homes[name] / slug / "feedback").rglob("*.html")).read_text()


def answer_in_words(path):
    actual = json.loads(path.read_text())
    for cell in actual["cells"]:
        if cell["metadata"].get("nbgrader", {}).get("solution"):
            cell["source"] = "As the momentum balance says."
    path.write_text(json.dumps(actual))


def grade_by_hand(course, slug):
    """Write a score for every manual part, as formgrader does when a teacher types one."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # SQLAlchemy warns about nbgrader's code
        from nbgrader.api import Gradebook

        with Gradebook(f"sqlite:///{course / 'gradebook.db'}") as book:
            for submission in book.find_assignment(slug).submissions:
                for grade in (grade for item in submission.notebooks for grade in item.grades):
                    if grade.name.startswith("manual-"):
                        grade.manual_score, grade.needs_manual_grade = BY_HAND * grade.max_score, False
            book.db.commit()


@pytest.fixture(scope="module")
def term(course, tmp_path_factory, nbgrader, made_course):
    """Return a term after release, submission, grading, feedback and export."""
    term = Term(course, tmp_path_factory.mktemp("term"), nbgrader, made_course)
    term.released()
    for name, home in term.homes.items():
        term.handed_in(name, home)
    term.graded()
    return term


def test_scores_are_those_of_the_grader(term, nbgrader_grades, tmp_path):
    """nbgrader's gradebook and its export have the points of `tam570-grader grade` for each part."""
    actual, fractions = nbgrader_grades(term.course), 0
    rows = csv.DictReader((term.course / "grades.csv").read_text().splitlines())
    exported = {(row["student_id"], row["assignment"]): row for row in rows}
    for slug in MISTAKES:
        manual = sum(part.points for part in assignments.assignment(term.checkout, slug).rubric.values())
        for record in regraded(term.course, term.checkout, slug, tmp_path / slug):
            who, parts = (record["student"], slug), Counter()
            for check in record["checks"]:
                parts[check["part"]] += check["points"]
            automatic = {cell: auto for (*at, cell), (auto, _) in actual.items() if tuple(at) == who and auto}
            assert automatic == pytest.approx({f"part-{p}": points for p, points in parts.items() if points})
            total = record["score"] + BY_HAND * manual
            assert float(exported[who]["score"]) == pytest.approx(total, abs=1e-9)
            assert float(exported[who]["max_score"]) == pytest.approx(record["max_score"] + manual)
            fractions += sum(points % 1 != 0 for points in parts.values())
            assert (record["score"] == record["max_score"]) == (record["student"] == "ann")
    assert fractions  # at least one score has a fraction


def test_the_feedback_says_what_was_lost(term):
    """Ben's pages have the messages and pictures of his failures; no page has a hidden number."""
    pictures, secrets = 0, 0
    for slug in MISTAKES:
        pages = [html.unescape(term.page(name, slug)) for name in term.homes]
        results = (term.course / "tam570_results" / slug / "results.jsonl").read_text().splitlines()
        ben = next(r for r in map(json.loads, results) if r["student"] == "ben")
        lost = [check for check in ben["checks"] if check["outcome"] == "failed"]
        assert lost, ben
        assert all(typeset(check["message"])[:40] in pages[1] for check in lost)
        details = json.dumps([check["failure"].get(key) for check in lost for key in WHOLE])
        hidden = [number for number in re.findall(r"[\d.e-]+", details) if len(number) >= TELLS]
        assert not [text for text in hidden for page in pages if text in page], slug
        secrets += len(hidden)
        curves = [curve for check in lost if (curve := check["failure"].get("curve"))]
        drawn = [1 + bool(curve.get("keeps")) for curve in curves]
        assert pages[1].count("</svg>") - pages[0].count("</svg>") == sum(drawn)
        pictures += len(drawn)
    assert pictures and secrets
