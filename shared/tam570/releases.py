"""A student's copy of an assignment: start it, and update it to a new kit without losing work."""

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
    """Files of an assignment that were copied, updated or kept in the folder `work`."""

    work: Path
    new: Sequence[str]
    refreshed: Sequence[str] = ()
    differing: Sequence[str] = ()  # kept, and not as in this kit
    signatures: Sequence[str] = ()  # in this kit, of functions with other parameters in the student's file


def start(name: str, where: Path, *, notebook: bool = False) -> Copied:
    """Copy an assignment into a folder of its name in `where`; keep the files that exist."""
    slug = folder(name, or_lecture=True).name
    work = where / slug
    work.mkdir(parents=True, exist_ok=True)
    new = [path for path in released(slug, notebook) if not (work / path.name).exists()]
    for path in new:
        _copy(path, work)
    return Copied(work, [path.name for path in new], differing=differing(work, slug))


def update(work: Path, slug: str) -> Copied:
    """Replace the files that the student has not changed by this kit's; keep the others and list them."""
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
    """Return the names of the files, other than the student's work, that differ from this kit's."""
    common = [path for path in released(slug, True) if path.stem != slug and (work / path.name).exists()]
    return [path.name for path in common if digest(work / path.name) != digest(path)]


def released(slug: str, notebook: bool) -> list[Path]:
    """Return the files of an assignment that a student gets; with `notebook`, also those of the notebook form."""
    files = [path for path in folder(slug).iterdir() if path.is_file() and path.name not in KEPT_BACK]
    more = (folder(slug) / "notebook").glob("*.*") if notebook else []
    return sorted([*files, *more], key=lambda path: path.name)


def _signatures(mine: Path, slug: str) -> list[str]:
    """Return this kit's signatures of the functions that the student's file lacks or has with other parameters."""
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
    draft = work / f"{path.name}.part"  # on a full disk, the file would be empty and count as the student's
    try:
        shutil.copyfile(path, draft)
        draft.replace(work / path.name)
    finally:
        draft.unlink(missing_ok=True)
    copied = record(work / RECORD) | {path.name: digest(path)}
    (work / RECORD).write_text(json.dumps(copied, indent=1), encoding="utf-8")


def record(path: Path) -> Json:
    """Return the JSON object in a file; empty if the file cannot be read."""
    try:
        data = json.loads(path.read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return {}
    return data if isinstance(data, dict) else {}


def digest(path: Path) -> str:
    """Return the SHA-256 digest of a file, in hexadecimal."""
    return hashlib.sha256(path.read_bytes()).hexdigest()
