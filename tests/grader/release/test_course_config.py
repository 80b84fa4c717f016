"""Every command uses the course of a trusted course.toml, and none uses a course that a student handed in."""

import json
import re
import shutil
import zipfile

import pytest
from classes import HW08 as SLUG
from classes import hand_in, results
from parameters import first

from tam570_grader import cli
from tam570_grader.checks import assignments
from tam570_grader.course import course_config, late_policy

COURSE = """
assignments = ["hw07", "hw08"]

[limits]
call = 5

[hw08]
leave_out = []
allow = ["tam570.rotations"]
checks = "mine.py"

[hw08.points]
skew_is_the_cross_product = 3
matrix_depends_on_the_direction_alone = 0

[hw07]
leave_out = ["c"]
"""
MINE = '''
"""A check of my own."""
from tam570_grader import Case, check, expect


@check("rotate", points=2, part="b", line="turning back undoes it.")
def turning_back_undoes(student, rng):
    r, axis = rng.normal(size=3), rng.normal(size=3)
    ((_, there),) = student.rotate.each([Case(r, axis, 0.7)])
    ((_, back),) = student.rotate.each([Case(there, axis, -0.7)])
    expect(back, r, tolerance=1e-12, quantity="the vector", unit="m")
'''
HALF = "\n\ndef rotate(r, axis, angle):\n    return np.asarray(r, float)\n"
EVIL = "from pathlib import Path\n\nPath({!r}).touch()\n"


@pytest.fixture
def desk(here, solution_text):
    """Return a folder with course.toml, ann's correct work, and ben's work, in which `rotate` does not rotate."""
    (here / "course.toml").write_text(COURSE)
    assert cli.main(["trust"]) == 0
    (here / "mine.py").write_text(MINE)
    hand_in(here / "submitted", {"ann": solution_text(SLUG), "ben": solution_text(SLUG) + HALF})
    return here


def run(*arguments):
    return cli.main([*map(str, arguments)])


def test_grading_obeys_and_a_check_of_ones_own_is_one(desk):
    assert run("grade", "submitted", "--out", "results", "--seed", "1") == 0
    lines = results(desk / "results")
    ann, ben = ({check["name"]: check for check in line["checks"]} for line in lines)
    assert lines[0]["score"] == lines[0]["max_score"] == 10 + 2 - 1 + 2
    assert ann["skew_is_the_cross_product"]["points"] == 3 and "matrix_depends_on_the_direction_alone" not in ann
    assert (ann["turning_back_undoes"]["outcome"], ben["turning_back_undoes"]["outcome"]) == ("passed", "passed")
    assert ben["vector_turns_by_the_right_hand_rule"]["points"] == 0


def waits(root):
    """Return {check of hw08: the checks that it waits for}."""
    return {item.name: [other.name for other in item.after] for item in assignments.assignment(root, SLUG).checks}


def test_checks_wait_for_the_same_checks_and_not_for_one_left_out(desk, course):
    before, left_out = waits(course), "vector_turns_by_the_right_hand_rule"
    here = waits(course_config.course_of())
    assert here["vector_turns_by_every_angle"] == [left_out]
    assert {name: after for name, after in before.items() if name in here}.items() <= here.items()
    (desk / "course.toml").write_text(COURSE.replace("matrix_depends_on_the_direction_alone", left_out))
    assert waits(course_config.course_of())["vector_turns_by_every_angle"] == []


def test_students_get_the_points_and_these_assignments_alone(desk):
    assert run("kit", "kit") == run("course", "nb") == run("gradescope", "archives") == 0
    page = (desk / "kit" / "README.md").read_text()
    assert "- hw07: " in page and "- hw08: " in page and "hw09" not in page
    (wheel,) = (desk / "kit").glob("*.whl")
    with zipfile.ZipFile(wheel) as archive:
        names = archive.namelist()
        readme = archive.read(f"tam570/assignments/{SLUG}/README.md").decode()
        contract = json.loads(archive.read(f"tam570/assignments/{SLUG}/contract.json"))
    held = {name.split("/")[2] for name in names if name.startswith("tam570/assignments/hw")}
    assert held == {"hw07_double_pendulum", SLUG} and not any("/checks/" in name for name in names)
    assert re.search(r"^\| `skew\(v\)` \| 3 \|", readme, re.M)
    assert re.search(r"^\| `rotation_matrix\(.* \| 4 \|", readme, re.M)
    assert "The autograder gives 13 points" in readme and "One call may take 5 s" in readme
    assert "you may use `tam570.rotations`" in readme and "tam570.rotations" not in contract["off_limits"]["*"]
    assert sorted(path.name for path in (desk / "nb" / "source").iterdir()) == ["hw07_double_pendulum", SLUG]
    with zipfile.ZipFile(desk / "archives" / f"{SLUG}.zip") as archive:
        assert {f"course/autograder/checks/{SLUG}/own.py", "course/made-by-course.toml"} <= {*archive.namelist()}
    notebook = (desk / "nb" / "source" / "hw07_double_pendulum" / "hw07_double_pendulum.ipynb").read_text()
    assert "manual-" not in notebook


WRONG = [
    ('"hw08"', '"hw99"', "'hw99'"),
    ("skew_is_the_cross", "skew_is_a_cross", "do you mean skew_is_the_cross_product?"),
    ("call = 5", "calls = 5", "calls is not known; do you mean call?"),
    ('["c"]', '["q"]', "q is not known"),
    ("assignments = [", 'hw09 = 1\nassignments = ["hw09", ', "hw09 must be a table: write [hw09]"),
    ("= 3", "= -3", "is -3"),
    ("mine.py", "yours.py", "no such file"),
    ('"hw07", ', "", "[hw07] is not among the assignments"),
    ('allow = ["tam570.rotations"]', 'allow = ["os"]', "os is not known"),
]


@pytest.mark.parametrize(("old", "new", "words"), WRONG)
def test_what_disagrees_is_named_and_nothing_is_done(desk, capsys, old, new, words):
    assert old in COURSE
    (desk / "course.toml").write_text(COURSE.replace(old, new, 1))
    assert run("grade", "submitted", "--out", "results") == 2
    assert words in (err := capsys.readouterr().err) and "course.toml" in err
    assert not (desk / "results").exists() and not [*desk.glob(".course*")]


@pytest.mark.parametrize("where", first(1, ["docs", "."]))
def test_in_the_root_of_a_checkout_it_is_obeyed_too(desk, course, monkeypatch, where):
    checkout, without_caches = desk / "checkout", shutil.ignore_patterns("__pycache__")
    both = ("hw07_double_pendulum", SLUG)
    parts = [f"{name}/{slug}" for name in ("assignments", "autograder/checks") for slug in both]
    for part in (*parts, "solutions"):
        shutil.copytree(course / part, checkout / part, ignore=without_caches)
    for name in course_config.SHARED:
        (checkout / name).symlink_to(course / name)
    shutil.move(desk / "mine.py", checkout)
    (desk / "course.toml").unlink()
    (checkout / "course.toml").write_text(f"{COURSE}[hw07.extension]\nann = 2\n")
    (checkout / "docs").mkdir()
    monkeypatch.chdir(checkout / where)
    assert run("trust", checkout) == 0
    assert run("grade", desk / "submitted", "--out", desk / "results", "--seed", "1") == 0
    assert '"max_score": 13.0' in (desk / "results" / "results.jsonl").read_text()
    root = course_config.course_of()
    assert root.parent == checkout / ".course" and course_config.course_of(root) == root
    assert course_config.limits(root)["call"] == 5
    assert late_policy.policies_of(root)["hw07_double_pendulum"].extension == {"ann": 2}
    (checkout / "course.toml").write_text("[limits]\ncalls = 5\n")
    assert run("grade", desk / "submitted", "--out", desk / "results") == 2


def test_two_commands_at_once_make_one_course(desk, monkeypatch):
    make, built = course_config._make, []

    def made_by_two(*arguments):
        """Let another command make the same course while this one makes it."""
        monkeypatch.setattr(course_config, "_make", make)
        make(*arguments)
        built.append(course_config.course_of())

    monkeypatch.setattr(course_config, "_make", made_by_two)
    assert [course_config.course_of()] == built and assignments.slugs(built[0]) == ["hw07_double_pendulum", SLUG]
    assert [path.name for path in desk.glob(".course*")] == [".course"]


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        ("tolerance=1e-12", "tolerance=-1.0", "the solution fails it"),
        ("expect(back", "max(back", ""),
        ("expect(back", "(back", "the stub passes it"),
    ],
)
def test_a_check_of_ones_own_is_tried_before_anybody_is_graded(desk, capsys, old, new, words):
    """A check that the solution fails, that raises, or that the stub passes is an error, and nobody is graded."""
    text = MINE.replace(old, new)
    (desk / "mine.py").write_text(text[: text.index("    r, axis")] + "    rng.random()\n" if "stub" in words else text)
    assert run("grade", "submitted", "--out", "results", "--seed", "1") == 2
    assert "turning_back_undoes" in (err := capsys.readouterr().err) and words in err
    assert not (desk / "results" / "results.jsonl").exists()


def test_dates_alone_grade_nobody_anew_and_what_is_left_out_is_gone_from_the_page(desk):
    run("grade", "submitted", "--out", "results", "--seed", "1")
    before = (desk / "results" / "results.jsonl").read_bytes()
    (desk / "course.toml").write_text(COURSE + "due = 2026-09-14T23:59:00\n")
    run("grade", "submitted", "--out", "results")
    assert (desk / "results" / "results.jsonl").read_bytes() == before
    readme = (course_config.course_of() / "assignments" / "hw07_double_pendulum" / "README.md").read_text()
    assert "**(c)**" not in readme and "**(b)**" in readme and "Part (c) is left out" in readme


@pytest.fixture
def submission(tmp_path, monkeypatch, solution_text, course):
    """Return a student's folder with work, course.toml, folders of a checkout, and checks that create a file if run."""
    monkeypatch.setenv("TAM570_HOME", str(tmp_path / "home"))
    monkeypatch.delenv("TAM570_COURSE", raising=False)
    folder = tmp_path / "submitted" / "ann" / SLUG
    shutil.copytree(course / "autograder" / "checks" / SLUG, folder / "autograder" / "checks" / SLUG)
    for file in ("{0}.py", "solutions/{0}.py"):
        hand_in(folder.parent, {SLUG: solution_text(SLUG)}, file=file)
    for path in (folder / "mine.py", folder / "autograder" / "checks" / SLUG / "checks.py"):
        path.write_text(EVIL.format(str(tmp_path / "ran")))
    (folder / "course.toml").write_text('assignments = ["hw08"]\n[hw08]\nchecks = "mine.py"\n')
    monkeypatch.chdir(folder)
    return folder


@pytest.mark.parametrize("command", [["grade", "."], ["alike", "."], ["export", ".", "--for", "moss", "--to", "out"]])
def test_a_course_in_what_is_graded_is_not_used(submission, tmp_path, capfd, command, course):
    assert cli.main(command) == 0
    said = capfd.readouterr().err
    assert f"course: {course} (installed)" in said and "it is not used" in said
    assert not (tmp_path / "ran").exists()


@pytest.mark.parametrize("command", ["kit kit", "stubs", "audit hw08", f"grade {SLUG}.py", "report .", "course nb"])
def test_an_untrusted_course_stops_the_command(submission, tmp_path, capfd, command):
    assert cli.main(command.split()) == 2
    assert "is not trusted" in capfd.readouterr().err
    assert not (tmp_path / "ran").exists() and not (submission / ".course").exists()


@pytest.mark.parametrize("how", ["option", "environment"])
def test_a_course_that_is_named_may_not_lie_in_what_is_graded(submission, tmp_path, monkeypatch, how):
    monkeypatch.setenv("TAM570_COURSE", str(submission) if how == "environment" else "")
    by_name = ["--root", str(submission)] if how == "option" else []
    assert cli.main([*by_name, "grade", str(tmp_path / "submitted")]) == 2
    assert not (tmp_path / "ran").exists()


def test_a_named_course_goes_before_a_trusted_one(submission, tmp_path, monkeypatch, capfd, course):
    desk = tmp_path / "desk"
    desk.mkdir()
    (desk / "course.toml").write_text('assignments = ["hw07"]\n')
    monkeypatch.chdir(desk)
    assert cli.main(["trust"]) == 0 and cli.main(["stubs", "--check"]) == 0
    assert f"course: {desk / 'course.toml'} (trusted)" in capfd.readouterr().err
    assert cli.main(["--root", str(course), "stubs", "--check"]) == 0
    assert f"course: {course} (--root)" in capfd.readouterr().err
    monkeypatch.setenv("TAM570_COURSE", str(course))
    assert cli.main(["stubs", "--check"]) == 0
    assert f"course: {course} (TAM570_COURSE)" in capfd.readouterr().err
