"""What `tam570 list --lectures`, `tam570 start NAME` and `tam570 show NAME` do with lectures."""

import shutil
from collections.abc import Sequence
from pathlib import Path

from tam570.lectures import catalogue, heading

__all__ = ["is_lecture", "print_list", "show", "start"]


def is_lecture(what: str) -> bool:
    """Return whether a name or a file means a lecture or a copy of one, and not an assignment."""
    return what in catalogue() or Path(what).is_file() and heading(Path(what)) is not None


def print_list() -> int:
    """Print all lectures by date."""
    for lecture in catalogue().values():
        print(f"{lecture.date:<15} {lecture.name:<18} {lecture.title}")
    return 0


def start(name: str, where: Path) -> int:
    """Copy a lecture to `where`, as a file to play with; one that is there already stays. Unknown names are told."""
    from tam570.lectures import load

    copy = where / f"{name}.py"
    if copy.exists():
        print(f"{copy} is there already and stays as it is; see it with: tam570 show {copy}")
        return 0
    source = Path(load(name).__file__ or "")
    where.mkdir(parents=True, exist_ok=True)
    shutil.copyfile(source, copy)
    print(f"{copy}\nChange it as you like and see what it does: tam570 show {copy}")
    return 0


def show(what: str, numbers: Sequence[str], where: Path | None) -> int:
    """Show a lecture, or a copy of one, with other numbers; 0, or 1 if it cannot be shown."""
    from tam570.show import present
    from tam570.show.lecture import filmed, lecture_module, settings

    return present(lambda: filmed(lecture_module(what), settings(numbers)), where, Path(what).stem)
