"""Free body diagrams: the forces on a body, and what is wrong with the arrows that a student drew.

    def free_body_diagram(theta, omega, mass, length, gravity):
        r = length * np.array([math.sin(theta), -math.cos(theta)])
        rod = Force("the force of the rod", r, "the mass", along=r)
        return FreeBody("the mass", (weight(r, "the mass", gravity), rod))

A diagram is right if each force is drawn once, at its point, along its line, in its sense if that is known, and
nothing else is drawn. The order and the lengths of the arrows are free.
"""

import itertools
import math
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import partial

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tam570.values import Json, Numbers
from tam570_grader.checks.case import Case
from tam570_grader.checks.compare import Reference, call_cases
from tam570_grader.checks.expect import Failed, FollowsFrom, NotWritten, fail
from tam570_grader.checks.figures import seen_from
from tam570_grader.checks.returns import Arrow
from tam570_grader.checks.student import StudentFunction

Vector = NDArray[np.float64]

# Tolerance of directions, in rad, and of points, relative to the farthest one. Single precision errs by 6e-8.
SAME = 1e-6
SHEET, GRID, COARSE = 200, 10, 10  # px, px, degrees: size and resolution of the picture of a student's arrows
SHOWN = 5  # arrows in it; no right diagram has more
SEEN_FROM = -1.1, 0.35  # rad, azimuth and elevation of the eye, if the body has three dimensions
NEGLIGIBLE = 1e-9  # of the forces on the body; a smaller force is zero up to rounding, and may be left out

INERTIAL = "You drew m a as a force; no other body exerts it. Write it on the other side of F = m a."
IN_PLACE = "You drew an arrow along m a in place of {}. m a is the sum of all forces; no other body exerts it."
CENTRIFUGAL = (
    "You drew a second force along the rod, outwards. No other body exerts a centrifugal force, and the pull of the "
    "mass acts on the rod."
)


@dataclass(frozen=True)
class Force:
    """A force that another body exerts on this one.

    name  : "the weight"
    point : (d,) where it acts
    where : the point in words, "G"
    along : (d,) its line of action; None if no component is known
    sense : whether it is known beforehand that the force points along `along`, and not against it
    acts  : whether it can be other than zero in this state; else it may be left out, or drawn in any direction
    push  : direction in which an unknown force of a surface can push; no arrow may point straight against it
    reversed : message for a student who draws it in the other sense
    """

    name: str
    point: ArrayLike
    where: str
    along: ArrayLike | None = None
    sense: bool = False
    acts: bool = True
    push: ArrayLike | None = None
    reversed: str = ""

    def drawn_by(self, arrows: Sequence[Arrow], near: float) -> bool:
        """Return whether these arrows together draw exactly this force."""
        if not self.acts and not arrows:
            return True
        if not arrows or not all(_at(self, arrow, near) for arrow in arrows):
            return False
        if len(arrows) > 1:
            drawn = [arrow.direction for arrow in arrows if arrow.direction is not None]
            pulls = self.push is not None and any(_parallel(-line, self.push, sense=True) for line in drawn)
            return self.along is None and _perpendicular(arrows) and not pulls
        return not self.acts or _same_line(self, arrows[0], self.sense)


@dataclass(frozen=True)
class NotAForce:
    """An arrow that students draw although no other body exerts this force.

    along : its line, or with `sense` its direction; None for any arrow at this point
    """

    message: str
    point: ArrayLike
    along: ArrayLike | None = None
    sense: bool = False

    def drawn_by(self, arrow: Arrow, near: float) -> bool:
        return _at(self, arrow, near) and (self.along is None or _same_line(self, arrow, self.sense))


@dataclass(frozen=True)
class FreeBody:
    """A body, and all forces that other bodies exert on it.

    others  : the same forces, divided differently: a contact as one unknown force, not as normal and friction
    wrong   : wrong arrows that students draw, the more special first
    outline : (k, 2, d) lines of the body, for the picture of what a student drew
    """

    name: str
    forces: Sequence[Force]
    others: Sequence[Sequence[Force]] = ()
    wrong: Sequence[NotAForce] = ()
    outline: ArrayLike = ()


def weight(point: ArrayLike, where: str, gravity: float, down: ArrayLike = (0.0, -1.0)) -> Force:
    """Return the weight, along `down`; it may be left out if gravity is zero."""
    reversed = "You drew the weight upwards: this is the force that the body exerts on the earth."
    return Force("the weight", point, where, down, sense=True, acts=gravity != 0, reversed=reversed)


def compare_diagrams(
    function: StudentFunction,
    reference: Reference,
    cases: Iterable[Case],
    source: tuple[StudentFunction, Callable[[Case], FreeBody]] | None = None,
) -> None:
    """Fail unless the student draws, in every case, the forces of the `FreeBody` that `reference` returns.

    source : the student's function that computes a force, and a function that returns the body with its results
    """
    for case, arrows, body in call_cases(function, reference, cases):
        if message := complaint(body, arrows):
            acting = [force for force in body.forces if force.acts]
            along = [None if force.along is None else np.asarray(force.along, float) for force in acting]
            expected = [Arrow(np.asarray(force.point, float), line) for force, line in zip(acting, along, strict=True)]
            wrong = f"the free body diagram of {body.name} is wrong"
            hint = partial(_hint, message, arrows, case, source)
            fail(wrong, hint=hint, sketch=_sketch(body, arrows), expected=_sketch(body, expected))


def _hint(
    message: str, arrows: Sequence[Arrow], case: Case, source: tuple[StudentFunction, Callable[[Case], FreeBody]] | None
) -> str:
    """Return what is wrong, or FollowsFrom if the diagram is right for the results of the student's own function."""
    try:
        return FollowsFrom(source[0].name) if source and not complaint(source[1](case), arrows) else message
    except (Failed, NotWritten):
        return message


def complaint(body: FreeBody, arrows: Sequence[Arrow]) -> str:
    """Return what is wrong with a diagram; empty if it is right."""
    near = SAME * max(float(np.linalg.norm(np.asarray(force.point, float))) for force in body.forces)
    if _is_drawn(body.forces, arrows, near) or not any(match := _best_match(body, arrows, near)):
        return ""
    complaints = _misplaced(*match, near), _not_a_force(body, arrows, match, near), *_general(body, *match, near)
    return next(filter(None, complaints))


def _sketch(body: FreeBody, arrows: Sequence[Arrow]) -> Json:
    """Return the student's arrows and the body, so coarse that they can carry no hidden input: 14 bits an arrow.

    outline : lines [x1, y1, x2, y2], 0 to SHEET, y up
    arrows  : [x, y, angle in degrees], None for an unknown direction; at most SHOWN
    """
    flat = seen_from(*SEEN_FROM) if np.size(body.forces[0].point) == 3 else np.asarray
    outline = np.reshape(flat(body.outline), (-1, 2, 2)) if np.size(body.outline) else np.empty((0, 2, 2))
    points = np.reshape([flat(arrow.point) for arrow in arrows], (-1, 2))
    seen = outline.reshape(-1, 2) if len(outline) else points
    middle = (seen.max(axis=0) + seen.min(axis=0)) / 2 if len(seen) else np.zeros(2)
    size = max(float(np.ptp(seen, axis=0).max()) if len(seen) else 0.0, 1e-300)

    def placed(at: ArrayLike, grid: int) -> Numbers:
        with np.errstate(all="ignore"):  # a student's point may be very large, or NaN
            share = np.nan_to_num((np.asarray(at) - middle) / size)
        return (grid * np.rint(np.clip(share / 2 + 0.5, 0, 1) * SHEET / grid)).astype(int).tolist()

    angles = [None if arrow.direction is None else _angle(flat(_unit(arrow.direction))) for arrow in arrows]
    drawn = [[*placed(point, GRID), angle] for point, angle in zip(points, angles, strict=True)]
    return {
        "body": body.name,
        "outline": [[*placed(start, 1), *placed(other, 1)] for start, other in outline],
        "arrows": sorted(drawn, key=str)[:SHOWN],
    }


def _angle(direction: Vector) -> int:
    return round(math.degrees(math.atan2(direction[1], direction[0])) / COARSE) * COARSE


def _is_drawn(forces: Sequence[Force], arrows: Sequence[Arrow], near: float) -> bool:
    """Return whether each force has its own arrow, the first that draws it, and no arrow is left."""
    unmatched = list(arrows)
    for force in forces:
        if not (drawn := next((arrow for arrow in unmatched if force.drawn_by([arrow], near)), None)):
            return False
        unmatched = [arrow for arrow in unmatched if arrow is not drawn]
    return not unmatched


Match = tuple[list[Force], list[Arrow]]  # missing forces, and arrows that draw no force


def _faults(match: Match) -> int:
    missing, extra = match
    return len(missing) + len(extra)


def _best_match(body: FreeBody, arrows: Sequence[Arrow], near: float) -> Match:
    """Return the match with the fewest faults, over all divisions into forces."""
    return min((_match(forces, arrows, near) for forces in (body.forces, *body.others)), key=_faults)


def _match(forces: Sequence[Force], arrows: Sequence[Arrow], near: float) -> Match:
    ways = [[*_ways(force, arrows, near)] for force in forces]
    best = max(itertools.product(*ways), key=_worth)
    used = set(itertools.chain.from_iterable(filter(None, best)))
    missing = [force for force, way in zip(forces, best, strict=True) if way is None]
    return missing, [arrow for number, arrow in enumerate(arrows) if number not in used]


def _worth(ways: Sequence[tuple[int, ...] | None]) -> tuple[int, int]:
    """Return how many forces are drawn, and by how many arrows; (-1, 0) if an arrow draws two."""
    used = [*itertools.chain.from_iterable(filter(None, ways))]
    if len(set(used)) < len(used):
        return -1, 0
    return sum(way is not None for way in ways), len(used)


def _ways(force: Force, arrows: Sequence[Arrow], near: float) -> Iterator[tuple[int, ...] | None]:
    """Yield the indices of arrows that together draw a force, and first None, for a missing force."""
    yield None
    sizes = {0, 1, np.size(force.point)}
    for numbers in itertools.chain.from_iterable(itertools.combinations(range(len(arrows)), n) for n in sizes):
        if force.drawn_by([arrows[number] for number in numbers], near):
            yield numbers


def _misplaced(missing: Sequence[Force], extra: Sequence[Arrow], near: float) -> str:
    """Return a message if a force of known sense is drawn reversed, at another point, or by its components."""
    for force, arrow in itertools.product([other for other in missing if other.sense], extra):
        here = [other for other in extra if other is not arrow and _at(force, other, near)]
        if _at(force, arrow, near) and any(_perpendicular([arrow, other]) for other in here):
            return f"You drew components of {force.name}; draw the force as one arrow."
        if _at(force, arrow, near) and _same_line(force, arrow):
            return force.reversed or f"You drew {force.name} in the wrong sense."
        if _same_line(force, arrow, sense=True):
            return _elsewhere(force)
    return ""


def _elsewhere(force: Force) -> str:
    return f"You drew {force.name} at the wrong point; it acts at {force.where}."


def _not_a_force(body: FreeBody, arrows: Sequence[Arrow], match: Match, near: float) -> str:
    """Return a message on an arrow that is no force, nor meant as a missing one, if the diagram is better without."""
    missing, extra = match
    for wrong, arrow in itertools.product(body.wrong, arrows):
        others = [other for other in arrows if other is not arrow]
        meant = len(extra) == 1 and any(not force.sense and _at(force, arrow, near) for force in missing)
        better = _faults(_best_match(body, others, near)) < _faults(match)
        if wrong.drawn_by(arrow, near) and better and not meant:
            lost = next((force for force in missing if _at(force, arrow, near)), None)
            return IN_PLACE.format(lost.name) if lost and wrong.message == INERTIAL else wrong.message
    return ""


def _general(body: FreeBody, missing: Sequence[Force], extra: Sequence[Arrow], near: float) -> Iterator[str]:
    """Yield messages about mistakes that can be made with any body, the more special first."""
    for force, arrow in itertools.product(missing, extra):
        yield _instead(force, arrow, near)
    fewest = min(map(len, (body.forces, *body.others)))
    if len(extra) >= fewest and not any(_at(*pair, near) for pair in itertools.product(body.forces, extra)):
        yield f"You drew your forces at points where none acts; {body.forces[0].name} acts at {body.forces[0].where}."
    for force in missing:
        astray = force.along is not None and any(_at(force, arrow, near) for arrow in extra)
        mistake = f"drew {force.name} along a wrong line" if astray else f"left out {force.name}"
        mistake += ", or left it out" if astray and len(missing) + len(extra) > 2 else ""
        yield f"You {mistake}; it acts at {force.where}."
    for force, arrow in itertools.product(itertools.chain(body.forces, *body.others), extra):
        if _at(force, arrow, near) and (force.along is None or _same_line(force, arrow)):
            yield f"You drew {force.name} twice."
    yield f"You drew a force on {body.name} that no other body exerts. Nothing exerts m a or a centrifugal force."


def _instead(force: Force, arrow: Arrow, near: float) -> str:
    """Return what is wrong with an arrow if it is meant to be this missing force; else an empty text."""
    if not _at(force, arrow, near):
        return _elsewhere(force) if _same_line(force, arrow) else ""
    if force.along is None:
        return f"You drew a part of {force.name}; no component of it is known. Write None for its direction."
    if arrow.direction is None:
        return f"You wrote None for the direction of {force.name}; its line is known."
    return ""


def _at(force: Force | NotAForce, arrow: Arrow, near: float) -> bool:
    return math.dist(arrow.point, np.asarray(force.point, float)) <= near


def _same_line(force: Force | NotAForce, arrow: Arrow, sense: bool = False) -> bool:
    if force.along is None or arrow.direction is None:
        return force.along is None and arrow.direction is None
    return _parallel(arrow.direction, force.along, sense)


def _parallel(direction: Vector, along: ArrayLike, sense: bool) -> bool:
    """Return whether two vectors have the same direction or, without `sense`, opposite directions."""
    first, other = _unit(direction), _unit(along)
    apart = math.dist(first, other) if sense else min(math.dist(first, other), math.dist(first, -other))
    return apart <= SAME


def _perpendicular(arrows: Sequence[Arrow]) -> bool:
    """Return whether there are as many arrows as dimensions, perpendicular to each other."""
    if any(arrow.direction is None for arrow in arrows):
        return False
    units = np.array([_unit(arrow.direction) for arrow in arrows])
    return len(units) == units.shape[1] and bool(np.abs(units @ units.T - np.eye(len(units))).max() <= SAME)


def _unit(vector: ArrayLike | None) -> Vector:
    """Return the unit vector, zero for zero; divide by the largest component first: squares may over- or underflow."""
    vector = np.asarray(vector, float)
    size = float(np.abs(vector).max())
    if not size:
        return vector
    vector = vector / size
    return np.asarray(vector / np.linalg.norm(vector))
