"""A run of the grader: hands submissions to supervisors, and writes down what they give back.

The head reads bytes, hands out and writes; whatever takes time is done by the supervisors. What is known already is
not graded again.
"""

import hashlib
import hmac
import json
import platform
import sys
import tempfile
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from contextlib import ExitStack
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from tam570_grader.grading import supervisor
from tam570_grader.grading.cluster import Cluster
from tam570_grader.grading.processes import Lost, finished
from tam570_grader.grading.processes import crew as crew_here
from tam570_grader.grading.submissions import CannotRead, Submission, read
from tam570_grader.grading.supervisor import Conditions, Task
from tam570_grader.results.journal import Book, Key, Record, Results
from tam570_grader.sandbox.launch import isolation
from tam570_grader.sandbox.preload import imported
from tam570_grader.sandbox.student import Source
from tam570_grader.sandbox.worker import Allowance
from tam570_grader.writing import assignments

__all__ = ["Known", "Plan", "digests", "lines", "outcomes", "records"]

FEW = 4  # submissions a process, for which to start one repays
HELD = 2**26  # bytes of submissions that are held until they are handed out; others are read twice


@dataclass(frozen=True)
class Plan:
    """What is graded and how."""

    course: Path
    submissions: Sequence[Submission]
    seed: int
    jobs: int
    allowance: Allowance
    hidden: Sequence[Path] = ()
    speed: bool = False  # measure run time against error too
    key: bytes | None = None  # varies the hidden inputs from student to student; `seed` is then not used
    cluster: Cluster | None = None  # None: this machine

    def seed_of(self, submission: Submission) -> int:
        """The seed of a submission's hidden inputs: the class's, else one that only the key tells."""
        if self.key is None:
            return self.seed
        name = f"{submission.student}\n{submission.slug}".encode()
        return int.from_bytes(hmac.digest(self.key, name, "sha256")[:4]) >> 1


@dataclass(frozen=True)
class Known:
    """A result that is there already; it is read if it is asked for."""

    place: Results
    key: Key

    @property
    def note(self) -> Any:
        """What was noted of it when its file was read."""
        return self.place.lines[self.key].note

    @property
    def record(self) -> Record:
        return self.place[self.key]


def records(plan: Plan, book: Book | None = None, old: Sequence[Results] = ()) -> Iterator[Record]:
    """The result lines, each as soon as it is there and written into the book; what `old` knows is not run again.

    Where the grader itself failed, it tries again.
    """
    for outcome in outcomes(plan, book, old):
        yield outcome.record if isinstance(outcome, Known) else outcome


def outcomes(plan: Plan, book: Book | None = None, old: Sequence[Results] = ()) -> Iterator[Known | Record]:
    """The same as `records`, but what is known is not read."""
    places = (*old, *([book] if book is not None else ()))
    known = {line.digest: Known(place, key) for place in places for key, line in place.lines.items() if line.scored}
    engine = _engine_digest(plan)
    fresh, held, users = list[tuple[Submission, Task | None]](), 0, Counter[str]()
    for submission in plan.submissions:
        task = _task(plan, engine, submission)
        if task.digest in known:
            yield _noted(known[task.digest], book)
            continue
        text = task.source.text if isinstance(task.source, Source) else b""
        users.update(imported(text))
        held += len(text)
        fresh.append((submission, task if held < HELD else None))
    # a worker's import of a package pays off from the second submission that uses it
    preload = [name for name, count in users.items() if count >= 2 * plan.jobs]
    tasks = (task or _task(plan, engine, submission) for submission, task in fresh)
    for line in lines(plan, tasks, len(fresh), preload):
        record = json.loads(line)
        if book is not None:
            book.add(record, line)
        yield record


def digests(plan: Plan) -> Iterator[tuple[str, str, str]]:
    """Student, assignment and digest of each submission: of all that its result depends on."""
    engine = _engine_digest(plan)
    for submission in plan.submissions:
        yield submission.student, submission.slug, _task(plan, engine, submission).digest


def _noted(known: Known, book: Book | None) -> Known:
    """A result that is known already, in the book too."""
    if book is not None and known.place is not book:
        book.add(known.record)
    return known


def lines(plan: Plan, tasks: Iterable[Task], count: int, preload: Sequence[str] = ()) -> Iterator[bytes]:
    """The result lines of these tasks, as soon as each is there; an interrupt ends all supervisors."""
    jobs = max(1, min(plan.jobs, count // FEW))
    with ExitStack() as stack:
        if not count:
            return
        if plan.cluster:
            slugs = sorted({one.slug for one in plan.submissions})
            crew = stack.enter_context(plan.cluster.crew(plan.course, slugs, plan.jobs))
        else:
            crew = stack.enter_context(crew_here(jobs))
        conditions = Conditions(plan.allowance, _hidden(plan), tuple(preload), plan.speed, _shared(plan, jobs, stack))
        asked = (replace(task, conditions=conditions) for task in tasks)
        for _, task, line in finished(crew, supervisor.line, asked, count):
            yield supervisor.lost(task, str(line)) if isinstance(line, Lost) else line


def _hidden(plan: Plan) -> tuple[Path, ...]:
    """What must not be seen here; on a cluster nothing of ours is there but the course."""
    return () if plan.cluster else tuple(plan.hidden)


def _shared(plan: Plan, jobs: int, stack: ExitStack) -> Path | None:
    """A folder for dear answers, where several processes of this machine need the same."""
    if plan.key is not None or jobs == 1 or (plan.cluster and not plan.cluster.is_local):
        return None
    return Path(stack.enter_context(tempfile.TemporaryDirectory(prefix="tam570-", ignore_cleanup_errors=True)))


def _task(plan: Plan, engine: bytes, submission: Submission) -> Task:
    source = _source(submission)
    digest = _digest(engine, plan, submission, source)
    seed = plan.seed_of(submission)
    return Task(plan.course, submission.student, submission.slug, seed, source, digest, submission.path is None)


def _source(submission: Submission) -> Source | CannotRead:
    if submission.path is None:
        return CannotRead(submission.note)
    try:
        return read(submission)
    except CannotRead as error:
        return error


def _digest(engine: bytes, plan: Plan, submission: Submission, source: Source | CannotRead) -> str:
    """A name for all that the result depends on."""
    text = source.text if isinstance(source, Source) else str(source).encode()
    kind = type(source).__name__ + (".ipynb" if isinstance(source, Source) and source.notebook else "")
    parts = (  # each with its length: no two lists of them are the same text
        kind.encode(),
        submission.student.encode(),
        submission.slug.encode(),
        text,
        assignments.checks_digest(plan.course, submission.slug),
        str(plan.seed_of(submission)).encode(),
        engine,
    )
    return hashlib.sha256(b"".join(len(part).to_bytes(8) + part for part in parts)).hexdigest()


def _engine_digest(plan: Plan) -> bytes:
    """Of the limits, of what keeps submissions apart, and of all code but the assignment's."""
    asked = (
        plan.allowance,
        plan.cluster.isolation if plan.cluster else isolation(),
        sys.version,
        platform.machine(),
        _installed(),
        *(("speed",) if plan.speed else ()),
    )
    return hashlib.sha256(repr(asked).encode() + assignments.engine_digest()).digest()


def _installed() -> list[str]:
    """Names and versions of the libraries, by their folders: importlib.metadata takes longer."""
    return sorted(found.name for folder in sys.path if folder for found in Path(folder).glob("*-info"))
