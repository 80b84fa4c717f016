"""Write submissions for tools that find shared code: with numbers for names, notebooks as modules, the stub as base.

Dolos: "Adding metadata" (its documentation): `info.csv` lists the files, `--ignore` names the base. JPlag: its README:
a folder for each submission, `-bc` for the base code. Moss: its script: `-d` for folders, `-b` for the base file.
"""

import random
import shutil
from collections import defaultdict
from collections.abc import Callable, Iterable, Sequence
from pathlib import Path

from tam570_grader.errors import UsageError, say, warn, writing
from tam570_grader.grading.submissions import CannotRead, Submission, read, submissions
from tam570_grader.results.tables import write_table
from tam570_grader.sandbox.notebooks import Unshown, python_of

NAMES = "names.csv"
COMMANDS = {
    "dolos": "dolos run -l python --ignore base/{slug}.py info.csv",
    "jplag": "java -jar jplag.jar -l python3 -bc base submissions",
    "moss": "moss -l python -d -b base/{slug}.py submissions/*/{slug}.py",
}


def run(
    course: Path, paths: Sequence[Path], tool: str, out: Path, slugs: Sequence[str], slug_given: str | None = None
) -> int:
    """Write a folder for each assignment, and the table of names; return 1 if a submission could not be read.

    A folder contains `submissions/<number>/<slug>.py`, and the stub in `base/`.
    """
    everything = submissions(paths, slugs, slug_given)
    if out.exists() and (not out.is_dir() or any(out.iterdir())):
        raise UsageError(f"cannot write to {out}: it is not an empty folder; name a new one, for its numbers are new")
    students = sorted({submission.student for submission in everything})
    order = random.SystemRandom().sample(range(1, len(students) + 1), len(students))  # reveals no name
    numbers = {student: f"s{number:04}" for student, number in zip(students, order, strict=True)}
    texts, unread = texts_of(everything)
    with writing(out):
        out.mkdir(parents=True, exist_ok=True)
        names = sorted((number, student) for student, number in numbers.items())
        write_table(out / NAMES, [("number", "student"), *names])
        (out / NAMES).chmod(0o600)  # for the instructor alone
        for slug, modules in sorted(texts.items()):
            folder = out / slug
            (folder / "base").mkdir(parents=True)
            shutil.copyfile(course / "assignments" / slug / f"{slug}.py", folder / "base" / f"{slug}.py")
            for who, text in modules.items():
                target = folder / "submissions" / numbers[who]
                target.mkdir(parents=True)
                (target / f"{slug}.py").write_text(text, encoding="utf-8")
            if tool == "dolos":
                rows = [
                    (f"submissions/{number}/{slug}.py", number) for number in sorted(numbers[who] for who in modules)
                ]
                write_table(folder / "info.csv", [("filename", "full_name"), *rows])
            say(f"cd {out / slug} && {COMMANDS[tool].format(slug=slug)}")
    return 1 if unread else 0


def texts_of(
    everything: Iterable[Submission], form: Callable[[str], str] = str
) -> tuple[dict[str, dict[str, str]], list[str]]:
    """Return form(text) of each submission by assignment and student, and the unreadable ones, with a warning each."""
    texts: dict[str, dict[str, str]] = defaultdict(dict)
    unread = []
    for submission in everything:
        try:
            texts[submission.slug][submission.student] = form(code(submission))
        except (CannotRead, Unshown) as error:
            unread.append(f"{submission.student} {submission.slug}")
            warn(f"{unread[-1]} is left out: {error}")
    return texts, unread


def code(submission: Submission) -> str:
    """Return the code of a submission: a module's text, or the Python code of a notebook's cells in order."""
    if submission.path is None:
        raise CannotRead(submission.reason)
    source = read(submission)
    if not source.notebook:
        return source.text.decode("utf-8", "replace")
    return python_of(source.text) + "\n"
