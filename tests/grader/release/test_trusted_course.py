"""Which course a command uses: named, trusted or installed, never one that a student handed in."""

import shutil

import pytest

from tam570_grader import cli

SLUG = "hw08_axis_angle"
EVIL = "from pathlib import Path\n\nPath({!r}).touch()\n"


@pytest.fixture
def submission(tmp_path, monkeypatch, solution_text, course):
    """A student's folder with work, a course.toml, a checkout's folders, and checks that leave a trace when run."""
    monkeypatch.setenv("TAM570_HOME", str(tmp_path / "home"))
    monkeypatch.delenv("TAM570_COURSE", raising=False)
    folder = tmp_path / "submitted" / "ann" / SLUG
    shutil.copytree(course / "autograder" / "checks" / SLUG, folder / "autograder" / "checks" / SLUG)
    (folder / "solutions").mkdir()
    (folder / f"{SLUG}.py").write_text(solution_text(SLUG))
    (folder / "solutions" / f"{SLUG}.py").write_text(solution_text(SLUG))
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


@pytest.mark.parametrize(
    "command",
    [["kit", "kit"], ["stubs"], ["audit", "hw08"], ["grade", f"{SLUG}.py"], ["report", "."], ["course", "nb"]],
)
def test_an_untrusted_course_stops_the_command(submission, tmp_path, capfd, command):
    assert cli.main(command) == 2
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
