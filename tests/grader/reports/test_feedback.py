"""The students' pages say what is wrong, with numbers as people write them, and reveal no hidden input."""

import contextlib
import html
import json
import math
import re
import runpy
from dataclasses import replace

import numpy as np
import pytest
from classes import check_result, hand_in, result
from parameters import SLUGS, first

from tam570_grader import cli
from tam570_grader.checks import assignments
from tam570_grader.checks.curves import BITS, CEILING, FLOOR, SLOTS, curve
from tam570_grader.checks.failure import WHOLE, Failure
from tam570_grader.checks.rubric import ManualPart
from tam570_grader.diagnosis.mistakes import overlays
from tam570_grader.reports import feedback
from tam570_grader.reports.pictures import BOTTOM, LAST, LEFT, TOP, among, picture
from tam570_grader.reports.sentences import describe_failure, points, quantity, typeset
from tam570_grader.results.records import numbers, read
from tam570_grader.results.run_time import scenes
from tam570_grader.results.store import ResultStore, key_of

CHECKS = assignments.find() / "autograder" / "checks"
NUMBER = re.compile(r"-?\d+\.\d{3,}(?:e[-+]?\d+)?")  # numbers with more digits than messages have


@pytest.fixture(scope="module")
def page(course):
    """`page(result)` -> the HTML of the student's page."""
    return lambda result: feedback.page(read(result.record()), feedback.load_assignment_info(course, result.assignment))


def wrong(slug, name, grade, solution_text):
    return grade(slug, solution_text(slug) + "\n\n" + overlays(CHECKS / slug)[name], seed=1)


def texts(page):
    return html.unescape(re.sub(r"<style>.*?</style>", "", page, flags=re.DOTALL))


@pytest.mark.parametrize("slug", first(1, SLUGS))
def test_a_page_says_every_line_message_and_suspect_and_no_detail(slug, page, grade, solution_text, course):
    lines = feedback.load_assignment_info(course, slug).lines
    shown = 0
    for name in list(overlays(CHECKS / slug))[:3]:
        result = wrong(slug, name, grade, solution_text)
        text = texts(page(result))
        for check in result.checks:
            message = describe_failure(check.failure) if check.failure else check.message
            read = [lines[check.name], check.suspect or "", message if check.outcome != "passed" else ""]
            assert all(typeset(item) in text for item in read)
            hidden = set(NUMBER.findall(json.dumps({key: numbers(getattr(check.failure, key, None)) for key in WHOLE})))
            reported = "".join([*lines.values(), *(item.message for item in result.checks)])
            assert not {number for number in hidden if number in text and number not in reported}
            shown += len(hidden)
    assert shown, "there was something to hide"


def test_what_a_student_calls_things_is_text_and_no_markup(page, grade):
    evil = "<script>alert(1)</script><img src=x onerror=alert(2)>\"'&</style>{{ 7 * 7 }}{% include '/etc/passwd' %}"
    result = grade("hw08_axis_angle", f"raise ValueError({evil!r})")
    built = feedback.page(
        replace(result, student=evil), feedback.AssignmentInfo(evil, {}, {}, {"a": ManualPart(evil, ((1.0, evil),))})
    )
    assert "<script" not in built and "<img" not in built
    assert texts(built).count("<script>alert(1)</script>") >= 3 and texts(built).count("{{ 7 * 7 }}{% include") >= 3
    assert "default-src 'none'" in built


@pytest.mark.parametrize(
    ("slug", "mistake", "is_kept"),
    first(
        1,
        [
            ("hw01_simple_pendulum", "upside_down", False),
            ("hw05_constrained_pendulum", "gravity_up", False),
            ("hw05_constrained_pendulum", "simulate_2", True),
            ("hw07_double_pendulum", "sign_of_the_sine_term", False),
            ("hw07_double_pendulum", "simulate", True),
        ],
    ),
)
def test_beside_a_wrong_motion_is_what_becomes_of_the_energy_along_it(
    slug, mistake, is_kept, grade, solution_text, page
):
    """A mistake in the forces changes the energy; one in the times alone does not."""
    result = wrong(slug, mistake, grade, solution_text)
    drawn = [check.failure.curve for check in result.checks if check.failure and check.failure.curve]
    curves = [curve["keeps"] for curve in drawn if curve.get("keeps")]
    assert curves
    largest = max(abs(value) for item in curves for value in item["values"] if value is not None)
    assert (largest <= curves[0]["tolerance"]) == is_kept
    document = page(result)
    assert document.count("<figure") == len(curves) + len(drawn)
    assert not re.search(r"(?:src|href)=\"(?!#)|url\(|@import|<script", document), "it needs another file"


def test_the_curve_of_an_error_tells_when_it_grows_and_passes_the_limit():
    t = np.linspace(2.0, 12.0, 501)
    error = 1e-8 * np.exp(2 * (t - 2))
    actual, expected = np.column_stack([t, t + error]), np.column_stack([t, t])
    observed = curve(t, actual, expected, 1.0, tolerance=1e-4, quantity="x", unit="m")
    levels = np.array(observed["values"])
    assert observed["scale"] == "log" and "span" not in observed
    rising = levels[(levels > FLOOR) & (levels < CEILING)]
    slope = np.polyfit(np.arange(len(rising)) * 10 / SLOTS, rising, 1)[0]
    assert slope == pytest.approx(2 / math.log(10), rel=0.1)
    assert "passes the limit in the second quarter" in picture(observed).alt_text  # at ln(1e4)/2 = 4.6 s of 10


def test_a_curve_says_too_little_to_carry_an_input_out():
    """The values that all slots of a curve can have are no more bits than the page on trust says."""
    rng = np.random.default_rng(3)
    t = np.cumsum(rng.uniform(0.1, 1.0, 1000))
    fields = {"tolerance": 1e-5, "quantity": "x", "unit": ""}
    levels, drifts = set(), set()
    for _ in range(50):
        errors = curve(t, 10 ** rng.uniform(-9, 3, (1000, 2)), np.zeros((1000, 2)), 1.0, **fields)
        drift = curve(t, rng.uniform(-1, 1, 1000) ** 3, np.zeros(1000), 1.0, **fields)
        levels |= {*errors["values"], None}
        largest = max(map(abs, filter(None, drift["values"])))
        drifts |= {value and round(value / largest, 6) for value in drift["values"]}
    assert len(errors["values"]) == len(drift["values"]) == SLOTS
    assert SLOTS * math.log2(max(len(levels), len(drifts))) <= BITS <= 80


@pytest.fixture
def written(tmp_path, course, monkeypatch):
    """`written(*records)` -> the keys of the pages that were written for these results, without unchanged pages."""
    built, page = [], feedback.page

    def noted(result, info, adjusted):
        built.append(key_of(result.record()))
        return page(result, info, adjusted)

    monkeypatch.setattr(feedback, "page", noted)

    def written(*records):
        built.clear()
        with contextlib.closing(ResultStore(tmp_path)) as book:
            for record in records:
                book.add(record)
            feedback.write_pages(tmp_path / "feedback", book, course)
        return [*built]

    return written


def test_a_page_that_fails_is_that_students_alone(tmp_path, grade, course, solution_text, written, monkeypatch):
    slug = "hw08_axis_angle"
    item = grade(slug, solution_text(slug)).record()
    page = feedback.page
    monkeypatch.setattr(feedback, "page", lambda item, *more: 1 / 0 if item.student == "ada" else page(item, *more))
    (tmp_path / "feedback" / "ben").mkdir(parents=True)
    elsewhere = tmp_path / "elsewhere"
    elsewhere.write_text("kept")
    (tmp_path / "feedback" / "ben" / f"{slug}.html").symlink_to(elsewhere)
    with contextlib.closing(ResultStore(tmp_path)) as book:
        for student in ("ada", "ben"):
            book.add({**item, "student": student})
        assert feedback.write_pages(tmp_path / "feedback", book, course) == [("ada", slug)]
    pages = {student: tmp_path / "feedback" / student / f"{slug}.html" for student in ("ada", "ben")}
    assert "could not write this page" in pages["ada"].read_text() and "10 of 10" in pages["ben"].read_text()
    assert elsewhere.read_text() == "kept" and not pages["ben"].is_symlink()


def test_only_pages_of_results_that_changed_are_made_again(tmp_path, grade, course, solution_text, written):
    slug = "hw08_axis_angle"
    item = grade(slug, solution_text(slug)).record()
    both = [{**item, "student": student} for student in ("ada", "ben")]
    assert written(*both) == [("ada", slug), ("ben", slug)]
    paths = sorted((tmp_path / "feedback").rglob("*"))
    assert [path.name for path in paths] == ["ada", f"{slug}.html", "ben", f"{slug}.html"]
    assert written(*both) == []
    assert written({**both[1], "score": 3.0}) == [("ben", slug)] and "3 of 10" in paths[3].read_text()
    paths[1].unlink()
    assert written() == [("ada", slug)] and paths[1].exists()


@pytest.mark.parametrize(
    ("value", "message"),
    [
        *((2.7, "2.7"), (200.0, "200"), (1234.0, "1200"), (0.0312, "0.031"), (6e-4, "6e-4"), (1.13e-13, "1.1e-13")),
        *((9.99e-5, "1e-4"), (23456.0, "2.3e4"), (0.0, "0"), (np.inf, "more than any number")),
    ],
)
def test_numbers_are_as_people_write_them(value, message):
    assert quantity(value) == message


@pytest.mark.parametrize(
    ("earned", "most", "message"),
    [
        *((9.7675, 10.0, "9.77"), (0.125, 0.25, "0.13"), (9.9975, 10.0, "9.99"), (10.0, 10.0, "10")),
        *((0.1 + 0.2, 0.3, "0.3"), (0.3, 0.1 + 0.2, "0.3"), (0.0, 10.0, "0"), (12.0, 10.0, "12"), (None, 10.0, "?")),
    ],
)
def test_points_have_two_decimals_and_all_are_shown_for_nothing_less(earned, most, message):
    assert points(earned, most) == message


@pytest.mark.parametrize("error", np.random.default_rng(1).lognormal(-5, 9, 50))
def test_no_error_reads_as_its_limit_or_less(error):
    for limit in error / (1 + 10.0 ** -np.arange(1, 9)):
        sentence = describe_failure(Failure(quantity="x", error=error, limit=limit))
        shown, allowed = sentence.split(" is wrong by ")[1].split(" (limit ")
        assert float(shown) > float(allowed.rstrip(").")), (error, limit)


def shown(*checks, info=None, score=9.7675):
    """Return the text of the page of a result with these checks."""
    page = feedback.page(result("ada", *checks, score=score), info or feedback.AssignmentInfo("", {}, {}, {}))
    return re.sub(r"<[^>]+>", "", html.unescape(page))


def test_the_hint_is_for_the_function_that_failed_not_for_the_first_in_the_line():
    info = feedback.AssignmentInfo("", {}, dict.fromkeys(["one", "two", "three"], "skew"), {})
    failed = check_result("one", failure=Failure(message="rotate did not return", function="rotate"))
    missing = check_result("two", "not_run", unwritten="rotation_matrix")
    page = shown(failed, missing, check_result("three"), info=info)
    assert re.findall(r"tam570 hint hw08 (\w+)", page) == ["rotate", "rotation_matrix", "skew"]


def test_where_nothing_failed_the_first_thing_to_look_at_is_what_is_not_written():
    passed, blocked = check_result("one", "passed", points=1.0), check_result("two", "not_run", message="Not run")
    missing, failed = check_result("three", "not_run", unwritten="skew"), check_result("four")
    assert "Look at this first: three" in shown(passed, blocked, missing)
    assert "Look at this first: four" in shown(passed, blocked, missing, failed)
    assert "Look at this first" not in shown(passed, blocked)


SLUG = "hw07_double_pendulum"
SPEED = {"function": "simulate", "scene": "double pendulum", "seconds": 0.1, "error": 1e-6, "machine": 0.5}


def test_what_the_pages_know_of_run_times_is_made_from_the_benchmark(course):
    path = course / "benchmarks" / "run_time_for_pages.py"
    program = runpy.run_path(str(path))
    stored = json.loads(program["PLACE"].read_text())
    assert json.loads(json.dumps(program["shared"]())) == stored, f"run: python {path.relative_to(course)}"
    assert set(stored) <= set(assignments.slugs(course)) and len(stored) > 4


@pytest.mark.parametrize("what", ["return t", "raise NotImplementedError", "import os; os._exit(0)"])
def test_a_simulation_that_is_none_has_no_point(grade, solution_text, what):
    text = solution_text(SLUG) + f"\n\ndef simulate(t, *args, **kwargs):\n    {what}\n"
    assert grade(SLUG, text, 1, speed=True).speed is None


@pytest.mark.parametrize(("seconds", "error"), [(1e-4, 1e-15), (0.1, 1e-6), (30.0, 9e-3)])
@pytest.mark.parametrize("slug", scenes())
def test_the_point_is_in_the_frame_where_its_numbers_say(slug, seconds, error):
    drawn = among(slug, {**SPEED, "seconds": seconds, "error": error})
    x, y = drawn.point
    assert LEFT <= x <= LAST and TOP <= y <= BOTTOM
    for position, ticks, value in ((x, drawn.x, error), (y, drawn.y, seconds)):
        places, decades = zip(*[(at, float(text[2:])) for at, text in ticks], strict=True)
        assert np.polyval(np.polyfit(places, decades, 1), position) == pytest.approx(np.log10(value), abs=0.05)


def test_it_is_measured_when_asked_for_and_stands_on_the_page(tmp_path, solution_text, capsys):
    hand_in(tmp_path / "in", {"ada": solution_text(SLUG)}, SLUG)
    pages, actual = [], []
    for options in ([], ["--speed"]):
        command = ["grade", str(tmp_path / "in"), "--out", str(tmp_path / "out"), "--seed", "1", "--json", *options]
        assert cli.main(command) == 0
        actual.append(json.loads(capsys.readouterr().out))
        pages.append((tmp_path / "out" / "feedback" / "ada" / f"{SLUG}.html").read_text())
    assert ["speed" in line for line in actual] == [False, True]
    assert ["Run time against error" in page for page in pages] == [False, True]
