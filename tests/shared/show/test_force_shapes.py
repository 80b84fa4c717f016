"""A student's free body diagrams on a scene: arrows where they act, of one length, whatever their number."""

from types import SimpleNamespace

import numpy as np
import pytest
from parameters import first

from tam570.course import assignments, contract
from tam570.show.diagrams import NAME, force_shapes
from tam570.show.student import Student

DRAWN = [slug for slug in assignments() if NAME in contract(slug)["results"]]


def shapes(diagram, **how):
    return force_shapes(student_with(diagram), [0.0, 1.0, 2.0], size=0.5, **how)


def student_with(diagram):
    return Student(SimpleNamespace(free_body_diagram=diagram), {NAME: {"diagram": 2}})


def test_arrows_are_where_they_act_and_along_their_direction():
    pull, hinge = shapes(lambda x: [((x, 0), (0, -9.81)), ((x, 1), None)])
    np.testing.assert_allclose(pull.points[2], [(2, 0), (2, -0.5)])
    assert (pull.form, hinge.form) == ("arrow", "dot")
    np.testing.assert_allclose(hinge.points[:, 0], [(0, 1), (1, 1), (2, 1)])


def test_a_force_that_is_left_out_for_a_while_has_no_length_then():
    first, second = shapes(lambda x: [((x, 0), (0, -1)), *([((x, 0), (3, 0))] if x else [])])
    np.testing.assert_allclose(np.linalg.norm(np.diff(first.points, axis=1)[:, 0], axis=1), 0.5)
    np.testing.assert_allclose(np.linalg.norm(np.diff(second.points, axis=1)[:, 0], axis=1), [0, 0.5, 0.5])


def test_a_diagram_in_axes_of_its_own_is_moved_and_turned():
    axes = np.array([[0.6, -0.8], [0.8, 0.6]])  # down a ramp, off it
    (pull,) = shapes(lambda x: [((0, -1), (2, 0))], origin=[(k, 0.0) for k in range(3)], axes=axes)
    np.testing.assert_allclose(pull.points[2], [(2 - 0.8, -0.6), (2 - 0.8 + 0.3, -0.6 - 0.4)])


@pytest.mark.parametrize("slug", first(3, DRAWN))
def test_every_scene_draws_the_diagram(scenes, slug):
    """The weight is vertical, and acts on what moves."""
    scene = scenes(slug)
    forces = [shape for shape in scene.panels[0].shapes if shape.form == "arrow" and shape.name.startswith("forces o")]
    assert not scene.notes and forces
    if slug[:4] != "hw06":  # which is seen from above
        weight = np.diff(forces[0].points, axis=1)[:, 0]
        assert (weight[:, -1] < 0).all() and np.abs(weight[:, :-1]).max() < 1e-12


@pytest.mark.parametrize("drawn", [None, 3, [1, 2], [((0, 0), "up")], [((0, 0, 1), None)], [((0, np.nan), None)]])
def test_what_is_no_diagram_is_said(drawn):
    student = student_with(lambda x: drawn)
    assert force_shapes(student, [0.0], size=0.5) == [] and student.notes[0].startswith("free_body_diagram ")
