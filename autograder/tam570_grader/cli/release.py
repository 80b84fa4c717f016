"""The commands that hand on the course: stubs, the kit, nbgrader's course, Gradescope's archives."""

import argparse
from pathlib import Path

from tam570_grader.cli.options import Commands


def _parser(commands: Commands, name: str, sentence: str) -> argparse.ArgumentParser:
    """Return the parser of a command of which one sentence tells enough."""
    parser: argparse.ArgumentParser = commands.add_parser(
        name, help=sentence, description=f"{sentence[0].upper()}{sentence[1:]}."
    )
    return parser


def add_stubs(commands: Commands) -> argparse.ArgumentParser:
    """Add the command `stubs`."""
    stubs = _parser(commands, "stubs", "make the students' stubs from the solutions")
    stubs.set_defaults(command=_stubs)
    stubs.add_argument("--check", action="store_true", help="write nothing; exit 1 if a stub is out of date")
    stubs.add_argument("--examples", nargs="*", metavar="SLUG", help="make the examples that `tam570 check` runs, too")
    return stubs


def add_kit(commands: Commands) -> argparse.ArgumentParser:
    """Add the command `kit`."""
    kit = _parser(commands, "kit", "make what students install and start from")
    kit.set_defaults(command=_kit)
    kit.add_argument("folder", type=Path, metavar="DIR", help="where to put it")
    return kit


def add_course(commands: Commands) -> argparse.ArgumentParser:
    """Add the command `course`."""
    course = _parser(commands, "course", "make a course that nbgrader runs")
    course.set_defaults(command=_course)
    return _folder_and_slugs(course)


def add_gradescope(commands: Commands) -> argparse.ArgumentParser:
    """Add the command `gradescope`."""
    gradescope = _parser(commands, "gradescope", "make the archives that Gradescope runs")
    gradescope.set_defaults(command=_gradescope)
    return _folder_and_slugs(gradescope)


def _folder_and_slugs(parser: argparse.ArgumentParser) -> argparse.ArgumentParser:
    """Return the parser, with what `_course_and_slugs` reads."""
    parser.add_argument("folder", type=Path, metavar="DIR", help="where to write")
    parser.add_argument("assignments", nargs="*", metavar="SLUG", help="default: all")
    return parser


def add_trust(commands: Commands) -> argparse.ArgumentParser:
    """Add the command `trust`."""
    trust = _parser(commands, "trust", "use this course from now on, in its folder and below")
    trust.set_defaults(command=_trust)
    trust.add_argument("folder", type=Path, nargs="?", default=Path(), metavar="DIR", help="default: this folder")
    return trust


def _trust(arguments: argparse.Namespace) -> int:
    from tam570_grader.course import course_config

    course_config.trust(arguments.folder)
    return 0


def _stubs(arguments: argparse.Namespace) -> int:
    from tam570_grader.course import course_config
    from tam570_grader.release import stubs

    if arguments.examples is not None:
        from tam570_grader.release import examples

        return examples.write(course_config.course_of(arguments.root), arguments.examples)
    return stubs.run(course_config.course_of(arguments.root), check=arguments.check)


def _kit(arguments: argparse.Namespace) -> int:
    from tam570_grader.course import course_config
    from tam570_grader.release import kit

    return kit.run(course_config.course_of(arguments.root), arguments.folder)


def _course(arguments: argparse.Namespace) -> int:
    from tam570_grader.nbgrader import course

    return course.run(*_course_and_slugs(arguments))


def _gradescope(arguments: argparse.Namespace) -> int:
    from tam570_grader.gradescope import autograder

    return autograder.run(*_course_and_slugs(arguments))


def _course_and_slugs(arguments: argparse.Namespace) -> tuple[Path, Path, list[str]]:
    """Return the checkout, the folder to write to, the assignments."""
    from tam570_grader.checks import assignments
    from tam570_grader.course import course_config

    course = course_config.course_of(arguments.root)
    return course, arguments.folder, assignments.match_slugs(arguments.assignments, assignments.slugs(course))
