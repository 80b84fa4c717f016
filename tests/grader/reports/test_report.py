"""The instructor's page on a class: its numbers, its limits, and no script of a student in it."""

import base64
import hashlib
import io
import json
import re
from html.parser import HTMLParser

import numpy as np
import pytest
from PIL import Image

from tam570_grader import cli
from tam570_grader.checks.assignments import checks_folder
from tam570_grader.checks.failure import Failure
from tam570_grader.diagnosis.mistakes import mistakes
from tam570_grader.errors import UsageError
from tam570_grader.reports import report
from tam570_grader.reports.feedback import AssignmentInfo
from tam570_grader.reports.scenes import wrong_and_right
from tam570_grader.results import records

SLUGS = ("hw07_double_pendulum", "hw08_axis_angle")
SHEETS = {slug: AssignmentInfo(f"Title of {slug[:4]}", {}, {}, {}) for slug in SLUGS}


def check(name, outcome="passed", suspect=None, points=5.0):
    earned = {"passed": points, "grader_error": None}.get(outcome, 0.0)
    return {
        "name": name,
        "part": "a",
        "points": earned,
        "max_points": points,
        "outcome": outcome,
        "message": "",
        "suspect": suspect,
        "error": "a fault of ours",
    }


def record(student, slug, *marks, status="graded", seconds=0.1):
    points = [item["points"] for item in marks]
    score = None if None in points else sum(points)
    return {
        "student": student,
        "assignment": slug,
        "status": status,
        "score": score,
        "max_score": 10.0,
        "seed": 1,
        "seconds": seconds,
        "isolation": "bubblewrap",
        "checks": list(marks),
        "format": records.FORMAT,
    }


CLASS = [
    record("ada", SLUGS[0], check("first"), check("second"), seconds=0.5),
    record("ada", SLUGS[1], check("third"), check("fourth", "failed", "degrees for radians")),
    record("ben", SLUGS[0], check("first"), check("second", "failed", "the wrong sign"), seconds=9.0),
    record("ben", SLUGS[1], check("third", "failed", "degrees for radians"), check("fourth", "not_run")),
    record("cora", SLUGS[0], check("first", "grader_error"), check("second", "grader_error")),
    record("dan", SLUGS[0], check("first", "not_run"), check("second", "not_run"), status="missing"),
]


class Tables(HTMLParser):
    """The text of the cells of the tables, by the section that they are in."""

    def __init__(self):
        super().__init__()
        self.tables, self._section, self._cell = {}, None, None

    def handle_starttag(self, tag, attrs):
        if tag == "section":
            self._section = self.tables.setdefault(dict(attrs)["id"], [])
        elif tag == "tr":
            self._section.append([])
        elif tag in ("td", "th"):
            self._section[-1].append("")
            self._cell = True

    def handle_endtag(self, tag):
        if tag in ("td", "th"):
            self._cell = None

    def handle_data(self, data):
        if self._cell:
            self._section[-1][-1] += data.strip()


def page(lines, infos, roster=()):
    return report.report(report.newest(map(records.read, lines)), infos, roster)


def tables(text):
    parser = Tables()
    parser.feed(re.sub(r"<title>.*?</title>", "", text))
    return {name: rows[1:] for name, rows in parser.tables.items()}


@pytest.fixture(scope="module")
def rows():
    return tables(page(CLASS, SHEETS, ["eve"]))


def test_mistakes_are_counted_by_students(rows):
    assert [row[:3] for row in rows["lecture"]] == [
        ["2", "hw08", "degrees for radians"],
        ["1", "hw07", "the wrong sign"],
    ]


def test_the_share_that_passed_a_check_is_of_those_who_handed_in(rows):
    actual = {row[2]: row[4:5] + row[6:] for row in rows["checks"]}
    assert actual == {
        "first": ["66.7", "0", "0", "1"],
        "second": ["33.3", "1", "0", "1"],
        "third": ["50.0", "1", "0", "0"],
        "fourth": ["0.0", "1", "1", "0"],
    }


def test_every_student_has_a_row_of_scores(rows):
    assert rows["scores"] == [
        ["ada", "10", "5", "15"],
        ["ben", "5", "0", "5"],
        ["cora", "error", "", "0"],
        ["dan", "", "", "0"],
        ["eve", "", "", "0"],
    ]


def test_who_has_not_handed_in_is_named_those_on_the_roster_too(rows):
    assert [row[1:] for row in rows["absent"]] == [["2", "dan, eve"], ["3", "cora, dan, eve"]]


def test_names_and_errors_are_text_and_only_our_script_may_run():
    evil = "<script>alert(1)</script>\"'><img src=x onerror=alert(1)>"
    bad = record(evil, SLUGS[0], check("first", "grader_error", evil))
    bad["checks"][0]["error"] = bad["message"] = evil
    text = page([bad], {SLUGS[0]: AssignmentInfo(evil, {"first": evil}, {}, {})}, [evil])
    scripts = re.findall(r"<script>(.*?)</script>", text, re.DOTALL)
    assert len(scripts) == 1 and "<img src=x" not in text
    allowed = base64.b64encode(hashlib.sha256(scripts[0].encode()).digest()).decode()
    assert f"default-src 'none'; img-src data:; style-src 'unsafe-inline'; script-src 'sha256-{allowed}'" in text


def test_the_newest_result_counts_and_a_line_in_the_making_is_left_out(tmp_path):
    lines = [json.dumps(item) for item in (CLASS[2], {**CLASS[2], "score": 7.0}, CLASS[0])]
    (tmp_path / "results.jsonl").write_text("\n".join(lines) + '\n{"student": "zo')
    actual = report.results(tmp_path)
    assert [(student, item.score) for (student, _), item in actual.items()] == [("ada", 10.0), ("ben", 7.0)]


@pytest.mark.parametrize("text", [None, "", "my notes\n", "[1]\n", '{"student": "a", "assignment": "b"}\n'])
def test_what_holds_no_results_is_said_so(tmp_path, text, capsys):
    if text is not None:
        (tmp_path / "results.jsonl").write_text(text)
    with pytest.raises(UsageError, match=re.escape(str(tmp_path))):
        report.results(tmp_path)
    assert cli.main(["report", str(tmp_path)]) == 2
    assert "tam570-grader: error: " in capsys.readouterr().err


def test_the_command_writes_the_page_beside_the_feedback(tmp_path, capsys, solution_text):
    slug = SLUGS[1]
    (tmp_path / "in" / "ada" / slug).mkdir(parents=True)
    (tmp_path / "in" / "ada" / slug / f"{slug}.py").write_text(solution_text(slug))
    out = tmp_path / "out"
    assert cli.main(["grade", str(tmp_path / "in"), "--out", str(out)]) == 0
    assert cli.main(["report", str(out)]) == 0
    assert capsys.readouterr().out.splitlines()[-1] == str(out / "report.html")
    links = re.findall(r'href="([^"#]+)"', (out / "report.html").read_text())
    assert links and all((out / link).is_file() for link in links)
    assert cli.main(["report", str(tmp_path / "none")]) == 2


def images(pair):
    return [Image.open(io.BytesIO(base64.b64decode(text.partition(",")[2]))) for text in (pair.wrong, pair.reference)]


def test_a_mistake_is_drawn_beside_what_is_right(course):
    """By its scene where that shows it, else by a student's numbers or diagram; of words nothing is drawn."""
    fields = mistakes(checks_folder(course, SLUGS[1]))
    seen = [pair for item in fields[:6] if (pair := wrong_and_right(course, SLUGS[1], item.message, None))]
    failures = [
        Failure(actual=[1.0, 2.0, 3.0], expected=[1.0, 2.0, 4.0]),
        Failure(actual=np.zeros((20, 2)), expected=np.ones((20, 2))),
        Failure(
            sketch={"outline": [[0, 0, 200, 0]], "arrows": [[0, 0, 90], [0, 0, None]]},
            expected={"outline": [], "arrows": []},
        ),
    ]
    pairs = [wrong_and_right(course, SLUGS[1], "another", failure) for failure in failures]
    for pair in [*seen, *pairs]:
        wrong, correct = images(pair)
        assert wrong.size == correct.size and wrong.tobytes() != correct.tobytes()
    nothing = (
        None,
        Failure(actual="a"),
        Failure(actual=[1.0], expected=[np.nan]),
        Failure(actual=[1], expected=[1, 2]),
    )
    assert seen and not any(wrong_and_right(course, SLUGS[1], "another", failure) for failure in nothing)
