"""The commands that release a course (stubs, kit, nbgrader's course, Gradescope's archives), and `trust`."""

import argparse
from collections.abc import Callable, Sequence
from pathlib import Path

from tam570_grader.checks import assignments
from tam570_grader.course import course_config
from tam570_grader.gradescope import autograder
from tam570_grader.nbgrader import course
from tam570_grader.release import examples, kit, stubs


def add_stubs(parser: argparse.ArgumentParser) -> None:
    """Add the options of `stubs`."""
    parser.set_defaults(command=_stubs)
    add = parser.add_mutually_exclusive_group().add_argument
    add("--check", action="store_true", help="write nothing; exit 1 if a stub is out of date")
    examples = "make the examples that `tam570 check` runs instead, of these assignments or of all"
    add("--examples", nargs="*", metavar="SLUG", help=examples)


def add_kit(parser: argparse.ArgumentParser) -> None:
    """Add the options of `kit`."""
    parser.set_defaults(command=lambda arguments: kit.run(course_config.course_of(arguments.root), arguments.folder))
    parser.add_argument("folder", type=Path, metavar="DIR", help="where to put it")


def add_course(parser: argparse.ArgumentParser) -> None:
    """Add the options of `course`."""
    _add_folder_and_slugs(parser, course.run)


def add_gradescope(parser: argparse.ArgumentParser) -> None:
    """Add the options of `gradescope`."""
    _add_folder_and_slugs(parser, autograder.run)


def add_trust(parser: argparse.ArgumentParser) -> None:
    """Add the options of `trust`."""
    parser.set_defaults(command=_trust)
    parser.add_argument("folder", type=Path, nargs="?", default=Path(), metavar="DIR", help="default: this folder")


def _add_folder_and_slugs(parser: argparse.ArgumentParser, write: Callable[[Path, Path, Sequence[str]], int]) -> None:
    """Add the options of a command that writes some assignments of a course into a folder."""

    def command(arguments: argparse.Namespace) -> int:
        course = course_config.course_of(arguments.root)
        slugs = assignments.match_slugs(arguments.assignments, assignments.slugs(course))
        return write(course, arguments.folder, slugs)

    parser.set_defaults(command=command)
    parser.add_argument("folder", type=Path, metavar="DIR", help="where to write")
    parser.add_argument("assignments", nargs="*", metavar="SLUG", help="default: all")


def _stubs(arguments: argparse.Namespace) -> int:
    course = course_config.course_of(arguments.root)
    if arguments.examples is not None:
        return examples.write(course, arguments.examples)
    return stubs.run(course, check=arguments.check)


def _trust(arguments: argparse.Namespace) -> int:
    course_config.trust(arguments.folder)
    return 0
