"""Which of a student's files a command means, wherever it is given: in the folder, above it, or by a path."""

from collections.abc import Iterator
from pathlib import Path

from tam570.course import Unknown, assignments, folder, slug_of, stubs
from tam570.loading import SUFFIXES

Work = tuple[Path, str]  # a file and its assignment


def chosen(what: str | None, assignment: str | None = None, or_lecture: bool = False) -> list[Work]:
    """Return the files that a word on the command line stands for: a file, a folder, or an assignment.

    All here if None.

    Unknown where there are none; the message says what to do.
    """
    if what is None:
        return here() or _nothing("nothing is", "hw01")
    path = Path(what)
    if path.is_file():
        if path.suffix not in SUFFIXES:
            raise Unknown(f"{what} is neither a Python module (.py) nor a notebook (.ipynb)")
        return [(path, folder(assignment).name if assignment else slug_of(path))]
    if path.is_dir():
        slugs = [folder(assignment).name] if assignment else assignments()
        matches = [(file, slug) for slug in slugs if (file := _in(path, slug))]
        return matches or _nothing(f"{what} holds no work: nothing is", "hw01")
    if path.suffix or len(path.parts) > 1:
        raise Unknown(f"there is no file {what}")
    slug = folder(what, or_lecture).name
    file = work_of(slug)
    return [(file, slug)] if file else _nothing(f"{what} is not", slug[:4])


def single(what: str | None, assignment: str | None = None) -> Work:
    """Return the only file that is meant. Unknown if there are several."""
    matches = chosen(what, assignment, or_lecture=True)  # only `show` asks for one by name
    if len(matches) > 1:
        raise Unknown(f"say which assignment: {', '.join(slug[:4] for _, slug in matches)}")
    return matches[0]


def here() -> list[Work]:
    """Return the work in the folder where the command is given, if it is that of an assignment; else all below it."""
    for directory in _places():
        matches = [(file, slug) for slug in assignments() if (file := _beside(directory, slug))]
        if matches:
            return matches
    return [(file, slug) for slug in assignments() if (file := work_of(slug))]


def work_of(slug: str) -> Path | None:
    """Return the student's file of an assignment: in a folder of its name here or above, or in this folder."""
    return next((file for directory in _places() if (file := _in(directory, slug))), None)


def beside() -> Path:
    """Return where another assignment belongs: this folder, or the one above the assignment's in which we are."""
    assignments_above = [parent for parent in (Path.cwd(), *Path.cwd().parents) if parent.name in assignments()]
    return assignments_above[0].parent if assignments_above else Path()


def _places() -> Iterator[Path]:
    """Yield this folder, and those above as long as one of them is an assignment's."""
    yield Path()
    top = beside()
    if top != Path():
        yield from (parent for parent in Path.cwd().parents if parent.is_relative_to(top))


def _in(directory: Path, slug: str) -> Path | None:
    return _beside(directory / slug, slug) or _beside(directory, slug)


def _beside(directory: Path, slug: str) -> Path | None:
    """Return the module in a folder; the notebook where there is no module, or nothing is written in it."""
    module, notebook = directory / f"{slug}.py", directory / f"{slug}.ipynb"
    if module.is_file() and not (notebook.is_file() and _empty(module) and b"def " in notebook.read_bytes()):
        return module
    return notebook if notebook.is_file() else None


def _empty(module: Path) -> bool:
    """Return whether no function of a module is written."""
    try:
        return not any(stub.written for stub in stubs(module.read_bytes()).values())
    except (SyntaxError, ValueError):
        return False


def _nothing(state: str, first: str) -> list[Work]:
    raise Unknown(f"{state} started here; begin with: tam570 start {first}")
