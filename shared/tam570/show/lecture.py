"""Make the scene of a lecture or an assignment with other numbers.

A lecture has EXAMPLE, a dict of parameters, and `film(parameters)`. If its system moves, it also has START, SECONDS and
STATE, and `film(parameters, start, seconds)`. The scene of an assignment has the same, and `film(student, ...)`.
"""

import ast
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from types import ModuleType

from tam570.arguments import finite, like, positive
from tam570.course import Unknown
from tam570.lectures import catalogue, load
from tam570.loading import Trouble
from tam570.show.patience import patience
from tam570.show.scene import Scene, drawable_rate
from tam570.show.student import StudentModule, load_student
from tam570.values import Json, Parameters

LONGEST = 600.0  # s, of a scene
MOST_WORK = 20.0  # s of processor time to make a scene


def lecture_module(what: str) -> ModuleType:
    """Return the lecture of this name, or the copy of one in a file. Raise Unknown or Trouble if there is none."""
    file = Path(what)
    if not file.is_file() or what in catalogue():
        return load(what)
    module = load_student(file, f"copy_of_{file.stem}")
    if not (hasattr(module, "film") and hasattr(module, "EXAMPLE")):
        raise Trouble(f"{what} has no film or no EXAMPLE; tam570 start makes a new copy of a lecture")
    return module


def settings(texts: Sequence[str]) -> Json:
    """Return the values in "mass=2", "start.speed=3", "masses=1,2", by name. Raise Unknown for any other text."""
    result: Json = {}
    for text in texts:
        name, equals, value = text.partition("=")
        if not (name.strip() and equals and value.strip()):
            raise Unknown(f"--set takes NAME=VALUE, as in mass=2, and not {text!r}")
        try:
            result[name.strip()] = ast.literal_eval(value.strip())
        except (ValueError, SyntaxError):
            result[name.strip()] = value.strip()  # a choice, such as saddle
    return result


def filmed(source: ModuleType, numbers: Parameters | None = None, *before: StudentModule) -> Scene:
    """Make a scene with the source's EXAMPLE, START and SECONDS, some of their numbers changed.

    source  : a lecture, or the scene of an assignment
    numbers : by parameter, by "start.speed" for a number of the start, or "seconds"
    before  : first arguments of the source's `film`
    Raise Unknown for a name that does not exist, with all names; Trouble if the scene cannot be made.
    """
    values: Json = dict(source.EXAMPLE)
    moves = hasattr(source, "START")
    if moves:
        values |= {f"start.{name}": value for name, value in zip(source.STATE, source.START, strict=True)}
        values["seconds"] = source.SECONDS
    for name in numbers or {}:
        if name not in values:
            raise Unknown(f"there is no number {name!r} to set; there are: {', '.join(values)}")
    examples, values = values, {**values, **(numbers or {})}
    try:
        for name in numbers or {}:
            like(examples[name], **{name: values[name]})
        arguments = _arguments(dict(values)) if moves else (values,)
        for name in [f"start.{name}" for name, unit in source.STATE.items() if unit == "rad/s"] if moves else ():
            drawable_rate(name, values[name])
        with patience("the motion", MOST_WORK):
            scene: Scene = source.film(*before, *arguments)
    except (TypeError, ValueError, ArithmeticError, Trouble) as error:
        nameless = not before and not any(name.rpartition(".")[2] in str(error) for name in numbers or {})
        remedies = [f"; try {name} nearer to {examples[name]}" for name in numbers or {} if nameless]
        raise Trouble(f"{error}{''.join(remedies)}") from error
    return replace(scene, settings=values)


def _arguments(settings: Json) -> tuple[Json, tuple[float, ...], float]:
    """Return parameters, start and seconds. Raise ValueError if the last two cannot be shown."""
    start = {name: settings.pop(name) for name in list(settings) if name.startswith("start.")}
    finite(**start)
    positive(seconds=settings["seconds"])
    if settings["seconds"] > LONGEST:
        raise ValueError(f"seconds: at most {LONGEST:g}, got {settings['seconds']:g}")
    return settings, tuple(start.values()), settings.pop("seconds")
