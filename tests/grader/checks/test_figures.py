"""The figures of the problems agree with the functions of the solutions: signs, lengths, points."""

import math
from xml.etree import ElementTree

import numpy as np
import pytest

from tam570_grader.checks import assignments
from tam570_grader.checks.assignments import solution

COURSE = assignments.find()
SVG = "{http://www.w3.org/2000/svg}"


def drawn(figure):
    """Return {name: (2,) position, px} of the named points of a figure."""
    circles = ElementTree.fromstring(figure.svg()).iter(f"{SVG}circle")
    return {item.get("data-name"): np.array([float(item.get("cx")), float(item.get("cy"))]) for item in circles}


def moved(slug, name, **changed):
    """Return how far a named point moves, m to the right and up, if the figure is drawn with other values."""
    before, after = assignments.figure(COURSE, slug), assignments.figure(COURSE, slug, **changed)
    return (drawn(after)[name] - drawn(before)[name]) * [1, -1] / before.scale


def right_and_up(azimuth, elevation):
    """Return the (2, 3) matrix of the projection of hw04; its rows point to the right and up."""
    return np.asarray(solution("hw04_hanging_spring").project(np.eye(3), azimuth, elevation)).T


def hanging(theta):
    return np.array([math.sin(theta), -math.cos(theta)])


def tip(th1, th2):
    return solution("hw07_double_pendulum").wireframe(np.array([th1, th2]), lengths=np.ones(2))[1, 1]


def bob(theta):
    return np.asarray(solution("hw01_simple_pendulum").free_body_diagram(theta, 0.0, mass=1, length=1, gravity=1)[0][0])


def heavy_side(phi, slope=0.4):
    """Return the position of the cylinder's G, (2,), with components to the right and up."""
    cylinder = {"mass": 1.0, "radius": 1.0, "offset": 0.5, "slope": slope, "gravity": 1.0}
    along, off = solution("hw13_rolling_cylinder").free_body_diagram(phi, **cylinder)[0][0]
    return np.array([along * math.cos(slope) + off * math.sin(slope), off * math.cos(slope) - along * math.sin(slope)])


def centre(tilt):
    state = np.array([0.9, 0.6, 0.6, tilt, 0.6, 0, 0, 0])
    return right_and_up(-1.75, 0.4) @ solution("hw14_rolling_disk").matrix_state(state, radius=1.0)[:3]


BARS = {"th1": 0.5, "th2": 1.15}, {"th1": 0.9, "th2": -0.3}
MOVES = {  # slug: (point, parameters of the figure, other parameters, function that returns the point's position)
    "hw01_simple_pendulum": ("m", {"theta": 0.65}, {"theta": -0.4}, bob),
    "hw04_hanging_spring": (
        "m",
        {"position": (0.75, 0.35, -1.1)},
        {"position": (-0.5, 0.8, -0.9)},
        lambda position: right_and_up(-0.9, 0.3) @ position,
    ),
    "hw05_constrained_pendulum": ("m", {"theta": 0.8}, {"theta": -1.9}, hanging),
    "hw07_double_pendulum": ("tip", *BARS, tip),
    "hw11_disk_steady": ("G", {"lean": 0.45}, {"lean": 0.8}, lambda lean: -hanging(lean)),
    "hw12_bead_on_wire": ("m", {"x": 0.75}, {"x": -0.4}, lambda x: np.array([x, x**2])),
    "hw13_rolling_cylinder": ("G", {"phi": 0.9}, {"phi": 2.0}, heavy_side),
    "hw14_rolling_disk": ("G", {"tilt": 1.95}, {"tilt": 1.2}, centre),
}


@pytest.mark.parametrize("slug", MOVES)
def test_a_point_is_where_the_contract_has_it(slug):
    point, before, after, position = MOVES[slug]
    assert moved(slug, point, **after) == pytest.approx(position(**after) - position(**before), abs=1e-3)


def test_the_car_turns_counter_clockwise():
    """The arrow of the car's velocity turns counter-clockwise as the heading grows."""
    for heading, direction in ((0.0, [1, 0]), (math.pi / 2, [0, 1])):
        svg = assignments.figure(COURSE, "hw06_braking", heading=heading).svg()
        paths = [item for item in ElementTree.fromstring(svg).iter(f"{SVG}path") if item.get("class") == "vector"]
        first, last = (np.array(end.split(), float) for end in paths[0].get("d")[1:].split("L"))
        assert (last - first) * [1, -1] / math.dist(first, last) == pytest.approx(direction, abs=0.02)
