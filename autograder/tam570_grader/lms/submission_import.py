"""Sort a learning management system's download into `submitted/<student>/<assignment>/` (`tam570-grader collect`)."""

import re
from collections import Counter, defaultdict
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from tam570_grader.errors import UsageError, counted, say, warn, writing
from tam570_grader.grading import roster as rosters
from tam570_grader.grading.archives import METADATA, File, Quota, is_beside, members, unpack_zip
from tam570_grader.grading.roster import Directory, Person
from tam570_grader.grading.submissions import GIVEN, copy_order, folder_of, is_begun, is_exact, of_folder, of_name
from tam570_grader.lms.downloads import Handed, read, time_of
from tam570_grader.lms.systems import SYSTEMS
from tam570_grader.results.collected import COLUMNS, MINOR, OLDER, RELEASED, SAME, TABLE, form, is_zip, listed
from tam570_grader.results.tables import table, write_table, written

NOT_WORK = "neither a module (.py) nor a notebook (.ipynb): ask the student for one"
EMPTY = "it is empty: ask the student to upload it again"
NAMELESS = "cannot tell the assignment: give it with --assignment"
OTHER = "another file counts: see which one, and name that after the assignment"
ELSEWHERE = "it is named after {other}, and this download is of {slug}: ask which one it is"
TWO = "another in the download goes to the same student: who is who on the roster?"
TAKEN = "its folder would be that of another student on the roster: give a roster that knows it"
PASTED = "the student typed this text in the browser: read it, or ask for a file"
STRANGER = "is on no row of the roster: add a row and collect again, or rename the folder"
MOST_WARNINGS = 10  # warnings per student
SUBMITTED = (
    "a submission has been submitted.",
    "submission created.",
    "submission updated.",
    "a file has been uploaded.",
)
NOTE = re.compile(r".+_attempt_[\d-]+\.txt")  # Blackboard's note on a submission, which has its typed text
TYPED = re.compile(rf"onlinetext\.html|.+_text\.html|{NOTE.pattern}")  # Moodle's, Canvas's and Blackboard's typed text
SLASHED, MONTHS = re.compile(r"(\d{1,2})/(\d{1,2})/"), 12  # the first two numbers of a date
TIME, WHO, EVENT = "time", "user full name", "event name"  # columns of Moodle's log


@dataclass(frozen=True)
class CollectedFile:
    """A file with its student, its assignment and its new name `target`; if that is empty, `reason` says why."""

    student: str
    person: Person | None
    handed: Handed
    slug: str
    target: str
    reason: str = ""


@dataclass(frozen=True)
class Lists:
    """Tables that an instructor has besides the download.

    roster : all students; folders are named after their logins
    groups : members of groups in which one hands in for all; not needed if the roster has a column Group
    times  : Moodle's worksheet or log, with times that the download does not have
    """

    roster: Path | None = None
    groups: Path | None = None
    times: Path | None = None


def run(source: Path, system: str, out: Path, slugs: Sequence[str], slug_given: str | None, lists: Lists) -> int:
    """Collect a download; return 1 if there are problems that the instructor must solve.

    slug_given : the assignment of the download, if the names of files do not tell
    """
    if not source.exists():
        raise UsageError(f"{source} does not exist: name the zip file that {SYSTEMS[system].title} gave you")
    everyone = Directory(rosters.people(path) if (path := lists.roster or lists.groups) else ())
    tables = filter(None, (lists.roster, lists.groups))
    teams = {name: who for path in tables for name, who in rosters.groups(path, everyone).items()}
    everything = list(read(members(source), system))
    strays = [handed for handed in everything if isinstance(handed, File)]
    uploads = [handed for handed in everything if isinstance(handed, Handed)]
    with_files = {handed.who for handed in uploads if not NOTE.fullmatch(handed.title)}
    unpacked = _unpacked(
        [upload for upload in uploads if upload.who not in with_files or not NOTE.fullmatch(upload.title)]
    )
    if not unpacked:
        raise UsageError(f"no name in {source} has the form that {SYSTEMS[system].title} gives: is --from right?")
    slug = slug_given or _assignment_of(unpacked, slugs)
    rows: list[CollectedFile] = []
    for handed in unpacked:
        owners, why = _owners(handed, system, everyone, teams)
        target, reason = _place(handed, why, slug, slugs, slug_given)
        rows += [CollectedFile(person.folder, person, handed, slug, target, reason) for person in owners]
        if not owners:
            rows.append(CollectedFile(folder_of(handed.who), None, handed, slug, target, reason))
    rows = _with_work(_newest(_told_apart(rows, everyone)))
    rows = _timed(rows, lists.times, everyone)
    replaced = _write(rows, out)
    troubles = [
        (row.student, f"{row.handed.file.path} of {row.student} is not collected: {row.reason}")
        for row in rows
        if row.reason and row.reason not in MINOR
    ]
    troubles += _newer_notebooks(rows, out)
    why = "is nobody's by " + METADATA if system == "gradescope" else f"is not named as {system} names submissions"
    troubles += [("", f"{stray.path} {stray.refused or why}") for stray in strays]
    unmatched = {row.student: row for row in rows if everyone.people and row.person is None and row.target}
    troubles += [(who, f"{who} ({row.handed.name}) {STRANGER}") for who, row in unmatched.items()]
    _warn(troubles)
    for line in replaced:
        say(line)
    _say(rows, out, everyone, slug, all_matched=not strays and all(row.person for row in rows))
    return 1 if troubles else 0


def _assignment_of(unpacked: Sequence[Handed], slugs: Sequence[str]) -> str:
    """Return the assignment after which most students named files; "" if none did, UsageError for a tie."""
    titled = {(handed.who, slug) for handed in unpacked if (slug := of_name(handed.title, slugs))}
    ranked = Counter(slug for _, slug in titled).most_common(2)
    if len(ranked) == 2 and ranked[0][1] == ranked[1][1]:
        names = " and ".join(slug for slug, _ in ranked)
        raise UsageError(f"as many names tell {names}; a download is of one: give it with --assignment")
    return ranked[0][0] if ranked else ""


def _unpacked(handed: Sequence[Handed]) -> list[Handed]:
    """Return the files, with zip files replaced by the work in them; a quota limits each student's memory."""
    quotas: dict[str, Quota] = defaultdict(Quota)
    unpacked = []
    for upload in handed:
        file, quota = upload.file, quotas[upload.who]
        empty = replace(upload, file=replace(file, data=b""))
        if file.refused or not is_zip(upload.title):
            is_kept = bool(form(upload.title)) or is_beside(upload.title)
            full = quota.takes([file]) if is_kept else ""
            unpacked.append(replace(upload, file=File(file.path, b"", full)) if full else upload if is_kept else empty)
            continue
        held = unpack_zip(file, quota)  # with paths below the zip file's, whose name `lms --pages` needs
        unpacked += [replace(upload, file=member, title=member.path.rsplit("/", 1)[-1]) for member in held] or [empty]
    return unpacked


def _place(handed: Handed, why_not: str, slug: str, slugs: Sequence[str], slug_given: str | None) -> tuple[str, str]:
    """Return the new name of a file and "", or "" and the reason why it is not collected."""
    title = handed.title
    other = of_name(title, slugs)
    if handed.file.refused:
        return "", handed.file.refused
    if TYPED.fullmatch(title):
        return "", PASTED
    if not (ending := form(title)):
        if why_not or not is_beside(title):
            return "", NOT_WORK
        plain = "".join(c if c.isalnum() or c in "-_." else "_" for c in title).lstrip(".")
        return f"beside-{plain[-100:]}", ""  # a safe name for file systems and terminals
    if GIVEN.fullmatch(Path(title.removesuffix(".txt")).stem):
        return "", RELEASED
    if not (other or slug_given):
        return "", NAMELESS
    if other not in (None, slug):
        return "", ELSEWHERE.format(other=other, slug=slug)
    if why_not := why_not or ("" if handed.file.data.strip() else EMPTY):
        return "", why_not
    return f"{slug}{ending}", ""


def _with_work(rows: Sequence[CollectedFile]) -> list[CollectedFile]:
    """Return the rows, without the targets of drawings and texts of students who have no module or notebook."""
    working = {row.student for row in rows if form(row.target)}
    return [
        _left(row, NOT_WORK) if row.target and not form(row.target) and row.student not in working else row
        for row in rows
    ]


def _left(row: CollectedFile, reason: str) -> CollectedFile:
    return replace(row, target="", reason=reason)


def _owners(
    handed: Handed, system: str, everyone: Directory, teams: Mapping[str, Sequence[Person]]
) -> tuple[Sequence[Person], str]:
    """Return the students to whom a file belongs; if it is unclear, none and the reason ("" if no row fits)."""
    who = everyone.owner(handed.keys, handed.name, must_agree=SYSTEMS[system].must_agree)
    if isinstance(who, Person):
        return [who], ""
    team = teams.get(rosters.group_key(handed.name), []) if handed.name else []
    if system == "canvas" and team and not any(person in team for key in handed.keys for person in everyone.of(key)):
        return [], f"its number is of nobody in the group {handed.name}"
    return (team, "") if team else ([], who)


def _told_apart(rows: Sequence[CollectedFile], everyone: Directory) -> list[CollectedFile]:
    """Return the rows, without the targets of different people whose folders would have the same name."""
    folders = {person.folder for person in everyone.people}
    who = defaultdict[str, set[tuple[object, ...]]](set)
    for row in rows:
        if row.person or row.student not in folders:
            who[row.student].add((row.handed.keys, row.handed.name))

    def reason(row: CollectedFile) -> str:
        if row.person is None and row.student in folders:
            return TAKEN
        return TWO if len(who[row.student]) > 1 else ""

    return [_left(row, reason(row)) if row.target and reason(row) else row for row in rows]


def _newest(rows: Sequence[CollectedFile]) -> list[CollectedFile]:
    """Return all rows, sorted, of which only the best of each student and target keeps its target."""
    best: dict[tuple[str, str], CollectedFile] = {}
    for row in rows:
        key = row.student, row.target
        if row.target and (key not in best or _rank(row) >= _rank(best[key])):
            best[key] = row

    def placed(row: CollectedFile) -> CollectedFile:
        winner = best.get((row.student, row.target), row)
        if winner is row:
            return row
        if _rank(row)[0] < _rank(winner)[0]:
            return _left(row, RELEASED)
        is_same = row.handed.file.data == winner.handed.file.data
        return _left(row, OLDER if row.handed.order < winner.handed.order else SAME if is_same else OTHER)

    return sorted(map(placed, rows), key=lambda row: (row.student, row.slug, row.handed.order))


def _rank(row: CollectedFile) -> tuple[bool, bool, tuple[object, ...]]:
    """Return a key, largest for the best file: begun, named after its assignment, newest, with the exact name."""
    title = row.handed.title
    newest = (
        row.handed.order,
        is_exact(title, row.target),
        copy_order(title, row.slug),
        -row.handed.file.path.count("/"),
    )
    return is_begun(row.handed.file.data), of_name(title, [row.slug]) is not None, newest


def _timed(rows: Sequence[CollectedFile], path: Path | None, everyone: Directory) -> list[CollectedFile]:
    """Return the rows with times from a log, worksheet or roster if the download has none."""
    logged = _last_times(path, everyone) if path else {}

    def when(row: CollectedFile) -> str:
        person = row.person
        return row.handed.when or (person and (logged.get(person.folder, "") or time_of(person.when))) or ""

    return [replace(row, handed=replace(row.handed, when=when(row))) for row in rows]


def _last_times(path: Path, everyone: Directory) -> dict[str, str]:
    """Return the time of each student's last submission by folder, from Moodle's worksheet or log; else UsageError."""
    heading, *rows = table(path)
    lower = [name.strip().lower() for name in heading]
    if rosters.WHEN in lower:
        pairs = [(person.keys, person.name, person.when) for person in rosters.people(path)]
    elif {TIME, WHO, EVENT} <= {*lower}:
        cells = [dict(zip(lower, row, strict=False)) for row in rows]
        pairs = [
            ((), person[WHO], person[TIME]) for person in cells if person.get(EVENT, "").strip().lower() in SUBMITTED
        ]
    else:
        raise UsageError(f"{path} is neither Moodle's worksheet ({rosters.WHEN}) nor its log ({TIME}, {WHO}, {EVENT})")
    latest: dict[str, str] = {}
    day_first = _is_day_first([text for _, _, text in pairs], path)
    for keys, name, text in pairs:
        who, when = everyone.owner(keys, name, must_agree=True), time_of(text, day_first=day_first)
        if isinstance(who, Person) and when:
            latest[who.folder] = max(when, latest.get(who.folder, ""))
    return latest


def _is_day_first(texts: Iterable[str], path: Path) -> bool:
    """Return whether dates such as 14/09/26 begin with the day; in American English Moodle writes 09/14/26."""
    numbers = [tuple(map(int, match.groups())) for text in texts if (match := SLASHED.match(text.strip()))]
    if numbers and max(map(max, numbers)) <= MONTHS:
        warn(f"the dates in {path} could begin with the day or with the month; they are read as days, then months")
    return all(second <= MONTHS for _, second in numbers)


def _write(rows: Sequence[CollectedFile], out: Path) -> list[str]:
    """Write the files into their folders, and collected.csv; return a sentence for each file that is replaced."""
    path, replaced = out.parent / TABLE, []
    with writing(out):
        for row in rows:
            if row.target:
                target = out / row.student / row.slug / row.target
                target.parent.mkdir(parents=True, exist_ok=True)
                if target.is_file() and target.read_bytes() != row.handed.file.data:
                    replaced.append(f"{target} is replaced by {row.handed.file.path}")
                written(target, row.handed.file.data)
        out.mkdir(parents=True, exist_ok=True)
        # rows of earlier downloads are kept unless this download replaces them
        new = {(row.student, row.slug, row.target) for row in rows}
        earlier = [tuple(row[name] for name in COLUMNS) for row in (listed(path) if path.exists() else [])]
        lines = [line for line in earlier if line[2] and (line[0], line[2], line[3]) not in new]
        for row in rows:
            handed, late = row.handed, "LATE" if row.handed.late else ""
            who = row.student, handed.name, row.slug, row.target
            lines.append((*who, handed.when, late, handed.file.path, row.reason))
        write_table(path, [COLUMNS, *sorted(lines, key=lambda line: (line[0], line[2]))])
    return replaced


def _warn(troubles: Iterable[tuple[str, str]]) -> None:
    """Print the problems as warnings, at most MOST_WARNINGS per student; the table has all."""
    count = Counter[str]()
    for student, line in troubles:
        count[student] += 1
        if not student or count[student] <= MOST_WARNINGS:
            warn(line)
    for student, number in count.items():
        if student and number > MOST_WARNINGS:
            warn(f"{number - MOST_WARNINGS} more of {student}: {TABLE} lists them")


def _newer_notebooks(rows: Iterable[CollectedFile], out: Path) -> Iterator[tuple[str, str]]:
    """Yield student and sentence for each notebook that is newer than the module that counts."""
    work = [row for row in rows if row.target]
    modules = {(row.student, row.slug): row.handed.order for row in work if row.target.endswith(".py")}
    for row in work:
        folder = out / row.student / row.slug
        newer = row.target.endswith(".ipynb") and row.handed.order > modules.get((row.student, row.slug), ())
        counts = of_folder(folder, row.student, row.slug, folder).path if newer else None
        if counts and counts.suffix == ".py":
            remedy = "delete the module if the notebook should count"
            yield row.student, f"{row.handed.file.path} of {row.student} is newer than {counts}, which counts: {remedy}"


def _say(rows: Sequence[CollectedFile], out: Path, everyone: Directory, slug: str, *, all_matched: bool) -> None:
    """Print how many files were collected, late, or without a time, and who on the roster handed in nothing."""
    work = [row for row in rows if form(row.target)]
    late = sum(row.handed.late for row in work)
    count = f"{counted(len(work), 'file')} of {counted(len({row.student for row in work}), 'student')}"
    count += f", {late} late" if late else ""
    say(f"{out}: {count}, of {slug}; {out.parent / TABLE} lists them")
    if unknown := sum(not row.handed.when and not row.handed.late for row in work):
        say(f"the download does not tell when {counted(unknown, 'file')} came; --times adds it, for Moodle")
    absent = sorted({person.folder for person in everyone.people} - {row.student for row in rows})
    if absent:
        nothing = "nothing" if all_matched else "nothing, or a file that fits no row"
        say(f"{len(absent)} on the roster handed in {nothing}: {', '.join(absent)}")
