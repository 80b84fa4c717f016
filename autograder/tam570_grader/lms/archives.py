"""What a download holds, read with care: no path leads out of it, no link is followed, no bomb goes off."""

import io
import os
import stat
import zipfile
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path

from tam570.handin import WRITTEN
from tam570.notebooks import LARGEST, LARGEST_WITH_OUTPUTS, without_outputs
from tam570_grader.errors import UsageError, printable
from tam570_grader.results.collected import form

MOST = 100_000  # files in a download
MOST_INSIDE = 1000  # files of a student, in zip files of their own too
MOST_UNPACKED = 2 * LARGEST  # bytes of all work of a student: every student's is held until all are read
METADATA, LARGEST_METADATA = "submission_metadata.yml", 200 * 2**20  # Gradescope's, of bytes: it holds every output
LONGEST_PATH = 1000  # characters
ENTRY = 46  # bytes that a zip file's directory has for a file, at least
METHODS = (zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED)  # the others unpack a piece whole, however large it becomes
JUNK = ("__MACOSX", ".DS_Store")  # what systems put beside the files


@dataclass(frozen=True)
class File:
    """A file of a download: its path there, its bytes, or why it is refused."""

    path: str
    data: bytes
    refused: str = ""


@dataclass
class Quota:
    """What a student may still hand in: zip files within zip files, and many small ones, count together."""

    files: int = MOST_INSIDE
    data: int = MOST_UNPACKED

    def takes(self, files: Sequence[zipfile.ZipInfo | File]) -> str:
        """Reserve room for these files; return why there is too little, or ""."""
        sizes = (len(file.data) if isinstance(file, File) else file.file_size for file in files)
        size = sum(min(size, LARGEST) for size in sizes)  # of a notebook with large outputs no more is held
        if len(files) > self.files:
            return f"the student handed in more than {MOST_INSIDE} files"
        if size > self.data:
            return f"the student's modules and notebooks have more than {MOST_UNPACKED // 2**20} MiB together"
        self.files -= len(files)
        self.data -= size
        return ""


def members(source: Path) -> Iterator[File]:
    """Yield all files of a zip file or a folder, those that are refused, too."""
    if source.is_dir():
        # Links and devices are left out, and what Git keeps for itself.
        paths = [
            Path(folder) / name
            for folder, _, names in os.walk(source)
            for name in names
            if name not in JUNK and "/.git/" not in f"{folder}/"
        ]
        for path in sorted(path for path in paths if stat.S_ISREG(path.lstat().st_mode)):
            name = path.relative_to(source).as_posix()
            with open(path, "rb") as file:
                yield _checked(name, file.read(_most(name) + 1))
        return
    try:
        with zipfile.ZipFile(source) as archive:
            yield from map(partial(_member, archive), _files(archive, MOST, str(source)))
    except (OSError, ValueError, NotImplementedError, zipfile.BadZipFile) as error:
        raise UsageError(
            f"cannot read {source} as a zip file: {error}; download it again, or name its folder"
        ) from None


def unpack_zip(packed: File, quota: Quota) -> list[File]:
    """Return the work in a student's own zip file; one file without a path that says why where it cannot be read."""
    try:
        end = packed.data.rfind(b"PK\5\6")  # tells the directory's size before any of it is read: each entry costs time
        if end >= 0 and int.from_bytes(packed.data[end + 12 : end + 16], "little") > MOST_INSIDE * (
            ENTRY + LONGEST_PATH
        ):
            raise UsageError(f"it holds more than {MOST_INSIDE} files")
        with zipfile.ZipFile(io.BytesIO(packed.data)) as archive:
            infos = [
                file for file in _files(archive, MOST_INSIDE, "it") if form(file.filename) or is_beside(file.filename)
            ]
            if full := quota.takes(infos):
                raise UsageError(full)
            return [replace(file, path=printable(file.path)) for file in map(partial(_member, archive), infos)]
    except Exception as error:  # zipfile raises many kinds, those of its parts among them
        return [File("", b"", f"it cannot be unpacked: {shortened(str(error))}")]


def is_beside(name: str) -> bool:
    """Return whether a file holds drawings or words that go with the work, by its name."""
    return name.lower().endswith(WRITTEN)


def shortened(text: str) -> str:
    """Cut a text to the longest path of a file."""
    return text if len(text) <= LONGEST_PATH else f"{text[: LONGEST_PATH // 5]}..."


def _files(archive: zipfile.ZipFile, most: int, name: str) -> list[zipfile.ZipInfo]:
    infos = [info for info in archive.infolist() if not info.is_dir() and not set(info.filename.split("/")) & {*JUNK}]
    if len(infos) > most:
        raise UsageError(f"{name} holds more than {most} files: is it the right one?")
    return infos


def _member(archive: zipfile.ZipFile, info: zipfile.ZipInfo) -> File:
    """Return one file, unpacked no further than a student may hand in, or than the zip file claims."""
    parts = info.filename.replace("\\", "/").split("/")
    if len(info.filename) > LONGEST_PATH:
        return File(shortened(info.filename), b"", f"its name has more than {LONGEST_PATH} characters")
    if info.filename.startswith("/") or ".." in parts:
        return File(info.filename, b"", "its path leads out of the zip file")
    if stat.S_ISLNK(info.external_attr >> 16):
        return File(info.filename, b"", "it is a link")
    if info.compress_type not in METHODS:
        return File(info.filename, b"", "it cannot be unpacked: make the zip file with the system's own program")
    try:
        with archive.open(info) as file:
            return _checked(info.filename, file.read(min(info.file_size, _most(info.filename)) + 1))
    except Exception as error:  # as above
        return File(info.filename, b"", f"it cannot be unpacked: {shortened(str(error))}")


def _most(name: str) -> int:
    """Return how many bytes a file may have. Below a folder `submission_...` the table's name is a student's own."""
    if name.rsplit("/", 1)[-1] == METADATA and "submission_" not in name.removesuffix(METADATA):
        return LARGEST_METADATA
    return LARGEST_WITH_OUTPUTS if form(name) == ".ipynb" else LARGEST


def _checked(name: str, data: bytes) -> File:
    most = _most(name)
    if most == LARGEST_WITH_OUTPUTS and LARGEST < len(data) <= most:
        data, most = without_outputs(data), LARGEST
    if len(data) > most:
        return File(name, b"", f"it is larger than {most // 2**20} MiB")
    return File(name, data)
