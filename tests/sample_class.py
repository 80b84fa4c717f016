"""Write the submissions of a sample class into nbgrader's layout, for `make demo` and for trying the grader.

    python tests/sample_class.py DIR

Each assignment has correct submissions in several styles, submissions with known mistakes, one that is half done, one
that hangs, one that crashes, and the stub; hw08 also has some of the attacks of `tests/hostile`.
"""

import sys
from collections.abc import Iterator
from pathlib import Path

from tam570_grader.checks import assignments
from tam570_grader.diagnosis.mistakes import overlays
from tam570_grader.release.stubs import stub

TESTS = Path(__file__).parent
REPLACED = """

def _replacement(*args, **kwargs):
    {body}


globals()[__all__[0]] = _replacement
"""
HANGS = REPLACED.format(body="while True: pass")
CRASHES = REPLACED.format(body="__import__('os').abort()")


def sample_class() -> Iterator[tuple[str, str, str]]:
    """Yield (student, assignment, text) of every submission."""
    course = assignments.find()
    for slug in assignments.slugs(course):
        solution = (course / "solutions" / f"{slug}.py").read_text()
        correct = [*assignments.alternatives(course, slug).values()]
        wrong = [*overlays(assignments.checks_folder(course, slug)).values()]
        for student, text in zip(("ada", "ben", "cho"), correct, strict=False):
            yield student, slug, text
        for student, text in zip(("dev", "eli", "fay"), wrong[::3], strict=False):
            yield student, slug, f"{solution}\n\n{text}"
        yield "gus", slug, half_done(solution)
        yield "hal", slug, solution + HANGS
        yield "ida", slug, solution + CRASHES
        yield "kim", slug, stub(solution)
    for path in sorted((TESTS / "hostile").glob("*.py"))[::7]:
        yield f"mallory-{path.stem}", "hw08_axis_angle", path.read_text()


def half_done(solution: str) -> str:
    """Return the solution with the stub's text from its middle function on, which redefines those functions."""
    released = stub(solution)
    names = [line.split("(")[0] for line in released.splitlines() if line.startswith("def ")]
    middle = names[len(names) // 2]
    return solution + "\n\n" + released[released.index(f"{middle}(") :]


if __name__ == "__main__":
    for student, slug, text in sample_class():
        path = Path(sys.argv[1]) / student / slug / f"{slug}.py"
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
