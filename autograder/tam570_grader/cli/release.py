"""The commands that hand on the course: stubs, the kit, nbgrader's course, Gradescope's archives."""

import argparse
from pathlib import Path

from tam570_grader.checks import assignments
from tam570_grader.cli.options import Commands, add_command
from tam570_grader.course import course_config
from tam570_grader.gradescope import autograder
from tam570_grader.nbgrader import course
from tam570_grader.release import examples, kit, stubs


def add_stubs(commands: Commands) -> None:
    """Add the command `stubs`."""
    add = add_command(commands, "stubs", _stubs, help="make the students' stubs from the solutions").add_argument
    add("--check", action="store_true", help="write nothing; exit 1 if a stub is out of date")
    add("--examples", nargs="*", metavar="SLUG", help="make the examples that `tam570 check` runs, too")


def add_kit(commands: Commands) -> None:
    """Add the command `kit`."""
    kit = add_command(commands, "kit", _kit, help="make what students install and start from")
    kit.add_argument("folder", type=Path, metavar="DIR", help="where to put it")


def add_course(commands: Commands) -> None:
    """Add the command `course`."""
    _add_folder_and_slugs(add_command(commands, "course", _course, help="make a course that nbgrader runs"))


def add_gradescope(commands: Commands) -> None:
    """Add the command `gradescope`."""
    _add_folder_and_slugs(
        add_command(commands, "gradescope", _gradescope, help="make the archives that Gradescope runs")
    )


def _add_folder_and_slugs(parser: argparse.ArgumentParser) -> None:
    """Add what `_course_and_slugs` reads."""
    parser.add_argument("folder", type=Path, metavar="DIR", help="where to write")
    parser.add_argument("assignments", nargs="*", metavar="SLUG", help="default: all")


def add_trust(commands: Commands) -> None:
    """Add the command `trust`."""
    trust = add_command(commands, "trust", _trust, help="use this course from now on, in its folder and below")
    trust.add_argument("folder", type=Path, nargs="?", default=Path(), metavar="DIR", help="default: this folder")


def _trust(arguments: argparse.Namespace) -> int:
    course_config.trust(arguments.folder)
    return 0


def _stubs(arguments: argparse.Namespace) -> int:
    if arguments.examples is not None:
        return examples.write(course_config.course_of(arguments.root), arguments.examples)
    return stubs.run(course_config.course_of(arguments.root), check=arguments.check)


def _kit(arguments: argparse.Namespace) -> int:
    return kit.run(course_config.course_of(arguments.root), arguments.folder)


def _course(arguments: argparse.Namespace) -> int:
    return course.run(*_course_and_slugs(arguments))


def _gradescope(arguments: argparse.Namespace) -> int:
    return autograder.run(*_course_and_slugs(arguments))


def _course_and_slugs(arguments: argparse.Namespace) -> tuple[Path, Path, list[str]]:
    """Return the checkout, the folder to write to, the assignments."""
    course = course_config.course_of(arguments.root)
    return course, arguments.folder, assignments.match_slugs(arguments.assignments, assignments.slugs(course))
