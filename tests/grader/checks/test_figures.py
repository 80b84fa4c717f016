"""The figures of the problems show what the functions of the assignments mean: signs, lengths, points."""

import math
from xml.etree import ElementTree

import numpy as np
import pytest

from tam570_grader.checks import assignments
from tam570_grader.checks.figures import WIDTH

COURSE = assignments.find()
SVG = "{http://www.w3.org/2000/svg}"


def drawn(figure):
    """The named points of a figure, in px."""
    circles = ElementTree.fromstring(figure.svg()).iter(f"{SVG}circle")
    return {item.get("data-name"): np.array([float(item.get("cx")), float(item.get("cy"))]) for item in circles}


def moved(slug, name, **changed):
    """How far a named point moves, in m to the right and up, when the figure is drawn with other values."""
    before, after = assignments.figure(COURSE, slug), assignments.figure(COURSE, slug, **changed)
    return (drawn(after)[name] - drawn(before)[name]) * [1, -1] / before.scale


def test_every_assignment_has_a_figure_in_words_too_for_light_and_dark(slug):
    text = (COURSE / "assignments" / slug / "figure.svg").read_text()
    figure = ElementTree.fromstring(text)
    assert len(text.encode()) < 20_000
    assert figure.find(f"{SVG}title").text and len(figure.find(f"{SVG}desc").text) > 80
    assert "prefers-color-scheme:dark" in text and "http" not in text.replace("http://www.w3.org/2000/svg", "")
    assert "](figure.svg)" in (COURSE / "assignments" / slug / "README.md").read_text()


def test_what_is_drawn_is_within_the_figure(slug):
    figure = assignments.figure(COURSE, slug)
    for at in drawn(figure).values():
        assert (at > 0).all() and (at < [WIDTH, figure.height]).all()
    for text in ElementTree.fromstring(figure.svg()).iter(f"{SVG}text"):
        assert 0 < float(text.get("x")) < WIDTH and 0 < float(text.get("y")) < figure.height, "".join(text.itertext())


def solution(slug):
    return assignments.solution(slug, COURSE)


def test_the_pendulum_hangs_where_its_forces_act():
    theta, other = 0.65, -0.4
    fields = {"mass": 1.0, "length": 1.0, "gravity": 1.0}
    places = [solution("hw01_simple_pendulum").free_body_diagram(th, 0.0, **fields)[0][0] for th in (theta, other)]
    assert moved("hw01_simple_pendulum", "m", theta=other) == pytest.approx(places[1] - places[0], abs=1e-3)


def test_the_bars_are_those_of_the_wireframe():
    wireframe = solution("hw07_double_pendulum").wireframe
    before, after = (wireframe(np.array(theta), lengths=np.ones(2)) for theta in ((0.5, 1.15), (0.9, -0.3)))
    for name, bar in (("elbow", 0), ("tip", 1)):
        shift = moved("hw07_double_pendulum", name, th1=0.9, th2=-0.3)
        assert shift == pytest.approx(after[bar, 1] - before[bar, 1], abs=1e-3)


def test_the_particle_is_at_the_end_of_its_rod():
    angles = 0.8, -1.9
    places = [np.array([math.sin(theta), -math.cos(theta)]) for theta in angles]
    assert moved("hw05_constrained_pendulum", "m", theta=angles[1]) == pytest.approx(places[1] - places[0], abs=1e-3)


def test_the_bead_is_on_its_wire():
    assert moved("hw12_bead_on_wire", "m", x=-0.4) == pytest.approx([-1.15, 0.4**2 - 0.75**2], abs=1e-3)


def test_the_heavy_side_turns_down_the_ramp():
    slope, fields = 0.4, {"mass": 1.0, "radius": 1.0, "offset": 0.5, "slope": 0.4, "gravity": 1.0}
    diagram = solution("hw13_rolling_cylinder").free_body_diagram
    (before, down), (after, _) = (diagram(phi, **fields)[0] for phi in (0.9, 2.0))
    along, off = np.subtract(after, before)  # the axes of the ramp
    level = along * math.cos(slope) + off * math.sin(slope), off * math.cos(slope) - along * math.sin(slope)
    assert moved("hw13_rolling_cylinder", "G", phi=2.0) == pytest.approx(level, abs=1e-3)
    assert down == pytest.approx([math.sin(slope), -math.cos(slope)])


def test_a_positive_lean_carries_the_centre_towards_the_axis():
    shift = moved("hw11_disk_steady", "G", lean=0.8)
    assert shift == pytest.approx([math.sin(0.45) - math.sin(0.8), math.cos(0.8) - math.cos(0.45)], abs=1e-3)


def test_the_rolling_disk_is_seen_where_it_is():
    shape = solution("hw14_rolling_disk").matrix_state
    states = [np.array([0.9, 0.6, 0.6, tilt, 0.6, 0, 0, 0]) for tilt in (1.95, 1.2)]
    before, after = (shape(state, radius=1.0)[:3] for state in states)
    reference, up = right_and_up(-1.75, 0.4)
    assert moved("hw14_rolling_disk", "G", tilt=1.2) == pytest.approx(
        [reference @ (after - before), up @ (after - before)], abs=1e-3
    )


def right_and_up(azimuth, elevation):
    """The contract's directions of a projection."""
    project = solution("hw04_hanging_spring").project
    return np.asarray(project(np.eye(3), azimuth, elevation)).T


def test_the_mass_on_the_spring_is_projected_as_asked():
    shift = np.array([-0.5, 0.8, -0.9]) - [0.75, 0.35, -1.1]
    reference, up = right_and_up(-0.9, 0.3)
    assert moved("hw04_hanging_spring", "m", position=(-0.5, 0.8, -0.9)) == pytest.approx(
        [reference @ shift, up @ shift], abs=1e-3
    )


def test_the_car_turns_counter_clockwise():
    """G stays; the front axle goes round it."""
    before, after = (
        assignments.figure(COURSE, "hw06_braking", heading=heading).svg() for heading in (0.0, math.pi / 2)
    )
    assert drawn_speed(before) == pytest.approx([1, 0], abs=0.02)
    assert drawn_speed(after) == pytest.approx([0, 1], abs=0.02)


def drawn_speed(svg):
    """The direction of the arrow of the speed."""
    paths = [item for item in ElementTree.fromstring(svg).iter(f"{SVG}path") if item.get("class") == "vector"]
    first, last = (np.array(place.split(), float) for place in paths[0].get("d")[1:].split("L"))
    return (last - first) * [1, -1] / math.dist(first, last)
