"""What a teacher grades by hand: claims with points beside the README, in it, and in the notebook."""

import json

import pytest

from tam570_grader.checks.rubric import load_rubric, rubric_table
from tam570_grader.release.notebook import problem, write_notebook


@pytest.fixture
def released(course, slug):
    return course / "assignments" / slug


def test_every_claim_has_points_and_every_part_is_one_of_the_problem(released):
    rubric = load_rubric(released)
    assert {*rubric} <= {*problem((released / "README.md").read_text()).parts} | {"a"}
    for part in rubric.values():
        assert len({text for _, text in part.claims}) == len(part.claims) >= 2
        assert all(points > 0 for points, _ in part.claims)


def test_a_notebook_asks_for_the_prediction_above_the_picture_and_shows_the_claims(course, slug, released, tmp_path):
    write_notebook(course, slug, tmp_path)
    cells = {cell["id"]: cell for cell in json.loads((tmp_path / f"{slug}.ipynb").read_text())["cells"]}
    order = list(cells)
    for letter, part in load_rubric(released).items():
        assert rubric_table(part) in cells[f"task-{letter}"]["source"]
        assert cells[f"manual-{letter}"]["metadata"]["nbgrader"]["points"] == part.points
        if part.before:
            assert order.index(f"guess-{letter}") < order.index(f"picture-{letter}") < order.index(f"manual-{letter}")
