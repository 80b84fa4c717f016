"""Laws over all scenes: nothing jumps from frame to frame, no body is where another one is, the page is small."""

import re
from itertools import combinations

import numpy as np
import pytest

from tam570.course import assignments
from tam570.lectures import names
from tam570.show.page import page

STEP, QUICKER = 0.02, 4.0  # of its panel's size, and of the steps before and after it: a jump is larger than both
JUMPS = {  # what the physics has, by scene and shape
    ("planet", "fill"): "the area since the last impulse begins anew",
    ("rocket", "lines"): "the flame goes out",
    ("chains", "arrow"): "the whole chain lies on the scale",
    ("stopping_car", "arrow"): "friction and its moment end with the motion",
    ("hw06_braking", "arrow"): "friction ends with the motion",
}
DEPTH = 1e-3  # of a panel's size, of a touch: half a pixel
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
    """The frames at which a point of a moving shape goes much farther than just before and after."""
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
    """How deep a convex polygon is in another, by the axis along which they are farthest apart."""
    deepest = np.inf
    for polygon in (body, other):
        sides = np.roll(polygon, -1, axis=0) - polygon
        lengths = np.linalg.norm(sides, axis=1)
        for x, y in [*np.eye(2), *(sides[lengths > 0] / lengths[lengths > 0][:, None])]:
            along = [points @ [-y, x] for points in (body, other)]
            deepest = min(deepest, min(along[0].max() - along[1].min(), along[1].max() - along[0].min()))
    return deepest
