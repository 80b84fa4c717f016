"""Find the student's files that a command means, from its argument and the current folder."""

from collections.abc import Iterator
from pathlib import Path

from tam570.course import Unknown, assignments, folder, slug_of, stubs
from tam570.loading import SUFFIXES

Work = tuple[Path, str]  # a file and its assignment


def chosen(what: str | None, assignment: str | None = None, or_lecture: bool = False) -> list[Work]:
    """Return the files that a command's argument names: a file, a folder, or an assignment. None names all here.

    Raise Unknown if there are none; the message says what to do.
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
    """Return the only file that is named. Raise Unknown if there are none or several."""
    matches = chosen(what, assignment, or_lecture=True)  # `show` also takes lectures
    if len(matches) > 1:
        raise Unknown(f"say which assignment: {', '.join(slug[:4] for _, slug in matches)}")
    return matches[0]


def here() -> list[Work]:
    """Return the work in the current folder or those above it, up to the course's; else all in assignments' folders."""
    for directory in _places():
        matches = [(file, slug) for slug in assignments() if (file := _beside(directory, slug))]
        if matches:
            return matches
    return [(file, slug) for slug in assignments() if (file := work_of(slug))]


def work_of(slug: str) -> Path | None:
    """Return the student's file of an assignment, in a folder of its name or directly, here or above; None if none."""
    return next((file for directory in _places() if (file := _in(directory, slug))), None)


def beside() -> Path:
    """Return the folder for a new assignment: the current one or, in an assignment's folder, the parent of that."""
    assignments_above = [parent for parent in (Path.cwd(), *Path.cwd().parents) if parent.name in assignments()]
    return assignments_above[0].parent if assignments_above else Path()


def _places() -> Iterator[Path]:
    """Yield the current folder and, inside an assignment's folder, those above it, up to the parent of that folder."""
    yield Path()
    top = beside()
    if top != Path():
        yield from (parent for parent in Path.cwd().parents if parent.is_relative_to(top))


def _in(directory: Path, slug: str) -> Path | None:
    return _beside(directory / slug, slug) or _beside(directory, slug)


def _beside(directory: Path, slug: str) -> Path | None:
    """Return the module in a folder, or the notebook if there is no module or it is empty; None if there is neither."""
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
