"""Read downloads and zip files safely: no path leads out of them, no link is followed, and sizes are limited."""

import io
import os
import re
import stat
import zipfile
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path

from tam570.handin import WRITTEN
from tam570.notebooks import LARGEST, LARGEST_WITH_OUTPUTS, without_outputs
from tam570_grader.errors import UsageError, printable
from tam570_grader.results.collected import form, is_zip

MOST = 100_000  # files in a download
MOST_INSIDE = 1000  # files of a student, including those in the student's zip files
MOST_UNPACKED = 2 * LARGEST  # bytes of a student's work; the whole class is in memory until all is read
METADATA, LARGEST_METADATA = "submission_metadata.yml", 200 * 2**20  # Gradescope's table, bytes; it has all outputs
LONGEST_PATH = 1000  # characters
ENTRY = 46  # bytes, least size of a file's entry in a zip file's directory
METHODS = (zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED)  # decompressors of other methods have no size limit
# files and folders that operating systems, editors and Brightspace add: .DS_Store, .ipynb_checkpoints, .venv, ._hw08.py
JUNK = re.compile(r"__MACOSX|__pycache__|index\.html|\._.*|\.[A-Za-z]\w{0,17}", re.DOTALL)


@dataclass(frozen=True)
class File:
    """A file of a download: its path there, and its bytes or the reason why it is refused."""

    path: str
    data: bytes
    refused: str = ""


@dataclass
class Quota:
    """The files and bytes that a student may still hand in, over all of the student's files and zip files."""

    files: int = MOST_INSIDE
    data: int = MOST_UNPACKED

    def takes(self, files: Sequence[zipfile.ZipInfo | File]) -> str:
        """Subtract these files from the quota and return "", or return why they exceed it."""
        sizes = (len(file.data) if isinstance(file, File) else file.file_size for file in files)
        size = sum(min(size, LARGEST) for size in sizes)  # larger notebooks are stored without their outputs
        if len(files) > self.files:
            return f"the student handed in more than {MOST_INSIDE} files"
        if size > self.data:
            return f"the student's modules and notebooks have more than {MOST_UNPACKED // 2**20} MiB together"
        self.files -= len(files)
        self.data -= size
        return ""


def members(source: Path) -> Iterator[File]:
    """Yield all files of a zip file or a folder, including refused ones."""
    if source.is_dir():
        # without links and devices
        paths = [
            Path(folder) / name
            for folder, _, names in os.walk(source)
            for name in names
            if not _is_junk(os.path.join(os.path.relpath(folder, source), name))
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


def unpack_zip(packed: File, quota: Quota, *, nested: bool = False) -> list[File]:
    """Return the work in a student's zip file, with paths below its path; if it cannot be read, one refused file.

    nested : it was in another zip file (a student may pack the output of `tam570 handin`), so open no third one
    """
    try:
        # the size of the directory, which may be too slow to read; private: zipfile alone knows which record it reads
        end = zipfile._EndRecData(io.BytesIO(packed.data))  # type: ignore[attr-defined]
        if end and end[zipfile._ECD_SIZE] > MOST_INSIDE * (ENTRY + LONGEST_PATH):  # type: ignore[attr-defined]
            raise UsageError(f"it holds more than {MOST_INSIDE} files")
        with zipfile.ZipFile(io.BytesIO(packed.data)) as archive:
            for info in archive.infolist():  # some programs on Windows separate names by backslashes
                info.filename = info.filename.replace("\\", "/")
            infos = [
                file
                for file in _files(archive, MOST_INSIDE, "it")
                if form(file.filename) or is_beside(file.filename) or is_zip(file.filename)
            ]
            if full := quota.takes(infos):
                raise UsageError(full)
            members = map(partial(_member, archive), infos)
            held = [replace(file, path=f"{packed.path}/{printable(file.path)}") for file in members]
    except Exception as error:  # zipfile and its decompressors raise many types
        return [File(packed.path, b"", f"it cannot be unpacked: {shortened(str(error))}")]
    work = list[File]()
    for file in held:
        is_opened = is_zip(file.path) and not (file.refused or nested)
        work += unpack_zip(file, quota, nested=True) if is_opened else [file]
    return work


def is_beside(name: str) -> bool:
    """Return whether a file is a drawing or text that belongs to the work, by the ending of its name."""
    return name.lower().endswith(WRITTEN)


def shortened(text: str) -> str:
    """Return a text, or its beginning if it is longer than LONGEST_PATH."""
    return text if len(text) <= LONGEST_PATH else f"{text[: LONGEST_PATH // 5]}..."


def _files(archive: zipfile.ZipFile, most: int, name: str) -> list[zipfile.ZipInfo]:
    infos = [info for info in archive.infolist() if not info.is_dir() and not _is_junk(info.filename)]
    if len(infos) > most:
        raise UsageError(f"{name} holds more than {most} files: is it the right one?")
    return infos


def _is_junk(path: str) -> bool:
    return any(map(JUNK.fullmatch, path.split("/")))


def _member(archive: zipfile.ZipFile, info: zipfile.ZipInfo) -> File:
    """Return a file of a zip file; unpack at most the size that is allowed or that the zip file states."""
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
    except Exception as error:  # as in `unpack_zip`
        return File(info.filename, b"", f"it cannot be unpacked: {shortened(str(error))}")


def _most(name: str) -> int:
    """Return how many bytes a file may have; METADATA below a folder `submission_...` is a student's file."""
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
