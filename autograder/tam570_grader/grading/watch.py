"""Grade each submission when it arrives (`tam570-grader watch`), and return its feedback page to the student.

Each event is a line of the journal `watch.jsonl` in the results folder and is on the disk before the next event: the
arrival, with a copy of the submission, then its result. After any interruption, the next run continues from there.
"""

import contextlib
import hashlib
import json
import math
import os
import pwd
import re
import time
from collections.abc import Iterator, Sequence
from dataclasses import asdict, dataclass, field, replace
from pathlib import Path

from tam570.values import Json
from tam570_grader.checks import assignments
from tam570_grader.course import course_config
from tam570_grader.errors import UsageError, counted, warn
from tam570_grader.grading import seeds, supervisor
from tam570_grader.grading.executor import TaskExecutor, WorkerLost, run_tasks
from tam570_grader.grading.skipped_files import skipped_files
from tam570_grader.grading.submissions import FEEDBACK, CannotRead, Submission, of_folder, source_of, submissions
from tam570_grader.grading.supervisor import GradeTask, WorkerConfig
from tam570_grader.reports import feedback
from tam570_grader.reports.feedback import AssignmentInfo
from tam570_grader.results.records import read as result_of
from tam570_grader.results.store import ResultStore
from tam570_grader.results.tables import write_in, written
from tam570_grader.sandbox.student import Source

JOURNAL, COPIES, KEY, STATUS = "watch.jsonl", "attempts", "watch.key", "status.html"
SETTLED = 0.2  # s without a change before a file is read: it may still be written
CHUNK = 12  # submissions per supervisor between two scans of the folder
TICK = 500  # ms, longest time between two scans of the folder
HANDED_IN = re.compile(r"(?P<student>[^+*]+)\+(?P<slug>[^+]+)\+(?P<timestamp>[^+]+)(?:\+[^+]*)?")  # nbgrader's folders


@dataclass(frozen=True)
class Policy:
    """How often a student may hand in, and which attempt counts."""

    attempts: float = math.inf
    every: float = 0.0  # s between two attempts
    count: str = "best"


@dataclass(frozen=True)
class Arrival:
    """A submission that arrived: the path of a copy, or the reason why it cannot be read."""

    student: str
    slug: str
    digest: str
    at: float
    copy: str
    origin: str
    reason: str = ""
    remark: str = ""  # names other files that were handed in

    @property
    def key(self) -> tuple[str, str]:
        return self.student, self.slug


@dataclass
class Queue:
    """Arrivals and graded attempts, as recorded in the journal of a folder."""

    folder: Path
    policy: Policy
    arrivals: list[Arrival] = field(default_factory=list)  # not graded yet, in order
    graded: dict[tuple[str, str], list[Json]] = field(default_factory=dict)  # attempts by student and assignment
    newest: dict[tuple[str, str], str] = field(default_factory=dict)  # digest of the last arrival
    longest: float = 0.0  # s, longest wait of a student

    def __post_init__(self) -> None:
        path = self.folder / JOURNAL
        lines = path.read_bytes().splitlines(keepends=True) if path.exists() else []
        for line in lines:
            if line.endswith(b"\n"):
                self._apply(json.loads(line))
        if lines and not lines[-1].endswith(b"\n"):  # a run was killed while it wrote the line
            written(path, b"".join(lines[:-1]))

    def _apply(self, event: Json) -> None:
        key = event["student"], event["slug"]
        if event["event"] == "arrived":
            arrival = Arrival(**{name: event.get(name, "") for name in Arrival.__dataclass_fields__})
            self.arrivals.append(arrival)
            self.newest[key] = arrival.digest
        else:
            self.arrivals = [
                arrival for arrival in self.arrivals if (*arrival.key, arrival.digest) != (*key, event["digest"])
            ]
            if event["event"] == "graded":
                self.graded.setdefault(key, []).append(event)
                self.longest = max(self.longest, event["waited"])

    def log(self, event: str, arrival: Arrival, **more: object) -> Json:
        """Append an event to the journal, flush it to the disk, apply it, and return it."""
        entry = {"event": event, **asdict(arrival), **more}
        with open(self.folder / JOURNAL, "ab") as file:
            file.write(json.dumps(entry, allow_nan=False).encode() + b"\n")
            file.flush()
            os.fsync(file.fileno())
        self._apply(entry)
        return entry

    def opening_time(self, arrival: Arrival) -> float:
        """Return the earliest time to grade an arrival, in s since 1970; infinity if no attempt is left."""
        attempts = self.graded.get(arrival.key, [])
        if len(attempts) >= self.policy.attempts:
            return math.inf
        return max((attempt["graded_at"] + self.policy.every for attempt in attempts), default=0.0)

    def take(self, arrival: Arrival) -> None:
        """Add an arrival; it replaces earlier arrivals of the same student and assignment that still had to wait."""
        mine = [earlier for earlier in self.arrivals if earlier.key == arrival.key]
        for earlier in [earlier for earlier in mine if self.opening_time(earlier) > arrival.at]:
            self.log("replaced", earlier)
        self.log("arrived", arrival)
        if self.opening_time(arrival) == math.inf:
            self.log("refused", arrival)
            warn(f"{arrival.student} has no attempt left in {arrival.slug}: the new work is not graded")

    def ready(self, now: float) -> list[Arrival]:
        """Return the arrivals that may be graded now, in order, only the first of each student and assignment."""
        first: dict[tuple[str, str], Arrival] = {}
        for arrival in self.arrivals:
            if self.opening_time(arrival) <= now:
                first.setdefault(arrival.key, arrival)
        return [*first.values()]

    def counting(self, key: tuple[str, str]) -> Json:
        """Return the attempt that counts."""
        attempts = self.graded[key]
        if self.policy.count == "last":
            return attempts[-1]
        return max(
            attempts, key=lambda attempt: (attempt["record"]["score"] is not None, attempt["record"]["score"] or 0.0)
        )


@dataclass
class Watcher:
    """Loop that watches a folder, grades what arrives, and returns the feedback pages."""

    source: Path
    course: Path
    queue: Queue
    store: ResultStore
    executor: TaskExecutor
    secret: bytes
    assignment: str | None = None  # the assignment, if the names of files do not tell
    jobs: int = 1
    once: bool = False

    def __post_init__(self) -> None:
        self.source = self.source.absolute()
        self.is_exchange = (self.source / "inbound").is_dir()
        self.slugs = assignments.slugs(self.course)
        self.slug = assignments.match_slug(self.assignment, self.slugs)
        self._stamps: dict[Path, tuple[int, int, int]] = {}
        self._infos: dict[str, AssignmentInfo] = {}

    def work(self) -> None:
        """Grade arrivals until the command is interrupted, or with --once until no arrival may be graded now."""
        for key in self.queue.graded:  # an earlier run may have been killed between a result and its page
            self.store.add(self.queue.counting(key)["record"])
            self.hand_back(self.queue.graded[key][-1])
        work: list[Submission] = []
        with contextlib.suppress(UsageError):  # the folder contains no submission yet
            work = submissions([self.source], self.slugs, self.slug)
        for sentence in () if self.is_exchange else skipped_files([self.source], work, self.slugs):
            warn(sentence)
        if not self.once:
            self.start_workers()
        for _ in self.ticks():
            self.look()
            while batch := self.queue.ready(time.time())[: CHUNK * self.jobs]:
                self.grade(batch)
                self.look()
            self.show()

    def start_workers(self) -> None:
        """Start the supervisors and their sandboxes, so that the first submissions need not wait for it."""
        idle = Arrival("", self.slug or self.slugs[0], "", 0.0, "", "", "nothing")
        task = replace(self._task(idle), source=Source(b"", notebook=False))
        for _ in run_tasks(self.executor, supervisor.line, [task] * self.jobs):
            pass

    def ticks(self) -> Iterator[None]:
        """Yield at once, then at each change in the folder and at least every TICK, as a student's wait may be over."""
        from watchfiles import watch

        yield
        if self.once:
            time.sleep(SETTLED)
            yield
            return
        where = self.source / "inbound" if self.is_exchange else self.source
        for _ in watch(where, debounce=200, step=20, rust_timeout=TICK, yield_on_timeout=True, raise_interrupt=True):
            yield

    def look(self) -> None:
        """Add each new submission that is completely written to the queue."""
        for submission, digest in self.handed_in():
            stamp = self._stamp(submission.path)
            if submission.path is not None and (stamp is None or stamp == self._stamps.get(submission.path)):
                continue
            source = source_of(submission)
            text = source.text if isinstance(source, Source) else str(source).encode()
            digest = digest or hashlib.sha256(text).hexdigest()
            key = submission.key
            digests = {self.queue.newest.get(key)}
            if self.is_exchange:  # there, folders of earlier attempts remain beside the newest
                digests |= {attempt["digest"] for attempt in self.queue.graded.get(key, [])}
                digests |= {arrival.digest for arrival in self.queue.arrivals if arrival.key == key}
            if digest not in digests:
                self.queue.take(self._kept(submission, digest, source))
            if submission.path is not None and stamp is not None:
                self._stamps[submission.path] = stamp

    def _stamp(self, path: Path | None) -> tuple[int, int, int] | None:
        """Return modification time, size and inode of a file; None if it is missing or may still be written."""
        try:
            status = os.stat(path or self.source)
        except OSError:
            return None
        is_young = 0 <= time.time() - status.st_mtime < SETTLED
        return None if is_young and not self.is_exchange else (status.st_mtime_ns, status.st_size, status.st_ino)

    def handed_in(self) -> Iterator[tuple[Submission, str]]:
        """Yield each submission, in nbgrader's exchange with a digest of its folder's name (each is an attempt)."""
        if not self.is_exchange:
            with contextlib.suppress(UsageError):  # the folder contains no submission yet
                for submission in submissions([self.source], self.slugs, self.slug):
                    if submission.path is not None or submission.reason:
                        yield submission, ""
            return
        entries = [(HANDED_IN.fullmatch(entry.name), entry) for entry in os.scandir(self.source / "inbound")]
        matches = [(match["timestamp"], entry.name, match, entry) for match, entry in entries if match]
        for _, _, match, entry in sorted(matches, key=lambda arrived: arrived[:2]):
            if match["slug"] in self.slugs and entry.is_dir(follow_symlinks=False):
                folder = Path(entry.path)
                if (folder / "submission_secret.txt").is_file():  # nbgrader writes it last
                    digest = hashlib.sha256(entry.name.encode()).hexdigest()
                    yield _owned(of_folder(folder, match["student"], match["slug"], folder), folder), digest

    def _kept(self, submission: Submission, digest: str, source: Source | CannotRead) -> Arrival:
        """Copy a submission, so that no later change affects it, and return the arrival."""
        student, slug, origin = submission.student, submission.slug, submission.path or submission.tree
        if isinstance(source, CannotRead):
            return Arrival(student, slug, digest, time.time(), "", str(origin), str(source))
        copy = self.queue.folder / COPIES / student / slug / f"{digest[:16]}{'.ipynb' if source.notebook else '.py'}"
        copy.parent.mkdir(parents=True, exist_ok=True)
        written(copy, source.text)
        return Arrival(student, slug, digest, time.time(), str(copy), str(origin), remark=source.remark)

    def grade(self, batch: Sequence[Arrival]) -> None:
        """Grade arrivals, each with its own hidden inputs; log each result, then write its page."""
        tasks = [self._task(arrival) for arrival in batch]
        for number, task, line in run_tasks(self.executor, supervisor.line, tasks, len(tasks)):
            record = json.loads(supervisor.lost(task, str(line)) if isinstance(line, WorkerLost) else line)
            arrival = batch[number]
            attempt = len(self.queue.graded.get(arrival.key, [])) + 1
            now = time.time()
            due = max(arrival.at, self.queue.opening_time(arrival))
            event = self.queue.log(
                "graded", arrival, attempt=attempt, graded_at=now, waited=round(now - due, 3), record=record
            )
            self.store.add(self.queue.counting(arrival.key)["record"])
            self.hand_back(event)

    def _task(self, arrival: Arrival) -> GradeTask:
        attempt = len(self.queue.graded.get(arrival.key, [])) + 1
        seed = seeds.derive(self.secret, arrival.student, arrival.slug, str(attempt))
        copy = Path(arrival.copy) if arrival.copy else None
        source = source_of(Submission(arrival.student, arrival.slug, copy, copy or Path(), arrival.reason))
        source = replace(source, remark=arrival.remark) if isinstance(source, Source) else source
        hidden = self.course, self.source, self.queue.folder.resolve()
        config = WorkerConfig(course_config.resource_limits(self.course), hidden)
        return GradeTask(self.course, arrival.student, arrival.slug, seed, source, arrival.digest, conditions=config)

    def hand_back(self, event: Json) -> None:
        """Write the page of an attempt into the results folder and to where the student finds it."""
        key = event["student"], event["slug"]
        info = self._infos.setdefault(key[1], feedback.load_assignment_info(self.course, key[1]))
        result, policy = result_of(event["record"]), self.queue.policy
        of = f" of {policy.attempts:g}" if policy.attempts < math.inf else ""
        score = self.queue.counting(key)["record"]["score"]
        counts = f"your {policy.count} attempt counts" + ("" if score is None else f", {score:g} points so far")
        message = " ".join(filter(None, [f"Attempt {event['attempt']}{of}; {counts}.", result.message]))
        page = feedback.page(replace(result, message=message), info)
        pages = self.queue.folder / "feedback"
        feedback.write_page(pages, key, page)
        origin = Path(event["origin"])
        try:
            if self.is_exchange:
                self._release(origin if origin.is_dir() else origin.parent, key[1], page)
            elif origin.parent.is_dir() and not origin.is_dir():
                write_in(origin.parent, f"{origin.name.split('.')[0]}{FEEDBACK}", page)
        except OSError as error:
            warn(f"the page of {key[0]} in {key[1]} cannot be put back: {error}; it is in {pages / key[0]}")

    def _release(self, folder: Path, slug: str, page: str) -> None:
        """Write a page where `nbgrader fetch_feedback` looks, named by a hash of the secret and the notebook."""
        secret = (folder / "submission_secret.txt").read_bytes()
        names = {path.stem for path in folder.glob("*.ipynb")} or {slug}
        feedback = self.source / "feedback"
        feedback.mkdir(mode=0o711, exist_ok=True)  # nbgrader's mode: students cannot list the folder
        for name in sorted(names):
            write_in(feedback, f"{hashlib.md5(secret + name.encode(), usedforsecurity=False).hexdigest()}.html", page)

    def show(self) -> None:
        """Write the status page."""
        now, rows = time.time(), []
        for arrival in self.queue.arrivals:
            opening = self.queue.opening_time(arrival)
            waits = f"until {_clock(opening)}" if opening > now else f"{now - arrival.at:.1f} s"
            rows.append((arrival.student, arrival.slug, _clock(arrival.at), waits, "", "waiting"))
        done = [attempts[-1] for attempts in self.queue.graded.values()]
        for event in sorted(done, key=lambda event: float(event["at"]), reverse=True):
            waited, attempt = f"{event['waited']:.1f} s", str(event["attempt"])
            score, most = event["record"]["score"], event["record"]["max_score"]
            points = "the grader failed" if score is None else f"{score:g} / {most:g}"
            rows.append((event["student"], event["slug"], _clock(event["at"]), waited, attempt, points))
        page = feedback.template("arrivals.html").render(rows=rows, summary=self.summary())
        written(self.queue.folder / STATUS, page)

    def summary(self) -> str:
        graded = sum(map(len, self.queue.graded.values()))
        waiting = len(self.queue.arrivals)
        return (
            f"{counted(graded, 'attempt')} graded, {waiting} waiting; the longest wait was {self.queue.longest:.1f} s"
        )


def _owned(submission: Submission, folder: Path) -> Submission:
    """Return the submission, without its file if another user owns the folder: nobody may hand in for others."""
    owner = folder.stat().st_uid
    with contextlib.suppress(KeyError):
        if owner != os.getuid() and pwd.getpwuid(owner).pw_name != submission.student:
            return replace(submission, path=None, reason=f"it was handed in by {pwd.getpwuid(owner).pw_name}")
    return submission


def _clock(moment: float) -> str:
    return time.strftime("%Y-%m-%d %H:%M:%S", time.localtime(moment)) if moment < math.inf else "never"
