"""A student's free body diagrams on a scene: arrows where they act, of one length, whatever their number."""

from types import SimpleNamespace

import numpy as np
import pytest

from tam570.show.diagrams import force_shapes
from tam570.show.student import Student, Trouble


def shapes(diagram):
    student = Student(SimpleNamespace(free_body_diagram=diagram))
    return force_shapes(student, [0.0, 1.0, 2.0], length=0.5, color=1, label="forces")


def test_arrows_are_where_they_act_and_along_their_direction():
    pull, hinge = shapes(lambda x: [((x, 0), (0, -9.81)), ((x, 1), None)])
    np.testing.assert_allclose(pull.points[2], [(2, 0), (2, -0.5)])
    assert (pull.kind, hinge.kind) == ("arrow", "dot")
    np.testing.assert_allclose(hinge.points[:, 0], [(0, 1), (1, 1), (2, 1)])


def test_a_force_that_is_left_out_for_a_while_has_no_length_then():
    first, second = shapes(lambda x: [((x, 0), (0, -1)), *([((x, 0), (3, 0))] if x else [])])
    np.testing.assert_allclose(np.linalg.norm(np.diff(first.points, axis=1)[:, 0], axis=1), 0.5)
    np.testing.assert_allclose(np.linalg.norm(np.diff(second.points, axis=1)[:, 0], axis=1), [0, 0.5, 0.5])


@pytest.mark.parametrize("drawn", [None, 3, [1, 2], [((0, 0), "up")], [((0, 0, 0), None)], [((0, np.nan), None)]])
def test_what_is_no_diagram_is_said(drawn):
    with pytest.raises(Trouble, match="free_body_diagram gives"):
        shapes(lambda x: drawn)
