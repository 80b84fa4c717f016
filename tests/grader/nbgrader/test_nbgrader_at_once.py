"""Two autograde commands on one assignment at once: the second waits for the first, and nobody's work is lost."""

import fcntl
import os
import shutil
import signal
import subprocess
import sys
import time

import pytest

pytestmark = pytest.mark.slow  # half a minute of nbgrader
SLUG = "hw08_axis_angle"
STUDENTS = [f"s{number}" for number in range(6)]


@pytest.fixture
def collected(tmp_path, made_course, nbgrader, solution_text):
    """The course with a class's submissions of one assignment."""
    course, _ = made_course(tmp_path, [SLUG])
    nbgrader(course, "generate_assignment", SLUG)
    for number, student in enumerate(STUDENTS):
        folder = course / "submitted" / student / SLUG
        shutil.copytree(course / "release" / SLUG, folder)
        os.chmod(folder / f"{SLUG}.py", 0o644)
        (folder / f"{SLUG}.py").write_text(f"{solution_text(SLUG)}\n# {number}\n")
    return course


def autograde(course, environment):
    command = [sys.executable, "-m", "nbgrader", "autograde", SLUG]
    return subprocess.Popen(command, cwd=course, env=environment, stderr=subprocess.PIPE, text=True)


def is_locked(path):
    """Whether a command is writing results there."""
    if not path.exists():
        return False
    with open(path) as file:
        try:
            fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            return True
    return False


def test_both_end_well_and_every_student_has_a_grade(collected, jupyter_environment, nbgrader_grades):
    both = [autograde(collected, jupyter_environment) for _ in range(2)]
    says = [one.communicate()[1] for one in both]
    assert [one.returncode for one in both] == [0, 0], "\n".join(says)
    assert sum("this one waits for its end" in text for text in says) == 1, "\n".join(says)
    scores = nbgrader_grades(collected)
    assert {student for student, _, _ in scores} == set(STUDENTS)
    assert all(sum(score or 0 for (who, *_), (score, _) in scores.items() if who == one) == 10 for one in STUDENTS)
    assert all((collected / "autograded" / one / SLUG / f"{SLUG}.ipynb").exists() for one in STUDENTS)


def test_ctrl_c_ends_the_one_that_waits_and_leaves_the_other(collected, jupyter_environment, nbgrader_grades):
    first = autograde(collected, jupyter_environment)
    while not is_locked(collected / "tam570_results" / SLUG / "results.jsonl"):
        assert first.poll() is None
        time.sleep(0.01)
    first.send_signal(signal.SIGSTOP)  # so that the second must wait
    second = autograde(collected, jupyter_environment)
    while "waits for its end" not in (line := second.stderr.readline()):
        assert line
    second.send_signal(signal.SIGINT)
    (said,) = second.communicate()[1].splitlines()
    assert second.returncode == 130 and "interrupted" in said and "same command again" in said
    first.send_signal(signal.SIGCONT)
    says = first.communicate()[1]
    assert first.returncode == 0, says
    scores = nbgrader_grades(collected)
    assert all(sum(score or 0 for (who, *_), (score, _) in scores.items() if who == one) == 10 for one in STUDENTS)
