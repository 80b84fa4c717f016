"""The report on a class: its numbers, students who share a wrong result, and no scripts of students."""

import base64
import hashlib
import io
import json
import re
from dataclasses import replace

import numpy as np
import pytest
from classes import HW08, check_result, hand_in, result
from PIL import Image

from tam570_grader import cli
from tam570_grader.checks.assignments import checks_folder
from tam570_grader.checks.failure import Failure
from tam570_grader.diagnosis.mistakes import mistakes
from tam570_grader.errors import UsageError
from tam570_grader.reports import report
from tam570_grader.reports.feedback import AssignmentInfo
from tam570_grader.reports.scenes import wrong_and_right
from tam570_grader.results.shared import groups, signs_of

SLUGS = ("hw07_double_pendulum", "hw08_axis_angle")
INFOS = {slug: AssignmentInfo(f"Title of {slug[:4]}", {}, {}, {}) for slug in SLUGS}
ODD = np.array([0.123456789012345, -2.0, 0.7])


def check(name, outcome="passed", cause=None, **fields):
    points = {"passed": 5.0, "grader_error": None}.get(outcome, 0.0)
    return check_result(name, outcome, points, suspect=cause, **fields)


CLASS = [
    result("ada", check("first"), check("second"), slug=SLUGS[0], seconds=0.5),
    result("ada", check("third"), check("fourth", "failed", "degrees for radians")),
    result("ben", check("first"), check("second", "failed", "the wrong sign"), slug=SLUGS[0], seconds=9.0),
    result("ben", check("third", "failed", "degrees for radians"), check("fourth", "not_run")),
    result("cora", check("first", "grader_error"), check("second", "grader_error"), slug=SLUGS[0]),
    result("dan", check("first", "not_run"), check("second", "not_run"), slug=SLUGS[0], status="missing"),
]


@pytest.fixture(scope="module")
def rows():
    """Return {section: for each row of its tables but the heading, the texts of the cells}."""
    page = re.sub(r"<title>.*?</title>", "", report.report(report.newest(CLASS), INFOS, ["eve"]))

    def cells(row):
        texts = (re.split("</t[abdhr]", cell)[0] for cell in re.split(r"<t[dh]\b[^>]*>", row)[1:])
        return ["".join(part.strip() for part in re.split("<[^>]+>", text)) for text in texts]

    _, *parts = re.split(r'<section[^>]*\bid="?(\w+)"?[^>]*>', page)
    tables = zip(parts[::2], parts[1::2], strict=True)
    return {name: [cells(row) for row in re.split(r"<tr\b", text)[2:]] for name, text in tables}


def test_mistakes_are_counted_by_students_and_checks_by_those_who_handed_in(rows):
    counted = [["2", "hw08", "degrees for radians"], ["1", "hw07", "the wrong sign"]]
    assert [row[:3] for row in rows["lecture"]] == counted
    assert {row[2]: row[4:5] + row[6:] for row in rows["checks"]} == {
        "first": ["66.7", "0", "0", "1"],
        "second": ["33.3", "1", "0", "1"],
        "third": ["50.0", "1", "0", "0"],
        "fourth": ["0.0", "1", "1", "0"],
    }


def test_what_follows_from_a_mistake_is_told_after_it_and_without_its_hint():
    follows = check("rotate", "failed", failure=Failure("x", hint="What becomes of it?", follows_from="skew"))
    ada = result("ada", follows, check("skew", "failed", "the wrong sign"))
    page = report.report(report.newest([ada]), INFOS)
    assert "What becomes" not in page and page.index("the wrong sign") < page.index("It follows from skew.")


def test_a_class_whose_files_do_not_run_is_not_said_to_fail_nothing():
    ada = result("ada", check("first"), slug=SLUGS[0])
    fallen = result("ben", check("first", "not_run"), slug=SLUGS[0], status="unreadable")
    pages = [report.report(report.newest(results), INFOS) for results in ([ada], [ada, fallen])]
    assert ["Nobody failed" in page for page in pages] == [True, False]
    assert ["ben hw07 (unreadable)" in page for page in pages] == [False, True]


def test_everybody_has_a_row_and_who_handed_in_nothing_is_named(rows):
    scores = {"ada": ["10", "5", "15"], "ben": ["5", "0", "5"], "cora": ["error", "", "0"]}
    assert {row[0]: row[1:] for row in rows["scores"]} == scores | dict.fromkeys(("dan", "eve"), ["", "", "0"])
    assert [row[1:] for row in rows["absent"]] == [["2", "dan, eve"], ["3", "cora, dan, eve"]]


def test_names_and_errors_are_text_and_only_our_script_may_run():
    evil = "<script>alert(1)</script>\"'><img src=x onerror=alert(1)>"
    bad = result(evil, check("first", "grader_error", evil, error=evil), message=evil)
    text = report.report(report.newest([bad]), {SLUGS[1]: AssignmentInfo(evil, {"first": evil}, {}, {})}, [evil])
    scripts = re.findall(r"<script>(.*?)</script>", text, re.DOTALL)
    assert len(scripts) == 1 and "<img src=x" not in text
    allowed = base64.b64encode(hashlib.sha256(scripts[0].encode()).digest()).decode()
    assert f"default-src 'none'; img-src data:; style-src 'unsafe-inline'; script-src 'sha256-{allowed}'" in text


def test_the_newest_result_counts_and_a_line_in_the_making_is_left_out(tmp_path):
    lines = [json.dumps(item.record()) for item in (CLASS[2], replace(CLASS[2], score=7.0), CLASS[0])]
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


def test_a_mistake_is_drawn_beside_what_is_right(course):
    """The report draws the scene if it shows the mistake, else a student's numbers or diagram, and nothing for text."""
    messages = [item.message for item in mistakes(checks_folder(course, SLUGS[1]))]
    seen = next(pair for message in messages if (pair := wrong_and_right(course, SLUGS[1], message, None)))
    sketch = {"body": "the mass", "outline": [[0, 0, 200, 0]], "arrows": [[0, 0, 90], [0, 0, None]]}
    failures = [
        Failure(actual=[1.0, 2.0, 3.0], expected=[1.0, 2.0, 4.0]),
        Failure(actual=np.zeros((20, 2)), expected=np.ones((20, 2))),
        Failure(sketch=sketch, expected={**sketch, "arrows": []}),
    ]
    *pairs, diagrams = [wrong_and_right(course, SLUGS[1], "another", failure) for failure in failures]
    assert diagrams.wrong.arrows and diagrams.wrong.unknown and not diagrams.reference.arrows
    for pair in [seen, *pairs]:
        pictures = [base64.b64decode(text.partition(",")[2]) for text in (pair.wrong, pair.reference)]
        wrong, correct = (Image.open(io.BytesIO(picture)) for picture in pictures)
        assert wrong.size == correct.size and wrong.tobytes() != correct.tobytes()
    nothing = None, Failure(actual="a"), Failure(actual=[1.0], expected=[np.nan]), Failure(actual=[1], expected=[1, 2])
    assert not any(wrong_and_right(course, SLUGS[1], "another", failure) for failure in nothing)


def sharer(student, actual, *, cause=None, near_miss=False, checks=("skew_is_the_cross_product",)):
    failure = Failure(quantity="skew(v)", error=1.0, limit=1e-12, near_miss=near_miss, actual=actual)
    return result(student, *(check_result(name, suspect=cause, failure=failure) for name in checks))


def sharers(*results):
    signs = {(each.student, each.assignment): [*signs_of(each)] for each in results}  # the newest result counts
    return [(group.students, group.checks) for group in groups(signs)]


def test_two_with_the_same_numbers_are_named():
    observed = sharers(sharer("ann", ODD), sharer("ben", ODD * (1 + 1e-14)), sharer("cas", ODD * (1 + 1e-10)))
    assert observed == [(("ann", "ben"), ("skew_is_the_cross_product",))]


def test_the_newest_result_counts_and_checks_of_one_group_stand_together():
    both = [sharer(student, ODD, checks=("x", "y")) for student in "ab"]
    assert sharers(*both) == [(("a", "b"), ("x", "y"))]
    assert sharers(*both, sharer("b", ODD * 2)) == []


COMMON = [np.zeros(3), np.full(3, np.nan), np.array([1.0, -0.5, 3.25]), np.array([np.pi / 4]), None, "text"]
COMMON += [np.array([-2 * np.pi / 3, np.sqrt(2) / 2, 0.0])]
SHARED = [*((actual, {}) for actual in COMMON), (ODD, {"cause": "The sign is wrong."}), (ODD, {"near_miss": True})]


@pytest.mark.parametrize(("actual", "more"), SHARED)
def test_what_anybody_may_come_by_is_not_told(actual, more):
    assert sharers(sharer("ann", actual, **more), sharer("ben", actual, **more)) == []


def test_the_command_writes_the_page_beside_the_feedback_and_names_them(tmp_path, solution_text, capsys):
    odd = "\n\ndef skew(v):\n    return np.outer(v, v) * 1.2345 + 0.1 * np.eye(3)\n"
    texts = {"ann": odd, "ben": odd.replace("v", "w"), "cas": "", "dan": odd.replace("0.1", "0.2")}
    hand_in(tmp_path / "submitted", {student: solution_text(HW08) + text for student, text in texts.items()})
    assert cli.main(["grade", str(tmp_path / "submitted"), "--out", str(tmp_path / "out"), "--seed", "1"]) == 0
    assert cli.main(["report", str(tmp_path / "out")]) == 0
    assert capsys.readouterr().out.splitlines()[-1] == str(tmp_path / "out" / "report.html")
    page = (tmp_path / "out" / "report.html").read_text()
    links = re.findall(r'href="([^"#]+)"', page)
    assert links and all((tmp_path / "out" / link).is_file() for link in links)
    assert "The same wrong result" in page and "ann, ben" in page and "ben, dan" not in page
