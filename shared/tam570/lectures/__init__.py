"""The systems that the course solves in class, a module for each: its physics, what it conserves, a scene.

A file in this folder is a lecture if its docstring begins with a date: `31 Aug: A mass on a spring`. Listing the
lectures reads only first lines; loading one imports no other.
"""

import re
from dataclasses import dataclass
from functools import cache
from importlib import import_module
from pathlib import Path
from types import ModuleType

from tam570.course import Unknown

__all__ = ["Lecture", "catalogue", "heading", "is_lecture", "load", "names"]

HEADING = re.compile(r'"""((\d+).*?(Aug|Sept|Oct|Nov)\b.*?): (.*?)\.?"*$')
MONTHS = ("Aug", "Sept", "Oct", "Nov")


@dataclass(frozen=True)
class Lecture:
    """One lecture, from the first line of its module.

    Parameters
    ----------
    name : str
    day : tuple
        Month and day of its first date, to sort by.
    date : str
        As written, such as "19, 21 Sept".
    title : str
    file : Path
    """

    name: str
    day: tuple[int, int]
    date: str
    title: str
    file: Path


def names() -> list[str]:
    """List the names of all lectures, by date.

    Examples
    --------
    >>> names()[-1]
    'rocket'
    """
    return list(catalogue())


def load(name: str) -> ModuleType:
    """Return the module of a lecture.

    Raises
    ------
    Unknown
        If there is no such lecture; the message lists all.

    Examples
    --------
    >>> load("oscillator").EXAMPLE
    {'mass': 1.0, 'stiffness': 4.0}
    """
    if name not in catalogue():
        raise Unknown(f"there is no lecture {name!r}; the lectures are: {', '.join(names())}")
    return import_module(f"tam570.lectures.{name}")


@cache
def catalogue() -> dict[str, Lecture]:
    """Return all lectures by name, in the order of their dates.

    Examples
    --------
    >>> catalogue()["top"].date
    '2 Nov'
    """
    lectures = [lecture for file in Path(__file__).parent.glob("*.py") if (lecture := heading(file))]
    return {lecture.name: lecture for lecture in sorted(lectures, key=lambda lecture: (lecture.day, lecture.name))}


def is_lecture(what: str) -> bool:
    """Return whether this is the name of a lecture, or the file of a lecture or of a copy of one."""
    return what in catalogue() or Path(what).is_file() and heading(Path(what)) is not None


def heading(file: Path) -> Lecture | None:
    """Read the first line of a file; None if the file is neither a lecture nor a copy of one.

    Examples
    --------
    >>> heading(catalogue()["rod"].file).day
    (1, 7)
    """
    with open(file, encoding="utf-8", errors="replace") as text:
        match = HEADING.match(text.readline().rstrip())
    if match is None:
        return None
    date, day, month, title = match.groups()
    return Lecture(file.stem, (MONTHS.index(month), int(day)), date, title, file)
