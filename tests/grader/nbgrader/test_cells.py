"""What the marks of a part look like in a notebook."""

import pytest

from tam570_grader.nbgrader.cells import marked
from tam570_grader.reports.feedback import load_assignment_info

ONE = "hw08_axis_angle"


@pytest.mark.parametrize("spoiled", ["", "\n\ndef skew(v): return np.eye(3)\n"])
def test_a_cell_ends_with_its_points_and_says_what_failed(spoiled, grade, solution_text, course):
    record = grade(ONE, solution_text(ONE) + spoiled).record()
    shown, points = marked(record["checks"], load_assignment_info(course, ONE), "A note.")
    assert float(points["data"]["text/plain"]) == record["score"]
    page, plain = shown["data"]["text/html"], shown["data"]["text/plain"]
    failed = [check["message"] for check in record["checks"] if check["outcome"] == "failed"]
    assert bool(failed) == bool(spoiled) and page.count("<br>failed: ") == len(failed)
    assert "A note." in page and all(message in plain for message in failed)
