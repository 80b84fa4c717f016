"""Free body diagrams: every correct way to draw a diagram passes, and messages name what is wrong in others."""

import math
from types import SimpleNamespace

import numpy as np
import pytest

from tam570_grader.checks.case import Case
from tam570_grader.checks.diagrams import INERTIAL, Force, FreeBody, NotAForce, compare_diagrams, complaint, weight
from tam570_grader.checks.expect import Failed
from tam570_grader.checks.returns import free_body_diagram, result
from tam570_grader.protocol.wire import packed, portable, unpacked
from tam570_grader.reports.pictures import sketch
from tam570_grader.results.records import failure, numbers
from tam570_grader.sandbox.replies import checked

G, C, RAMP = (-0.3, 0.2), (0.0, -1.0), math.radians(20)
DOWN = math.sin(RAMP), -math.cos(RAMP)
PULL = weight(G, "G", 9.81, DOWN)
CYLINDER = FreeBody(
    "the cylinder",
    (PULL, Force("the normal force", C, "C", (0, 1), sense=True), Force("the friction", C, "C", (1, 0))),
    others=[(PULL, Force("the force of the ramp", C, "C", push=(0, 1)))],
)
LINK = FreeBody("the link", (weight((0, 0), "G", 9.81), Force("a", (-1, 0), "A"), Force("b", (1, 0), "B")))
NO_DIAGRAMS = [None, 3.0, "down", [1, 2], [(1, 2, 3)], [((0, 0), (0, -1), 5)], [((0, 0), "down")], {(0, 0): (0, -1)}]
NO_DIAGRAMS += [[((0, 0), (0, math.nan))], [((0, 0, 1), (0, 0, -1))], [(None, (0, -1))], [((0, 0), (0, 1j))]]
NO_DIAGRAMS += [[((0, 0), (0, -1))] * 100, [((0, 0), [None, 1.0])], [((0, 0), [[0, -1]])]]


def arrows(drawn, dimension=2):
    """Return the diagram that the grader receives from the sandbox if the student's function returns `drawn`."""
    (reply,) = checked(unpacked(packed({"replies": [{"value": portable(drawn)}]})), "value")
    return result(free_body_diagram(dimension), reply["value"], "free_body_diagram", Case())


def wrong(body, drawn, dimension=2):
    return complaint(body, arrows(drawn, dimension))


UP_THE_RAMP, LEVEL = (-7.0, 0.0), (math.cos(RAMP), math.sin(RAMP))
RIGHT_CYLINDERS = {
    "tuples": [(G, DOWN), (C, (0, 1)), (C, (1, 0))],
    "lists, another order, other lengths, the other sense": [[list(C), [-3, 0]], [list(C), [0, 1e-200]], [G, DOWN]],
    "an array of pairs": np.array([(G, DOWN), (C, (0, 5)), (C, UP_THE_RAMP)]),
    "an array of objects": np.array([[np.array(G), np.array(DOWN)], [np.array(C), None]], dtype=object),
    "unknown at the contact": [(G, DOWN), (C, None)],
    "level and upright components": [(C, LEVEL), (C, (-LEVEL[1], LEVEL[0])), (np.array(G), 9.81 * np.array(DOWN))],
    "huge arrows": [(G, 1e200 * np.array(DOWN)), (C, (0, 1e300)), (C, (1e300, 0))],
    "three components of which the last is zero": [((*G, 0), (*DOWN, 0)), ((*C, 0), None)],
    "no component known": [(G, DOWN), (C, (None, None))],
    "a force of length zero beside it": [(G, DOWN), (C, None), (G, (0.0, 0.0))],
}


@pytest.mark.parametrize("way", RIGHT_CYLINDERS)
def test_every_right_way_to_draw_passes(way):
    assert not wrong(CYLINDER, RIGHT_CYLINDERS[way])


WRONG_CYLINDERS = {
    "You drew the weight at the wrong point": [((0, 0), DOWN), (C, (0, 1)), (C, (1, 0))],
    "You drew the weight upwards": [(G, np.negative(DOWN)), (C, None)],
    "components of the weight": [(G, (DOWN[0], 0)), (G, (0, DOWN[1])), (C, None)],
    "the normal force in the wrong sense": [(G, DOWN), (C, (0, -1)), (C, (1, 0))],
    "You drew the normal force along a wrong line": [(G, DOWN), (C, (0.5, 1)), (C, (1, 0))],
    "You left out the friction": [(G, DOWN), (C, (0, 1))],
    "You left out the weight": [(C, (0, 1)), (C, (1, 0))],
    "at points where none acts; the weight acts at G": [(G[::-1], DOWN[::-1]), (C[::-1], (1, 2)), (C[::-1], (2, -1))],
    "You drew the weight twice": [(G, DOWN), (G, DOWN), (C, None)],
    "You drew the normal force twice": [(G, DOWN), (C, None), (C, (0, 1))],
    "no other body exerts": [(G, DOWN), (C, None), (G, (1, 0.2))],
}


@pytest.mark.parametrize("message", WRONG_CYLINDERS)
def test_what_is_wrong_is_named(message):
    assert message in wrong(CYLINDER, WRONG_CYLINDERS[message])


def test_an_arrow_along_m_a_is_named_as_one_too_many_or_in_place_of_another():
    spring, inertial = Force("the pull", G, "G", (1, 0), sense=True), NotAForce(INERTIAL, G, (2, 1))
    body = FreeBody("the mass", (PULL, spring), wrong=[inertial])
    assert wrong(body, [(G, DOWN), (G, (1, 0)), (G, (2, 1))]) == INERTIAL
    assert "along m a in place of the pull" in wrong(body, [(G, DOWN), (G, (2, 1))])


def test_two_unknown_forces_each_have_both_components():
    both = [((1, 0), (1, 1)), ((1, 0), (2, -2))]
    assert not wrong(LINK, [((0, 0), (0, -2)), ((-1, 0), None), *both])
    assert "no component of it is known" in wrong(LINK, [((0, 0), (0, -2)), ((-1, 0), None), both[0]])
    assert wrong(LINK, [((0, 0), (0, -2)), ((-1, 0), None), both[0], ((1, 0), (2, -1.9))])


@pytest.mark.parametrize("drawn", [[], [((1, 2), (0, -1))], [((1, 2), (0, 1))], [((1, 2), None)], [((1, 2), (0, 0))]])
def test_a_force_of_size_zero_may_be_left_out_or_drawn(drawn):
    assert not wrong(FreeBody("a particle", [weight((1, 2), "it", gravity=0.0)]), drawn)
    assert wrong(FreeBody("a particle", [weight((1, 2), "it", gravity=0.0)]), [*drawn, ((0, 0), (1, 0))])


@pytest.mark.parametrize("drawn", NO_DIAGRAMS, ids=str)
def test_what_is_no_diagram_fails_with_a_message(drawn):
    with pytest.raises(Failed) as failed:
        arrows(drawn)
    assert failed.value.failure.message


def student(drawn):
    """Return a stand-in for a student's function that always returns this diagram."""
    return SimpleNamespace(name="free_body_diagram", many=lambda calls: [arrows(drawn) for _ in calls])


@pytest.mark.parametrize("far", [0.5, 1e6, 1e308])
def test_a_failure_has_a_picture_of_what_was_drawn_and_of_nothing_else(far):
    with pytest.raises(Failed) as failed:
        compare_diagrams(student([(G, DOWN), ((far, -far), (3, 3.1)), (C, None)]), lambda: CYLINDER, [Case()])
    drawn = numbers(failed.value.failure.sketch)
    assert failure({"sketch": drawn}).sketch == drawn
    assert {arrow[2] for arrow in drawn["arrows"]} == {-70, 50, None}  # rounded to 10 degrees: 50 was 46
    assert len(sketch(drawn).unknown) == 1 and sketch(drawn).arrows.count("M") == 2
    assert all(number in range(0, 201, 10) for arrow in drawn["arrows"] for number in arrow[:2])


def test_a_picture_tells_at_most_80_bits():
    """A student who draws arrows that encode hidden numbers learns at most 80 bits from the picture."""
    rng = np.random.default_rng(4)
    drawn = [(tuple(rng.normal(size=2)), tuple(rng.normal(size=2))) for _ in range(8)]
    with pytest.raises(Failed) as failed:
        compare_diagrams(student(drawn), lambda: CYLINDER, [Case()])
    shown = failed.value.failure.sketch["arrows"]
    assert len(shown) == 5 and shown == sorted(shown, key=str)  # sorted, so that the order reveals nothing
    places, angles = 21**2, 360 // 10 + 1 + 1  # -180 and 180 are two angles, and None is another
    assert all(angle % 10 == 0 and x % 10 == y % 10 == 0 for x, y, angle in shown)
    assert math.log2(6 * (places * angles) ** 5) < 80
