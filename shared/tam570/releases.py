"""A student's copy of an assignment: how it is started, and how it follows a new kit without losing work."""

import hashlib
import json
import shutil
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from tam570.course import folder, stubs
from tam570.values import Json

KEPT_BACK = ("contract.json", "examples.json", "hints.toml", "rubric.toml")  # used by the commands, not copied
RECORD = ".tam570.json"  # in the student's folder: the digest of each file as it was copied


@dataclass(frozen=True)
class Copied:
    """What became of the files of an assignment."""

    work: Path
    new: Sequence[str]
    refreshed: Sequence[str] = ()
    differing: Sequence[str] = ()  # changed here, and not as this kit has them
    signatures: Sequence[str] = ()  # of functions that this kit has otherwise than the student's file


def start(name: str, where: Path, *, notebook: bool = False) -> Copied:
    """Copy an assignment to a folder of its name in `where`; what is there already stays as it is."""
    slug = folder(name, or_lecture=True).name
    work = where / slug
    work.mkdir(parents=True, exist_ok=True)
    new = [path for path in released(slug, notebook) if not (work / path.name).exists()]
    for path in new:
        _copy(path, work)
    return Copied(work, [path.name for path in new], differing=differing(work, slug))


def update(work: Path, slug: str) -> Copied:
    """Bring the files that the student has not changed to this kit's; the others stay, and are named."""
    copied, refreshed, new = record(work / RECORD), [], []
    notebook = (work / f"{slug}.ipynb").exists()
    for path in released(slug, notebook):
        mine = work / path.name
        if not mine.exists():
            new.append(path.name)
        elif digest(mine) == digest(path) or digest(mine) != copied.get(path.name):
            continue
        else:
            refreshed.append(path.name)
        _copy(path, work)
    return Copied(work, new, refreshed, differing(work, slug), _signatures(work / f"{slug}.py", slug))


def differing(work: Path, slug: str) -> list[str]:
    """Return the files beside the student's own that are not as this kit has them."""
    common = [path for path in released(slug, True) if path.stem != slug and (work / path.name).exists()]
    return [path.name for path in common if digest(work / path.name) != digest(path)]


def released(slug: str, notebook: bool) -> list[Path]:
    """Return the files of an assignment for a student; those of the notebook form only if it is asked for."""
    files = [path for path in folder(slug).iterdir() if path.is_file() and path.name not in KEPT_BACK]
    more = (folder(slug) / "notebook").glob("*.*") if notebook else []
    return sorted([*files, *more], key=lambda path: path.name)


def _signatures(mine: Path, slug: str) -> list[str]:
    """Return the functions as this kit asks for them, where the student's file has other parameters."""
    try:
        have = stubs(mine.read_bytes())
    except (OSError, SyntaxError, ValueError):
        return []
    signatures = []
    for name, expected in stubs((folder(slug) / f"{slug}.py").read_bytes()).items():
        there, keywords = have.get(name), ["*", *expected.keywords] if expected.keywords else []
        same = there and (expected.positions, {*expected.keywords}) == (there.positions, {*there.keywords})
        if not (there and (same or there.takes_any)):
            signatures.append(f"{name}({', '.join([*expected.positions, *keywords])})")
    return signatures


def _copy(path: Path, work: Path) -> None:
    shutil.copyfile(path, work / path.name)
    copied = record(work / RECORD) | {path.name: digest(path)}
    (work / RECORD).write_text(json.dumps(copied, indent=1), encoding="utf-8")


def record(path: Path) -> Json:
    """Return what was remembered in a file; nothing where it cannot be read."""
    try:
        data = json.loads(path.read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return {}
    return data if isinstance(data, dict) else {}


def digest(path: Path) -> str:
    """Return what tells the content of a file from any other."""
    return hashlib.sha256(path.read_bytes()).hexdigest()
