"""The assignments as students get them: where they are, what they are called, and how to start one."""

import re
import shutil
from pathlib import Path

__all__ = ["Unknown", "assignments", "folder", "start", "title"]


class Unknown(Exception):
    """There is no such assignment, function or file; the message says what there is."""


def assignments() -> list[str]:
    """The names of all assignments, in order."""
    return sorted(path.name for path in _home().glob("hw*") if (path / "README.md").exists())


def folder(name: str) -> Path:
    """The released folder of the assignment that `name` stands for: hw07, hw07_double_pendulum, or a path to it."""
    number = re.match(r"hw\d\d(?!\d)", Path(name).name, re.IGNORECASE)
    for slug in assignments():
        if number and slug.startswith(number[0].lower() + "_"):
            return _home() / slug
    raise Unknown(f"there is no assignment {name!r}; there are: {', '.join(assignments())}")


def title(slug: str) -> str:
    """What the assignment is called: the heading of its README without the number."""
    with open(_home() / slug / "README.md", encoding="utf-8") as file:
        return file.readline().lstrip("# ").partition(": ")[2].strip()


def start(name: str, where: Path) -> tuple[Path, list[str], list[str]]:
    """Copy an assignment to a folder of its name in `where`; the folder, the files copied, those left alone."""
    released = folder(name)
    work = where / released.name
    work.mkdir(parents=True, exist_ok=True)
    copied, kept = [], []
    for path in sorted(released.iterdir()):
        if not path.is_file() or path.name == "hints.toml":
            continue
        if (work / path.name).exists():
            kept.append(path.name)
        else:
            shutil.copyfile(path, work / path.name)
            copied.append(path.name)
    return work, copied, kept


def _home() -> Path:
    """The folder of the assignments: in an installed wheel, else in the checkout."""
    package = Path(__file__).resolve().parent
    installed = package / "assignments"
    return installed if installed.is_dir() else package.parents[1] / "assignments"
