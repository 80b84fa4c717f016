"""Measure run time and error of a student's simulation, on a scene on which the integrators were measured."""

import numpy as np

from tam570.values import Json
from tam570_grader.checks.assignments import LoadedAssignment
from tam570_grader.checks.check import LruCache
from tam570_grader.checks.expect import Failed, NotWritten
from tam570_grader.results.run_time import Speed, scenes, time_to
from tam570_grader.sandbox.imports import NotLoaded
from tam570_grader.sandbox.process import ProcessLost
from tam570_grader.sandbox.student import BudgetSpent, Source, Student
from tam570_grader.sandbox.zygote import Zygote

OURS = "tam570, Python"  # name of the curve of the reference solutions' method, as it runs in the sandbox
USELESS = 1e-2  # relative error above which the time means nothing
SHORTEST = 5e-3  # s, least time of the reference solution; below it, the call into the sandbox dominates
_machines = LruCache[float | None](most=100)  # by assignment: this machine's time over that of the curves' machine


def speed_of(student: Student, assignment: LoadedAssignment, zygote: Zygote) -> Speed | None:
    """Return the student's run time and error; None if the assignment has no scene or the simulation is unusable."""
    scene = scenes().get(assignment.slug)
    if scene is None or (point := _point(student, scene)) is None:
        return None
    machine = _machines.value((assignment.root, assignment.slug), lambda: _measured(assignment, zygote))
    if machine is None:
        return None
    seconds, error, machine = (float(f"{number:.2g}") for number in (*point, machine))
    words = {"function": scene["function"], "scene": scene["scene"]}
    return {**words, "seconds": seconds, "error": error, "machine": machine}


def _measured(assignment: LoadedAssignment, zygote: Zygote) -> float | None:
    """Return the reference solution's time here divided by its time on the machine of the curves; None if too short."""
    reference, scene = Student(Source(assignment.solution.encode()), assignment, zygote), scenes()[assignment.slug]
    try:
        _point(reference, scene)  # warm up: do not count work that is done once per system
        point = _point(reference, scene)
    finally:
        reference.leave()
    if point is None or point[0] < SHORTEST:
        return None
    curve = scene["curves"][OURS]
    return point[0] / (time_to(max(point[1], curve[-1][1]), curve) or curve[-1][0])


def _point(student: Student, scene: Json) -> tuple[float, float] | None:
    """Return CPU seconds of a call, including the transfer of data, and its relative error; None if it is unusable."""
    try:
        student.load()
        before = student.seconds()
        states = getattr(student, scene["function"])(*scene["arguments"], **scene["keywords"])
        seconds = student.seconds() - before
    except (Failed, NotWritten, NotLoaded, BudgetSpent, ProcessLost):
        return None
    end = np.array(scene["end"])
    error = float(np.abs(states[-1] - end).max() / np.abs(end).max())
    return (seconds, error) if seconds > 0 and 0 < error < USELESS else None
