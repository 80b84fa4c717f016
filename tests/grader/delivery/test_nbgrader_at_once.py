"""Two autograde commands on one assignment at once: the second waits for the first, and nobody's work is lost."""

import os
import shutil
import subprocess
import sys

import pytest

pytestmark = pytest.mark.every  # half a minute of nbgrader
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


def test_both_end_well_and_every_student_has_a_grade(collected, jupyter_environment, nbgrader_grades):
    command = [sys.executable, "-m", "nbgrader", "autograde", SLUG]
    both = [
        subprocess.Popen(command, cwd=collected, env=jupyter_environment, stderr=subprocess.PIPE, text=True)
        for _ in range(2)
    ]
    says = [one.communicate()[1] for one in both]
    assert [one.returncode for one in both] == [0, 0], "\n".join(says)
    assert sum("this one waits for its end" in text for text in says) == 1, "\n".join(says)
    scores = nbgrader_grades(collected)
    assert {student for student, _, _ in scores} == set(STUDENTS)
    assert all(sum(score or 0 for (who, *_), (score, _) in scores.items() if who == one) == 10 for one in STUDENTS)
    assert all((collected / "autograded" / one / SLUG / f"{SLUG}.ipynb").exists() for one in STUDENTS)
