"""A run of the grader: workers, one for each job; what is known already is not graded again."""

import hashlib
import hmac
import platform
import queue
import sys
import threading
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor, as_completed
from dataclasses import dataclass, replace
from pathlib import Path

from tam570_grader.errors import UsageError
from tam570_grader.grading.one import Result, failed_by_us, graded, not_graded
from tam570_grader.grading.speed import Yardstick
from tam570_grader.grading.submissions import CannotRead, Submission, read
from tam570_grader.results.journal import Book, Record
from tam570_grader.sandbox.launch import isolation
from tam570_grader.sandbox.preload import imported
from tam570_grader.sandbox.student import Source
from tam570_grader.sandbox.worker import Allowance, NotConfined, Worker, WorkerLost
from tam570_grader.writing import assignments
from tam570_grader.writing.assignments import Assignment

__all__ = ["Plan", "graded_sources", "records"]

NO_JAIL = "submissions cannot be confined on this machine, and nothing was graded: {why}"
TRIES = 3  # workers that a submission may see die under it before we give up


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

    def seed_of(self, submission: Submission) -> int:
        """The seed of a submission's hidden inputs: the class's, else one that only the key tells."""
        if self.key is None:
            return self.seed
        name = f"{submission.student}\n{submission.slug}".encode()
        return int.from_bytes(hmac.digest(self.key, name, "sha256")[:4]) >> 1


def records(plan: Plan, book: Book | None = None, old: Iterable[Record] = ()) -> Iterator[Record]:
    """The result lines, each as soon as it is there and written into the book; what `old` knows is not run again.

    Where the grader itself failed, it tries again.
    """
    before = (*old, *(book.records() if book else ()))
    known = {record.get("digest"): record for record in before if record["score"] is not None}
    engine = _engine_digest(plan)
    fresh: list[tuple[Submission, Source | CannotRead, str]] = []
    for submission in plan.submissions:
        source = _source(submission)
        digest = _digest(engine, plan, submission, source)
        if digest in known:
            yield _kept(known[digest], book)
        else:
            fresh.append((submission, source, digest))
    for result, digest in graded_sources(plan, fresh):
        yield _kept(replace(result, digest=digest).record(), book)


def _kept(record: Record, book: Book | None) -> Record:
    if book:
        book.add(record)
    return record


def graded_sources(
    plan: Plan, fresh: Sequence[tuple[Submission, Source | CannotRead, str]]
) -> Iterator[tuple[Result, str]]:
    """Grade on as many workers as there are jobs; an interrupt ends them all."""
    jobs = min(plan.jobs, len(fresh))
    crew = _Crew(plan, _preload(plan, fresh, jobs), jobs)
    pool = ThreadPoolExecutor(max(1, jobs))
    try:
        tasks = {pool.submit(crew.graded, submission, source): digest for submission, source, digest in fresh}
        for task in as_completed(tasks):
            yield task.result(), tasks[task]
    finally:
        crew.ended.set()
        pool.shutdown(wait=False, cancel_futures=True)
        crew.dismiss()


class _Crew:
    """Warm workers, one for each job; one that dies is replaced."""

    def __init__(self, plan: Plan, preload: Sequence[str], jobs: int) -> None:
        self.ended = threading.Event()
        self._plan, self._preload = plan, preload
        self._yardstick = Yardstick(plan.course) if plan.speed else None
        self._everyone: list[Worker] = []
        self._idle: queue.SimpleQueue[Worker] = queue.SimpleQueue()
        for _ in range(jobs):
            self._idle.put(self._hired())

    def graded(self, submission: Submission, source: Source | CannotRead) -> Result:
        """The result of a submission, from the first worker that is free."""
        assignment = _assignment(self._plan, submission)
        seed = self._plan.seed_of(submission)
        if isinstance(source, CannotRead):
            status = "missing" if submission.path is None else "unreadable"
            return not_graded(submission.student, assignment, status, str(source), seed)
        worker, error = self._idle.get(), ""
        try:
            for left in reversed(range(TRIES)):
                try:
                    return graded(
                        submission.student,
                        source,
                        assignment,
                        worker,
                        seed,
                        self._yardstick,
                        forgiving=left > 0,
                        again=left < TRIES - 1,
                    )
                except WorkerLost as lost:
                    error = str(lost)
                    if self.ended.is_set():
                        raise
                    if isinstance(lost, NotConfined) and not left:
                        raise UsageError(NO_JAIL.format(why=lost)) from None
                    worker.close()
                    self._everyone.remove(worker)
                    worker = self._hired()
            return failed_by_us(submission.student, assignment, error, seed)
        except (UsageError, WorkerLost):
            raise
        except Exception as fault:  # ours, and of this submission alone: the class is graded on
            return failed_by_us(submission.student, assignment, repr(fault), seed)
        finally:
            self._idle.put(worker)

    def dismiss(self) -> None:
        for worker in self._everyone:
            worker.close()

    def _hired(self) -> Worker:
        self._everyone.append(Worker(self._preload, self._plan.allowance, self._plan.hidden))
        return self._everyone[-1]


def _preload(plan: Plan, fresh: Sequence[tuple[Submission, Source | CannotRead, str]], jobs: int) -> list[str]:
    """What the assignments need, and the common libraries that repay it: imported by two submissions a worker."""
    needs = {name for submission, *_ in fresh for name in _assignment(plan, submission).needs}
    texts = (source.text for _, source, _ in fresh if isinstance(source, Source))
    users = Counter(name for text in texts for name in imported(text))
    return sorted(needs | {name for name, count in users.items() if count >= 2 * jobs})


def _assignment(plan: Plan, submission: Submission) -> Assignment:
    return assignments.assignment(plan.course, submission.slug)


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
    parts = (
        kind.encode(),
        submission.student.encode(),
        submission.slug.encode(),
        text,
        _assignment(plan, submission).digest,
        str(plan.seed_of(submission)).encode(),
        engine,
    )
    return hashlib.sha256(b"".join(hashlib.sha256(part).digest() for part in parts)).hexdigest()


def _engine_digest(plan: Plan) -> bytes:
    """Of the limits, of what keeps submissions apart, and of all code but the assignment's."""
    asked = (
        plan.allowance,
        isolation(),
        sys.version,
        platform.machine(),
        _installed(),
        *(("speed",) if plan.speed else ()),
    )
    return repr(asked).encode() + assignments.engine_digest()


def _installed() -> list[str]:
    """Names and versions of the libraries, by their folders: importlib.metadata takes longer."""
    return sorted(found.name for folder in sys.path if folder for found in Path(folder).glob("*-info"))
