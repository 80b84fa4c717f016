"""What a download holds, read with care: no path leads out of it, no link is followed, no bomb goes off."""

import io
import os
import stat
import zipfile
from collections.abc import Iterator
from dataclasses import dataclass, replace
from datetime import datetime
from functools import partial
from pathlib import Path

from tam570_grader.errors import UsageError, printable
from tam570_grader.grading.submissions import LARGEST, WORK

__all__ = ["File", "inside", "members"]

MOST = 100_000  # files in a download
MOST_INSIDE = 1000  # files in a student's own zip file
MOST_UNPACKED = 2 * LARGEST  # bytes of all work in it: every student's is held until all are read
METHODS = (zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED)  # the others unpack a piece whole, however large it becomes
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
            yield from map(partial(_member, archive), _files(archive, MOST, str(source)))
    except (OSError, ValueError, NotImplementedError, zipfile.BadZipFile) as error:
        raise UsageError(
            f"cannot read {source} as a zip file: {error}; download it again, or name its folder"
        ) from None


def inside(packed: File) -> list[File]:
    """The work in a student's own zip file; one file without a path that says why where it cannot be read."""
    try:
        with zipfile.ZipFile(io.BytesIO(packed.data)) as archive:
            infos = [one for one in _files(archive, MOST_INSIDE, packed.path) if one.filename.endswith(WORK)]
            if sum(one.file_size for one in infos) > MOST_UNPACKED:
                raise UsageError(f"its modules and notebooks have more than {MOST_UNPACKED // 2**20} MiB together")
            return [replace(one, path=printable(one.path)) for one in map(partial(_member, archive), infos)]
    except Exception as error:  # zipfile raises many kinds, those of its parts among them
        return [File("", b"", packed.when, f"it cannot be unpacked: {error}")]


def _files(archive: zipfile.ZipFile, most: int, name: str) -> list[zipfile.ZipInfo]:
    infos = [one for one in archive.infolist() if not one.is_dir() and not set(one.filename.split("/")) & {*SYSTEMS}]
    if len(infos) > most:
        raise UsageError(f"{name} holds more than {most} files: is it the right one?")
    return infos


def _member(archive: zipfile.ZipFile, info: zipfile.ZipInfo) -> File:
    """One file, of which no more is ever unpacked than may be handed in, or than the zip file says it has."""
    when = _when(info)
    parts = info.filename.replace("\\", "/").split("/")
    if info.filename.startswith("/") or ".." in parts:
        return File(info.filename, b"", when, "its path leads out of the zip file")
    if stat.S_ISLNK(info.external_attr >> 16):
        return File(info.filename, b"", when, "it is a link")
    if info.compress_type not in METHODS:
        return File(info.filename, b"", when, "it cannot be unpacked: make the zip file with the system's own program")
    try:
        with archive.open(info) as file:
            return _checked(info.filename, file.read(min(info.file_size, LARGEST) + 1), when)
    except Exception as error:  # as above
        return File(info.filename, b"", when, f"it cannot be unpacked: {error}")


def _when(info: zipfile.ZipInfo) -> datetime | None:
    """When it was changed; a zip file may tell no date, or one that does not exist."""
    try:
        return datetime(*info.date_time) if info.date_time > (1980, 1, 1, 0, 0, 0) else None
    except ValueError:
        return None


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
