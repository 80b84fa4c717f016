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
# after a signature or docstring; no character that begins a match may continue it, so that the search is linear
UNWRITTEN = re.compile(rb'["\':][\s\\rn,]*raise NotImplementedError')
COPY = re.compile(r"(.*?)[ _-]*\(?(\d{0,9})\)?", re.DOTALL)  # what a name adds to that of the assignment: words, number
GIVEN = re.compile(r"test_.*|lab|conftest")  # modules that come with the assignments
HANDIN = "_handin"  # the end of the name of an archive of `tam570 handin`
FEEDBACK = "-feedback.html"  # the end of the name of a page that `watch` puts beside the work
DEEPEST = 4  # levels of nested folders that are searched for a student's work
MOST_NAMES = 10  # names of files listed in a message
COUNTS = "The grader read {counts} and not {others}. Tell your teacher if it should read another file."


class BadPath(UsageError):
    """A path on the command line contains no submission, or cannot be read; the message names the remedy."""


class CannotRead(Exception):
    """A submission cannot be read; the message is for the student."""


@dataclass(frozen=True)
class Submission:
    """One student's work on one assignment; `reason` says why there is none, or why it cannot be read.

    others : names of the student's other files that could be the work, with other content
    """

    student: str
    slug: str
    path: Path | None
    tree: Path  # the student's own folder or file; links must not lead out of it
    reason: str = ""
    others: tuple[str, ...] = ()

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
        source = _packed_source(submission.slug, name, packed_files(submission))
        return replace(source, remark=f"{_remark(name, submission.others)} {source.remark}".strip())
    if not form(submission.path.name):
        raise CannotRead(f"{name} is neither a module (.py) nor a notebook (.ipynb): unpack it, or rename it")
    notebook = form(submission.path.name) == ".ipynb"
    text = _bytes(submission.path, submission.tree, LARGEST_WITH_OUTPUTS if notebook else LARGEST)
    text = without_outputs(text) if len(text) > LARGEST else text
    if len(text) > LARGEST:
        raise CannotRead(f"{name} is larger than {LARGEST // 2**20} MiB without its outputs: is it the right file?")
    return Source(text, notebook, _remark(name, submission.others))


def packed_files(submission: Submission) -> "list[File]":
    """Return the modules, notebooks, drawings and texts in a submission's zip file, also refused ones."""
    assert submission.path is not None
    return _unpacked(printable(submission.path.name), _bytes(submission.path, submission.tree, LARGEST))


@functools.lru_cache(maxsize=1)  # a page of `mark` asks for each drawing
def _unpacked(name: str, data: bytes) -> "list[File]":
    from tam570_grader.grading.archives import File, Quota, unpack_zip  # not at the top: it imports zipfile

    return unpack_zip(File(name, data), Quota())


def _packed_source(slug: str, name: str, files: "Iterable[File]") -> Source:
    """Return the text of the file that fits best in a zip file."""
    held = {Path(file.path): file for file in files}

    def text_of(entry: Path) -> bytes:
        if held[entry].refused:
            raise CannotRead(f"{held[entry].path}: {held[entry].refused}")
        return held[entry].data

    best = _best(held, slug, text_of)
    text = text_of(best[0]) if best else b""
    if not best or is_zip(best[0].name):
        raise CannotRead(f"there is no {slug}.py in {name}; it holds {_listed(held) or 'no module or notebook'}")
    return Source(text, form(best[0].name) == ".ipynb", _remark(str(best[0]), map(str, best[1:])))


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
        newest_first = sorted(each, key=lambda entry: copy_order(entry.name, slug), reverse=True)
        work.append(_best_of([of_folder(entry, folder.name, slug, entry) for entry in newest_first]))
    if closed and not work:
        raise BadPath(next(iter(closed.values())))
    slugs = sorted({submission.slug for submission in work})  # assignments that other students handed in
    lost = [Submission(_name(home.name), slug, None, home, why) for home, why in closed.items() for slug in slugs]
    return _best_of_each(_twins_marked([*work, *lost]))


def holds_students(folder: Path, slugs: Sequence[str], students: Collection[str]) -> bool:
    """Return whether the folders in a folder are students', not one student's assignments; a login may be hw7.

    The roster decides. Without one, at least as many of them must contain assignments as are only named like one.
    """
    folders = [entry for entry, is_folder in entries(folder) if is_folder]
    if any(_name(entry.name) in students for entry in folders):
        return True
    like = [slug_of(entry.name, slugs) is not None for entry in folders]
    if not any(like):
        return any(holds_assignments(entry, slugs, files=True) for entry in folders)
    holding = [holds_assignments(entry, slugs, files=not is_like) for entry, is_like in zip(folders, like, strict=True)]
    return any(holding) and sum(holding) >= sum(
        is_like and not holds for is_like, holds in zip(like, holding, strict=True)
    )


def holds_assignments(folder: Path, slugs: Sequence[str], *, files: bool) -> bool:
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
        folders.sort(key=lambda entry: copy_order(entry.name, slug), reverse=True)
        candidates = [_of_files(own_work, home.name, slug, home)]
        yield _best_of([*candidates, *(of_folder(folder, home.name, slug, home) for folder in folders)])


def _best_of(candidates: Sequence[Submission]) -> Submission:
    """Return the best of a student's submissions of an assignment, the first of those that are equally good."""
    there = [candidate for candidate in candidates if candidate.path]
    if not there[1:]:
        return (there or candidates)[-1]
    best = min(there, key=_rank)
    texts: dict[Path | None, bytes] = {each.path: getattr(source_of(each), "text", b"") for each in there}
    paths = [path for path, text in texts.items() if path and is_begun(text) and text != texts[best.path]]
    return replace(best, others=(*best.others, *(printable(f"{path.parent.name}/{path.name}") for path in paths)))


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
    if best := _best(files, slug, lambda entry: read(Submission("", slug, entry, tree)).text):
        others = tuple(printable(entry.name) for entry in best[1:])
        return Submission(_name(student), slug, best[0], tree, others=others)
    names = _listed(Path(f"{entry.name[:80]} (a folder)") if is_folder else entry for entry, is_folder in held)
    message = f"there is no {slug}.py in the folder; it holds {names or 'no file'}"
    return Submission(_name(student), slug, None, tree, message)


def _best(held: Collection[Path], slug: str, text_of: Callable[[Path], bytes]) -> list[Path]:
    """Return the file that fits an assignment best, and then others that fit, are begun and have other contents.

    Any file that is begun counts before others. Of files that fit equally, the newest counts: see `copy_order`.
    """

    @functools.cache
    def content(entry: Path) -> bytes:
        """Return the text of a file, or why it cannot be read."""
        try:
            return text_of(entry)
        except CannotRead as why:
            return str(why).encode()

    def rank(entry: Path) -> tuple[object, ...]:
        count = _begun(content(entry))
        return count > 0, *copy_order(entry.name, slug), -len(entry.parts), count, entry.name

    def in_order(equal: list[Path]) -> list[Path]:
        if not equal[1:]:
            return equal
        newest = sorted(equal, key=lambda entry: copy_order(entry.name, slug), reverse=True)
        return sorted(newest[:MOST_NAMES], key=rank, reverse=True)

    def is_stub(entry: Path) -> bool:
        """Return whether nobody wrote in a file; a module may define its functions without `def`."""
        is_empty = form(entry.name) == ".ipynb" or UNWRITTEN.search(content(entry))
        return bool(is_empty) and not is_begun(content(entry))

    of_slug = dict.fromkeys(entry for entry in held if form(entry.name) and slug_of(entry.stem, [slug]))
    packed = [entry for entry in held if is_zip(entry.name)]
    packed = [entry for entry in packed if slug_of(entry.stem, [slug])] or packed
    fits: tuple[Callable[[Path], bool], ...] = (
        lambda entry: is_exact(entry.name, f"{slug}.py"),
        lambda entry: is_exact(entry.name, f"{slug}.ipynb"),
        lambda entry: entry in of_slug and form(entry.name) == ".py",
        lambda entry: entry in of_slug,
        lambda entry: form(entry.name) == ".ipynb" and all(map(is_stub, of_slug)),
        lambda entry: form(entry.name) == ".py" and not GIVEN.fullmatch(entry.stem) and all(map(is_stub, of_slug)),
        lambda entry: entry in packed,
    )
    groups = [equal for is_chosen in fits if (equal := in_order([*filter(is_chosen, held)]))]
    best = groups[0] if groups else []
    if len({*itertools.chain(*groups)}) > 1:  # a lone file is not read
        best = next((equal for equal in groups if is_begun(content(equal[0]))), best)
    others = [*best[1:], *(entry for entry in of_slug if best and form(entry.name) == form(best[0].name))]
    others = [entry for entry in dict.fromkeys(others[:MOST_NAMES]) if entry != best[0]]
    return best[:1] + [entry for entry in others if is_begun(content(entry)) and content(entry) != content(best[0])]


def is_exact(name: str, expected: str) -> bool:
    """Return whether a file has the expected name, or that with the number of a download: hw08_axis_angle (1).py."""
    return re.sub(r" ?\(\d{1,9}\)", "", name) == expected


def copy_order(name: str, slug: str) -> tuple[bool, int]:
    """Return a key, larger for a newer file: hw08 (1).py is newer than hw08.py, and hw08_old.py is the oldest."""
    title = rf"(?:hw|homework)[ _-]*\d{{1,2}}(?:[ _-]*{slug[5:]})?|{slug[5:]}"
    match = COPY.fullmatch(re.sub(title, "", name.split(".")[0], count=1, flags=re.IGNORECASE))
    assert match is not None  # it matches every text
    return match[1].strip(" _-") in ("", HANDIN[1:]), int(match[2] or 0)


def _listed(files: Iterable[Path]) -> str:
    """Return the names of the first files, and the number of the others, as text."""
    seen = [printable(entry.name[:90]) for entry in files]
    seen[MOST_NAMES:] = [f"{len(seen) - MOST_NAMES} more"] if len(seen) > MOST_NAMES else []
    return ", ".join(seen)


def is_begun(text: bytes) -> bool:
    """Return whether a module or notebook has a function that is not as in the stub."""
    return _begun(text) > 0


def _begun(text: bytes) -> int:
    """Return the number of functions that are not as in the stub."""
    return len(DEFINED.findall(text)) - len(UNWRITTEN.findall(text))


def _remark(counts: str, others: Iterable[str]) -> str:
    """Return a sentence for the student on the file that counts, if there are others."""
    return COUNTS.format(counts=counts, others=", ".join(names)) if (names := [*others]) else ""


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


def _twins_marked(work: Sequence[Submission]) -> list[Submission]:
    """Return the submissions; if the names of folders differ only in the encoding of an accent, each gets a mark."""
    count = collections.Counter(_name(tree.name) for tree in {submission.tree for submission in work})
    return [
        replace(each, student=_shortened(f"{each.student}-{_mark(each.tree.name)}"))
        if count[_name(each.tree.name)] > 1
        else each
        for each in work
    ]


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
