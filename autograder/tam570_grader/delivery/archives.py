"""What a download holds, read with care: no path leads out of it, no link is followed, no bomb goes off."""

import io
import os
import stat
import zipfile
from collections.abc import Iterator
from dataclasses import dataclass
from datetime import datetime
from pathlib import Path

from tam570_grader.errors import UsageError
from tam570_grader.grading.submissions import LARGEST

__all__ = ["File", "inside", "members"]

MOST = 100_000  # files in a download
MOST_INSIDE = 1000  # files in a student's own zip file
SYSTEMS = ("__MACOSX", ".DS_Store")  # what systems put beside the files


@dataclass(frozen=True)
class File:
    """A file of a download: its path there, its bytes, when it was changed, or why it is refused."""

    path: str
    data: bytes
    when: datetime | None
    refused: str = ""


def members(source: Path) -> Iterator[File]:
    """All files of a zip file or a folder, those that are refused, too."""
    if source.is_dir():
        yield from map(lambda path: _of_folder(path, source), _regular(source))
        return
    try:
        with zipfile.ZipFile(source) as archive:
            yield from _of_zip(archive, MOST, str(source))
    except (OSError, zipfile.BadZipFile) as error:
        raise UsageError(
            f"cannot read {source} as a zip file: {error}; download it again, or name its folder"
        ) from None


def inside(packed: File) -> list[File]:
    """What a student's own zip file holds; one file that says why where it cannot be read."""
    try:
        with zipfile.ZipFile(io.BytesIO(packed.data)) as archive:
            return list(_of_zip(archive, MOST_INSIDE, packed.path))
    except (zipfile.BadZipFile, UsageError) as error:
        return [File(packed.path, b"", packed.when, f"it cannot be unpacked: {error}")]


def _of_zip(archive: zipfile.ZipFile, most: int, name: str) -> Iterator[File]:
    infos = [one for one in archive.infolist() if not one.is_dir() and not set(one.filename.split("/")) & {*SYSTEMS}]
    if len(infos) > most:
        raise UsageError(f"{name} holds more than {most} files: is it the right one?")
    for info in infos:
        yield _member(archive, info)


def _member(archive: zipfile.ZipFile, info: zipfile.ZipInfo) -> File:
    """One file, of which no more than what may be handed in is ever unpacked."""
    when = datetime(*info.date_time) if info.date_time > (1980, 1, 1, 0, 0, 0) else None
    parts = info.filename.replace("\\", "/").split("/")
    if info.filename.startswith("/") or ".." in parts:
        return File(info.filename, b"", when, "its path leads out of the zip file")
    if stat.S_ISLNK(info.external_attr >> 16):
        return File(info.filename, b"", when, "it is a link")
    try:
        with archive.open(info) as file:
            return _checked(info.filename, file.read(LARGEST + 1), when)
    except (zipfile.BadZipFile, RuntimeError, NotImplementedError, EOFError, OSError, ValueError) as error:
        return File(info.filename, b"", when, f"it cannot be unpacked: {error}")


def _of_folder(path: Path, source: Path) -> File:
    when = datetime.fromtimestamp(path.lstat().st_mtime).replace(microsecond=0)
    name = path.relative_to(source).as_posix()
    with open(path, "rb") as file:
        return _checked(name, file.read(LARGEST + 1), when)


def _regular(source: Path) -> list[Path]:
    """The regular files below a folder; links and devices are left out."""
    found = [Path(folder) / name for folder, _, names in os.walk(source) for name in names if name not in SYSTEMS]
    return sorted(path for path in found if stat.S_ISREG(path.lstat().st_mode))


def _checked(name: str, data: bytes, when: datetime | None) -> File:
    if len(data) > LARGEST:
        return File(name, b"", when, f"it is larger than {LARGEST // 2**20} MiB")
    return File(name, data, when)
