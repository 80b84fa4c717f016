"""Laws of all scenes: nothing jumps, bodies do not overlap, pages are small, and forces act at the right points."""

import re
from itertools import combinations
from types import SimpleNamespace

import numpy as np
import pytest
from parameters import first

from tam570.course import assignments, contract
from tam570.lectures import names
from tam570.show.diagrams import NAME, force_shapes
from tam570.show.page import page
from tam570.show.student import StudentModule

STEP, QUICKER = 0.02, 4.0  # a jump is longer than STEP panel sizes and QUICKER times the steps before and after it
JUMPS = {  # (scene, form of a shape): why it jumps in the physics
    ("planet", "fill"): "the area since the last impulse begins anew",
    ("rocket", "lines"): "the flame goes out",
    ("chains", "arrow"): "the whole chain lies on the scale",
    ("stopping_car", "arrow"): "friction and its moment end with the motion",
    ("hw06_braking", "arrow"): "friction ends with the motion",
}
DEPTH = 1e-3  # depth of a touch, as a fraction of the panel's size: half a pixel
LARGEST = 250_000  # bytes of a page


@pytest.fixture(params=[*assignments(), *names()])
def scene(request, scenes):
    return scenes(request.param)


def test_its_laws_hold_on_a_small_page_that_needs_nothing_else(scene):
    for film in scene.slider.scenes if scene.slider else [scene]:
        assert not film.notes and not any(time_plot.alarm for time_plot in film.time_plots)
    document = page(scene)
    assert len(scene.alt_text) > 60 and len(document.encode()) < LARGEST
    assert not re.search(r"https?://|\bsrc=|\bhref=|@import|url\(", document)
    assert ("azimuth" in document) == scene.in_space


def size(panel):
    rows = np.concatenate([shape.points.reshape(-1, shape.points.shape[-1]) for shape in panel.shapes])
    return float(np.ptp(rows, axis=0).max())


def jumps(shape, largest):
    """Return [frame, point] wherever a point of a moving shape goes much farther than just before and after."""
    if shape.points.ndim == 2:
        return []
    steps = np.linalg.norm(np.diff(shape.points, axis=0), axis=2)
    around = np.maximum(np.pad(steps, [(1, 0), (0, 0)])[:-1], np.pad(steps, [(0, 1), (0, 0)])[1:])
    return np.argwhere((steps > STEP * largest) & (steps > QUICKER * around)).tolist()


def test_nothing_jumps(scene, request):
    name = request.node.callspec.params["scene"]
    for film in scene.slider.scenes if scene.slider else [scene]:
        for panel in film.panels:
            for shape in panel.shapes:
                if (name, shape.form) not in JUMPS:
                    assert not jumps(shape, size(panel)), (panel.title, shape.form, shape.name)


def test_no_body_is_where_another_is(scene):
    for panel in scene.panels:
        bodies = [shape for shape in panel.shapes if shape.form == "fill" and shape.points.shape[-1] == 2]
        for body, other in combinations(bodies, 2):
            frames = range(0, len(scene.times), 5)
            a, b = (np.broadcast_to(s.points, (len(scene.times), *s.points.shape[-2:])) for s in (body, other))
            assert max(overlap(a[i], b[i]) for i in frames) < DEPTH * size(panel), (panel.title, body.name, other.name)


def overlap(body, other):
    """Return the depth to which two convex polygons overlap: the least overlap along the normals of their sides."""
    deepest = np.inf
    for polygon in (body, other):
        sides = np.roll(polygon, -1, axis=0) - polygon
        lengths = np.linalg.norm(sides, axis=1)
        for x, y in [*np.eye(2), *(sides[lengths > 0] / lengths[lengths > 0][:, None])]:
            along = [points @ [-y, x] for points in (body, other)]
            deepest = min(deepest, min(along[0].max() - along[1].min(), along[1].max() - along[0].min()))
    return deepest


DRAWN = [slug for slug in assignments() if NAME in contract(slug)["results"]]


def shapes(diagram, **how):
    return force_shapes(student_with(diagram), [0.0, 1.0, 2.0], size=0.5, **how)


def student_with(diagram):
    return StudentModule(SimpleNamespace(free_body_diagram=diagram), {NAME: {"diagram": 2}})


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
    axes = np.array([[0.6, -0.8], [0.8, 0.6]])  # unit vectors down a ramp and off it
    (pull,) = shapes(lambda x: [((0, -1), (2, 0))], origin=[(k, 0.0) for k in range(3)], axes=axes)
    np.testing.assert_allclose(pull.points[2], [(2 - 0.8, -0.6), (2 - 0.8 + 0.3, -0.6 - 0.4)])


@pytest.mark.parametrize("slug", first(3, DRAWN))
def test_every_scene_draws_the_diagram(scenes, slug):
    """Each scene shows the forces, and the weight points straight down."""
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
