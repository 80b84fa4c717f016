"""Find submissions and read them safely: outside the sandbox, a submission is only data."""

import collections
import functools
import hashlib
import itertools
import os
import re
import stat
import unicodedata
from collections.abc import Callable, Collection, Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING

from tam570.notebooks import LARGEST, LARGEST_WITH_OUTPUTS, without_outputs
from tam570_grader.checks.assignments import slug_of
from tam570_grader.errors import UsageError, printable
from tam570_grader.results.collected import form, is_zip
from tam570_grader.sandbox.student import Source

if TYPE_CHECKING:
    from tam570_grader.grading.archives import File

LONGEST_NAME = 255  # bytes in the name of a file
MOST_KEPT = 40  # characters kept of an id that cannot name a folder
NO_NAME = '/\\<>:"|?*'  # characters that some operating system forbids in names of folders
HIDDEN = re.compile(r"^(?:[.-]|__)[._-]*")  # prefixes that hide a folder, or make its name look like an option
MOST_FILES = 1000  # in the folder of a student or of an assignment
DEFINED = re.compile(rb'(?:^|"|\\n)def ', re.MULTILINE)  # a function in a module or notebook
UNWRITTEN = re.compile(rb'["\':][\s\\n",]*raise NotImplementedError')  # after a signature or docstring
GIVEN = re.compile(r"test_.*|lab|conftest")  # modules that come with the assignments
HANDIN = "_handin"  # the end of the name of an archive of `tam570 handin`
FEEDBACK = "-feedback.html"  # the end of the name of a page that `watch` puts beside the work
DEEPEST = 4  # levels of nested folders that are searched for a student's work
MOST_NAMES = 10  # names of files listed in a message


class BadPath(UsageError):
    """A path on the command line contains no submission, or cannot be read; the message names the remedy."""


class CannotRead(Exception):
    """A submission cannot be read; the message is for the student."""


@dataclass(frozen=True)
class Submission:
    """One student's work on one assignment; `reason` says why there is none, or why it cannot be read."""

    student: str
    slug: str
    path: Path | None
    tree: Path  # the student's own folder or file; links must not lead out of it
    reason: str = ""

    @property
    def key(self) -> tuple[str, str]:
        return self.student, self.slug


def submissions(
    paths: Iterable[Path], slugs: Sequence[str], slug: str | None = None, students: Collection[str] = ()
) -> list[Submission]:
    """Return all submissions at these paths: modules, notebooks, zip files, folders or trees `<student>/<assignment>/`.

    slugs    : the course's assignments
    slug     : the assignment, if the names of files do not tell
    students : names of students' folders, from a roster; without them, the structure of a tree decides
    """
    work: list[Submission] = []
    for path in paths:
        if not path.exists():
            raise BadPath(f"{path} does not exist")
        here = [_of_file(path, slugs, slug)] if path.is_file() else _in_folder(path.absolute(), slugs, slug, students)
        if not here:
            raise BadPath(f"{path} holds no submission: there is no folder or file named like {slugs[0][:4]} in it")
        work += here
    return _told_apart(work)


def handed_in(folder: Path, slug: str) -> Submission:
    """Return one student's work on one assignment: begun, then named after it, then unpacked, then the shallowest."""
    tree, deeper = folder.resolve(), [folder.absolute()]
    first = of_folder(deeper[0], folder.name, slug, tree)
    candidates = [first]
    for _ in range(DEEPEST):
        held = [entry for parent in deeper for entry in entries(parent, MOST_FILES)]
        deeper = [entry for entry, is_folder in held if is_folder and not entry.is_symlink()][:MOST_FILES]
        candidates += [of_folder(entry, folder.name, slug, tree) for entry in deeper]

    def rank(submission: Submission) -> tuple[bool, ...]:
        is_lost, is_packed = _rank(submission)
        return is_lost, submission.path is None or not of_name(submission.path.name, [slug]), is_packed

    return min((submission for submission in candidates if submission.path), key=rank, default=first)


def read(submission: Submission) -> Source:
    """Return the submission's text, from a zip file that of the module or notebook in it.

    Raise CannotRead for links that lead out of the submission, devices, huge files and bad zip files.
    """
    assert submission.path is not None
    if submission.reason:
        raise CannotRead(submission.reason)
    name = printable(submission.path.name)
    if is_zip(submission.path.name):
        return _packed_source(submission.slug, name, packed_files(submission))
    if not form(submission.path.name):
        raise CannotRead(f"{name} is neither a module (.py) nor a notebook (.ipynb): unpack it, or rename it")
    notebook = form(submission.path.name) == ".ipynb"
    text = _bytes(submission.path, submission.tree, LARGEST_WITH_OUTPUTS if notebook else LARGEST)
    text = without_outputs(text) if len(text) > LARGEST else text
    if len(text) > LARGEST:
        raise CannotRead(f"{name} is larger than {LARGEST // 2**20} MiB without its outputs: is it the right file?")
    return Source(text, notebook=notebook)


def packed_files(submission: Submission) -> "list[File]":
    """Return the modules, notebooks, drawings and texts in a submission's zip file, also refused ones."""
    assert submission.path is not None
    return _unpacked(printable(submission.path.name), _bytes(submission.path, submission.tree, LARGEST))


@functools.lru_cache(maxsize=1)  # a page of `mark` asks for each drawing
def _unpacked(name: str, data: bytes) -> "list[File]":
    from tam570_grader.grading.archives import File, Quota, unpack_zip  # not at the top: it imports zipfile

    return unpack_zip(File(name, data), Quota())


def _packed_source(slug: str, name: str, files: "Iterable[File]") -> Source:
    """Return the text of the file that fits best in a zip file; of files with the same name, the shallowest."""
    shown = [file for file in files if file.refused or "/." not in file.path]  # without .ipynb_checkpoints
    deepest_first = sorted(shown, key=lambda file: file.path.count("/"), reverse=True)
    held = {Path(Path(file.path).name): file for file in deepest_first}

    def text_of(entry: Path) -> bytes:
        if held[entry].refused:
            raise CannotRead(f"{held[entry].path}: {held[entry].refused}")
        return held[entry].data

    chosen = _best(held, slug, text_of)
    text = text_of(chosen[0]) if len(chosen) == 1 else b""
    if len(chosen) != 1 or is_zip(chosen[0].name):
        raise CannotRead(f"there is no {slug}.py in {name}; it holds {_listed(held) or 'no module or notebook'}")
    return Source(text, notebook=form(chosen[0].name) == ".ipynb")


def _bytes(path: Path, tree: Path, most: int) -> bytes:
    """Return the bytes of a regular file in the folder `tree`; raise CannotRead if it has more than `most`."""
    name = printable(path.name)
    if not _own(path, tree):
        raise CannotRead(f"{name} is a link to a place outside of the submission")
    try:
        with open(os.open(path, os.O_RDONLY | os.O_NONBLOCK), "rb", buffering=0) as file:
            about = os.fstat(file.fileno())
            if not stat.S_ISREG(about.st_mode):
                raise CannotRead(f"{name} is not a regular file")
            text = file.readall() if about.st_size <= most else b""
    except OSError as error:
        raise CannotRead(f"{name} cannot be read: {error.strerror}") from None
    if about.st_size > most:
        raise CannotRead(f"{name} is larger than {most // 2**20} MiB: is it the right file?")
    return text


def source_of(submission: Submission) -> Source | CannotRead:
    """Return the submission's text, or the exception that says why there is none."""
    if submission.path is None:
        return CannotRead(submission.reason)
    try:
        return read(submission)
    except CannotRead as why:
        return why


def _own(path: Path, tree: Path) -> bool:
    """Return whether a path, with links resolved, is in the student's folder; False if that is a link to elsewhere."""
    if _is_plainly_in(str(path), str(tree)):
        return True
    try:
        return path.resolve().is_relative_to(tree.parent.resolve() / tree.name)
    except (OSError, RuntimeError):  # a link to itself
        return False


def _is_plainly_in(path: str, tree: str) -> bool:
    """Return whether a path is inside a folder and contains no link below it: a fast test that most paths pass."""
    below = path.removeprefix(tree)
    first, *names = below.split("/")
    if below == path or first or ".." in names:
        return False
    return not any(map(os.path.islink, itertools.accumulate(names, "{}/{}".format, initial=tree)))


def _of_file(path: Path, slugs: Sequence[str], chosen: str | None) -> Submission:
    if not form(path.name) and not is_zip(path.name):
        raise BadPath(f"{path} is neither a Python module (.py), a notebook (.ipynb) nor a zip file")
    slug = chosen or slug_of(path.stem, slugs) or slug_of(path.absolute().parent.name, slugs)
    if slug is None:
        raise BadPath(f"cannot tell which assignment {path} is: name it with --assignment, one of {', '.join(slugs)}")
    return Submission(_name(path.stem.removesuffix(HANDIN)), slug, path, path.resolve())


def _in_folder(folder: Path, slugs: Sequence[str], chosen: str | None, students: Collection[str]) -> list[Submission]:
    is_students = _name(folder.name) in students
    slug = None if is_students else chosen or slug_of(folder.name, slugs)
    if is_students:
        return list(_of_student(folder, slugs, chosen))
    holds_work = any(form(entry.name) for entry, is_folder in entries(folder) if not is_folder)
    work = [] if slug and holds_work else _trees(folder, slugs, chosen, students)
    return work or ([of_folder(folder, folder.parent.name, slug, folder.resolve())] if slug else [])


def _trees(folder: Path, all_slugs: Sequence[str], chosen: str | None, students: Collection[str]) -> list[Submission]:
    """Return the submissions in a folder with the entries `<student>/`, `<assignment>/` or `<assignment>.py`."""
    work, closed, own_folders = [], {}, collections.defaultdict(list)
    is_class = holds_students(folder, all_slugs, students)
    for entry, is_folder in entries(folder):
        slug = None if is_folder and is_class else _chosen(entry, is_folder, all_slugs, chosen)
        if slug and is_folder:
            own_folders[slug].append(entry)
        elif slug and (form(entry.name) or not is_class):  # a zip file beside students' folders may be the class's
            work.append(Submission(_name(entry.stem.removesuffix(HANDIN)), slug, entry, entry))
        elif is_folder:
            try:
                work += _of_student(entry, all_slugs, chosen)
            except BadPath as unreadable:
                closed[entry] = str(unreadable)
    for slug, each in own_folders.items():
        if len(each) == 1:
            work.append(of_folder(each[0], folder.name, slug, each[0]))
        else:
            work.append(_of_files([(entry, True) for entry in each], folder.name, slug, folder))
    if closed and not work:
        raise BadPath(next(iter(closed.values())))
    slugs = sorted({submission.slug for submission in work})  # assignments that other students handed in
    lost = [Submission(_name(home.name), slug, None, home, why) for home, why in closed.items() for slug in slugs]
    return _best_of_each(work) + lost


def holds_students(folder: Path, slugs: Sequence[str], students: Collection[str]) -> bool:
    """Return whether the folders in a folder are students', not one student's assignments; a login may be hw7.

    The roster decides. Without one, at least as many of them must contain assignments as are only named like one.
    """
    folders = [entry for entry, is_folder in entries(folder) if is_folder]
    if any(_name(entry.name) in students for entry in folders):
        return True
    like = [slug_of(entry.name, slugs) is not None for entry in folders]
    if not any(like):
        return any(_holds_assignments(entry, slugs, files=True) for entry in folders)
    holding = [
        _holds_assignments(entry, slugs, files=not is_like) for entry, is_like in zip(folders, like, strict=True)
    ]
    return any(holding) and sum(holding) >= sum(
        is_like and not holds for is_like, holds in zip(like, holding, strict=True)
    )


def _holds_assignments(folder: Path, slugs: Sequence[str], *, files: bool) -> bool:
    """Return whether a folder contains folders (or, with `files`, also files) named after assignments."""
    try:
        held = entries(folder, MOST_FILES)
    except BadPath:
        return False
    return any((is_folder or files) and _chosen(entry, is_folder, slugs, None) for entry, is_folder in held)


def _of_student(home: Path, slugs: Sequence[str], chosen: str | None) -> Iterator[Submission]:
    """Yield the submissions in a student's folder, which has a folder or files for each assignment."""
    work, messages = collections.defaultdict(list), collections.defaultdict(list)
    held = entries(home, MOST_FILES)
    for entry, is_folder in held:
        if slug := _chosen(entry, is_folder, slugs, chosen):
            work[slug].append((entry, is_folder))
        elif not is_folder and (slug := of_name(entry.name, slugs)):
            messages[slug].append(entry)
    for slug, misnamed in messages.items():  # a single one is reported by `read`
        if slug not in work and chosen in (None, slug):
            message = f"hand in one module or notebook, unpacked; there are {_listed(misnamed)}" if misnamed[1:] else ""
            yield Submission(_name(home.name), slug, misnamed[0], home, message)
    if chosen and not work and not messages and not any(slug_of(entry.name, slugs) for entry, _ in held):
        yield of_folder(home, home.name, chosen, home)
    for slug, own_work in work.items():
        folders = [entry for entry, is_folder in own_work if is_folder]
        candidates = [_of_files(own_work, home.name, slug, home)]
        candidates += [of_folder(folders[0], home.name, slug, home)] if len(folders) == 1 else []
        there = [candidate for candidate in candidates if candidate.path]
        yield min(there, key=_rank) if there[1:] else (there or candidates)[-1]


def entries(folder: Path, most: int | None = None) -> list[tuple[Path, bool]]:
    """Return a folder's visible entries without our pages, with whether each is a folder; BadPath if over `most`."""
    try:
        os.stat(os.path.join(folder, "."))  # a folder may be listable although its files cannot be opened
        with os.scandir(folder) as listed:
            held = {  # os.path.isdir returns False for a link to itself; entry.is_dir raises
                entry.name: os.path.isdir(entry) if entry.is_symlink() else entry.is_dir()
                for entry in itertools.islice(listed, most and most + 1)
            }
    except OSError as error:
        raise BadPath(f"{printable(str(folder))} cannot be read: {error.strerror}; who owns it?") from None
    if most and len(held) > most:
        raise BadPath(f"{printable(folder.name)} holds more than {most} files: hand in the module or notebook alone")
    shown = [name for name in sorted(held) if not name.startswith((".", "__")) and not name.endswith(FEEDBACK)]
    return [(folder / name, held[name]) for name in shown]


def _name(text: str) -> str:
    """Return a student's name from that of a folder or file: printable, and different for different names."""
    return _shortened(printable(unicodedata.normalize("NFC", text).replace("\\", "\\\\")))


def folder_of(student: str) -> str:
    """Return the name of the folder for a student's id: the id itself if possible, different for different ids."""
    student = unicodedata.normalize("NFC", student)
    plain = "".join(c if c.isprintable() and c not in NO_NAME else "_" for c in student)
    plain = HIDDEN.sub("_", plain) or "_"
    return _shortened(plain if plain == student else f"{plain[:MOST_KEPT]}-{_mark(student)}")


def _shortened(name: str) -> str:
    """Return a name, cut to the length that a file's name may have."""
    if len(name.encode()) <= LONGEST_NAME:
        return name
    suffix = _mark(name)
    return f"{name.encode()[: LONGEST_NAME - 1 - len(suffix)].decode(errors='ignore')}-{suffix}"


def _mark(name: str) -> str:
    """Return a short hash that distinguishes names with the same beginning."""
    return hashlib.sha256(name.encode(errors="surrogatepass")).hexdigest()[:12]


def _chosen(entry: Path, is_folder: bool, slugs: Sequence[str], chosen: str | None) -> str | None:
    """Return the assignment after which a folder, module, notebook or zip file is named; None if not the chosen one."""
    name_of = slug_of if is_folder else of_name
    slug = name_of(entry.name, slugs) if is_folder or form(entry.name) or is_zip(entry.name) else None
    return slug if chosen in (None, slug) else None


def of_name(name: str, slugs: Sequence[str]) -> str | None:
    """Return the assignment after which a file is named, by number or title: hw08.py, hw08.py.txt, axis_angle-2.py."""
    stem = name.split(".")[0]
    titles = (slug for slug in slugs if re.fullmatch(rf"{slug[5:]}(?:[ _-]?\(?\d+\)?)?", stem, re.IGNORECASE))
    return slug_of(name, slugs) or next(titles, None)


def of_folder(folder: Path, student: str, slug: str, tree: Path) -> Submission:
    """Return the submission in a student's folder of one assignment; if there is none, its `reason` says why."""
    try:
        if _own(folder, tree):
            return _of_files(entries(folder, MOST_FILES), student, slug, tree)
        message = f"{printable(folder.name)} is a link to a place outside of the submission"
    except BadPath as unreadable:
        message = str(unreadable)
    return Submission(_name(student), slug, None, tree, message)


def _of_files(held: Sequence[tuple[Path, bool]], student: str, slug: str, tree: Path) -> Submission:
    """Return the submission among these entries: the only file that fits best; without it, `reason` lists them."""
    files = [entry for entry, is_folder in held if not is_folder]
    chosen = _best(files, slug, lambda entry: read(Submission("", slug, entry, tree)).text)
    if len(chosen) == 1:
        return Submission(_name(student), slug, chosen[0], tree)
    message = f"there is no {slug}.py in the folder; it holds {_listed(entry for entry, _ in held) or 'no file'}"
    return Submission(_name(student), slug, None, tree, message)


def _best(held: Collection[Path], slug: str, text_of: Callable[[Path], bytes]) -> list[Path]:
    """Return the files that fit an assignment best; a zip file fits only without begun work beside it."""
    files = [entry for entry in held if form(entry.name)]
    candidates = [entry for entry in files if entry.name != f"{slug}.py" and slug_of(entry.stem, [slug])]
    if len(candidates) == 1 or f"{slug}.ipynb" in {entry.name for entry in candidates}:
        files = [entry for entry in files if entry.name != f"{slug}.py" or not _untouched(entry, candidates, text_of)]
    fits: tuple[Callable[[Path], bool], ...] = (
        lambda entry: entry.name == f"{slug}.py",
        lambda entry: entry.name == f"{slug}.ipynb",
        lambda entry: form(entry.name) == ".py" and bool(slug_of(entry.stem, [slug])),
        lambda entry: form(entry.name) == ".ipynb" and bool(slug_of(entry.stem, [slug])),
        lambda entry: form(entry.name) == ".ipynb",
        lambda entry: form(entry.name) == ".py" and not GIVEN.fullmatch(entry.stem),
    )
    chosen = next(filter(None, ([*filter(is_chosen, files)] for is_chosen in fits)), [])
    packed = [entry for entry in held if is_zip(entry.name)]
    packed = [entry for entry in packed if slug_of(entry.stem, [slug])] or packed
    is_in_zip = len(chosen) == 1 and _untouched(chosen[0], packed, text_of)
    return packed if is_in_zip else chosen or packed


def _listed(files: Iterable[Path]) -> str:
    """Return the names of the first files, and the number of the others, as text."""
    seen = [printable(entry.name[:80]) for entry in files]
    seen[MOST_NAMES:] = [f"{len(seen) - MOST_NAMES} more"] if len(seen) > MOST_NAMES else []
    return ", ".join(seen)


def _untouched(file: Path, others: Iterable[Path], text_of: Callable[[Path], bytes]) -> bool:
    """Return whether no function of a file is begun, and one of these other files is."""
    try:
        return not is_begun(text_of(file)) and any(is_begun(text_of(entry)) for entry in others)
    except CannotRead:
        return False


def is_begun(text: bytes) -> bool:
    """Return whether a module or notebook has a function that is not as in the stub."""
    return len(UNWRITTEN.findall(text)) < len(DEFINED.findall(text))


def _rank(submission: Submission) -> tuple[bool, bool]:
    """Return a key, smallest for the best file of a student: begun ones first, zip files last."""
    source = source_of(submission)
    is_lost = isinstance(source, CannotRead) or not is_begun(source.text)
    return is_lost, submission.path is not None and is_zip(submission.path.name)


def _best_of_each(work: list[Submission]) -> list[Submission]:
    """Return the submissions; of a student's module, notebook and zip file of the same name, only the best."""

    def rank(submission: Submission) -> tuple[bool, ...]:
        return *_rank(submission), submission.path is not None and form(submission.path.name) != ".py"

    rivals = collections.defaultdict(list)
    for submission in work:
        rivals[submission.key if submission.path else None].append(submission)
    best = {key: min(map(rank, files)) for key, files in rivals.items() if key and files[1:]}
    return [each for each in work if each.path is None or each.key not in best or rank(each) == best[each.key]]


def _told_apart(work: list[Submission]) -> list[Submission]:
    """Return the submissions; those with equal names, as `a/hw07.py` and `b/hw07.py`, get their folders' names."""
    count = collections.Counter(submission.key for submission in work)
    renamed = [
        replace(submission, student=_shortened(f"{_name(submission.path.absolute().parent.name)}-{submission.student}"))
        if submission.path and count[submission.key] > 1
        else submission
        for submission in work
    ]
    for (student, slug), n in collections.Counter(submission.key for submission in renamed).items():
        if n > 1:
            raise BadPath(f"two submissions of {slug} by {student}: give each student a folder of their own")
    return renamed
