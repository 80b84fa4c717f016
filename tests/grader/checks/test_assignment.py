"""A typo in the record ASSIGNMENT of a module of checks, or in a check, raises an error."""

import shutil

import pytest
from classes import HW08 as SLUG

from tam570_grader.checks import assignments
from tam570_grader.errors import UsageError


@pytest.mark.parametrize(
    ("old", "new", "error"),
    [
        ("forbidden=", "forbiden=", TypeError),
        ("needs=", "FORBIDDEN={}, needs=", TypeError),
        ("needs=", "need=", TypeError),
        ('"rotate": ("rotation_matrix",)', '"rotat": ("rotation_matrix",)', ValueError),
        ('"rotate": ("rotation_matrix",)', '"rotate": ("rotation_matrix")', ValueError),
        ('@check("skew"', '@check("skow"', UsageError),
        ("ASSIGNMENT =", "ASSIGMENT =", UsageError),
    ],
)
def test_a_typo_in_the_record_is_an_error(tmp_path, course, old, new, error):
    for name in (f"assignments/{SLUG}", f"autograder/checks/{SLUG}"):
        shutil.copytree(course / name, tmp_path / name, ignore=shutil.ignore_patterns("mistakes*", "__pycache__"))
    file = tmp_path / "autograder" / "checks" / SLUG / "checks.py"
    text = file.read_text()
    assert old in text
    file.write_text(text.replace(old, new))
    with pytest.raises(error):
        assignments.assignment(tmp_path, SLUG)
    assignments.assignment.cache_clear()
