"""Run the grader: distribute submissions to supervisors and store their results.

The coordinator only reads submissions, distributes tasks and writes results; the supervisors do the slow work.
Submissions whose result is already stored are not graded again.
"""

import functools
import hashlib
import json
import platform
import sys
import tempfile
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import ExitStack
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import TYPE_CHECKING

from tam570_grader.checks import assignments
from tam570_grader.grading import supervisor
from tam570_grader.grading.executor import WorkerLost, cores, forks, run_tasks
from tam570_grader.grading.executor import executor as local_executor
from tam570_grader.grading.seeds import derive, new_seed
from tam570_grader.grading.submissions import Submission, source_of, submissions
from tam570_grader.grading.supervisor import GradeTask, WorkerConfig
from tam570_grader.results import records as result_records
from tam570_grader.results.records import Result
from tam570_grader.results.store import Record, Results, ResultStore
from tam570_grader.sandbox.launch import isolation
from tam570_grader.sandbox.preload import imported
from tam570_grader.sandbox.student import Source
from tam570_grader.sandbox.zygote import ResourceLimits

if TYPE_CHECKING:
    from tam570_grader.grading.cluster import Cluster

FEW = 4  # submissions per process; with fewer, starting another process takes longer than it saves


@dataclass(frozen=True)
class RunConfig:
    """Configuration of a run; by default no submissions, the installed course and a random seed."""

    course: Path = field(default_factory=assignments.find)
    submissions: Sequence[Submission] = ()
    seed: int = field(default_factory=new_seed)
    jobs: int = field(default_factory=cores)
    limits: ResourceLimits = ResourceLimits()
    hidden: Sequence[Path] = ()  # folders that no submission may see, besides the course
    speed: bool = False  # also measure run time against error
    key: bytes | None = None  # if set, each student gets other hidden inputs, and `seed` is not used
    cluster: "Cluster | None" = None  # None: grade on this machine


def grade(paths: Iterable[str | Path], config: RunConfig) -> Iterator[Result]:
    """Yield the results of the submissions at these paths; see `tam570_grader.grade`."""
    places = [Path(path) for path in paths]
    everyone = submissions(places, assignments.slugs(config.course))
    hidden = [config.course, *config.hidden, *(folder.resolve() for folder in places)]
    for record in records(replace(config, submissions=everyone, hidden=hidden)):
        yield result_records.read(record)


def records(config: RunConfig, store: ResultStore | None = None, old: Sequence[Results] = ()) -> Iterator[Record]:
    """Yield the record of each submission as soon as it is stored; reuse scored records in `store` and `old`."""
    places = (*old, *([store] if store is not None else ()))
    cached = {line.digest: (results, key) for results in places for key, line in results.lines.items() if line.scored}
    code = _code_digests(config)
    fresh, users = list[Submission](), Counter[str]()
    for submission in config.submissions:
        task = _task(config, code, submission)
        if task.digest in cached:
            results, key = cached[task.digest]
            earlier = results[key]
            if store is not None and results is not store:
                store.add(earlier)
            yield earlier
            continue
        users.update(imported(task.source.text if isinstance(task.source, Source) else b""))
        fresh.append(submission)
    # preloading a package in the zygote saves time only if at least two submissions import it
    preload = [name for name, count in users.items() if count > 1]
    tasks = (_task(config, code, submission) for submission in fresh)  # read again: a class may not fit in memory
    slugs = sorted({submission.slug for submission in fresh if submission.path})
    for line in lines(config, tasks, len(fresh), slugs, preload):
        record = json.loads(line)
        if store is not None:
            store.add(record, line)
        yield record


def digests(config: RunConfig) -> Iterator[tuple[str, str, str]]:
    """Yield student, assignment and digest of each submission; the digest covers all that its result depends on."""
    code = _code_digests(config)
    for submission in config.submissions:
        yield submission.student, submission.slug, _task(config, code, submission).digest


def lines(
    config: RunConfig, tasks: Iterable[GradeTask], count: int, slugs: Sequence[str], preload: Sequence[str] = ()
) -> Iterator[bytes]:
    """Yield the result line of each task as soon as it is graded; an interrupt ends all supervisors.

    slugs : assignments with at least one submitted file
    """
    jobs = max(1, min(config.jobs, count // FEW))
    with ExitStack() as stack:
        if not count:
            return
        if config.cluster:
            slugs = sorted({submission.slug for submission in config.submissions})
            executor = stack.enter_context(config.cluster.executor(config.course, slugs, config.jobs))
        else:
            executor = stack.enter_context(local_executor(jobs))
        hidden = () if config.cluster else tuple(config.hidden)  # a cluster worker has only the course, hidden anyway
        shared = None  # folder in which processes of this machine share expensive expected results
        if config.key is None and jobs > 1 and (not config.cluster or config.cluster.is_local):
            folder = tempfile.TemporaryDirectory(prefix="tam570-", ignore_cleanup_errors=True)
            shared = Path(stack.enter_context(folder))
        conditions = WorkerConfig(config.limits, hidden, tuple(preload), config.speed, shared)
        if not config.cluster and (jobs == 1 or forks()):
            supervisor.prepare(config.course, slugs, conditions, config.seed if config.key is None else None)
        configured = (replace(task, conditions=conditions) for task in tasks)
        for _, task, line in run_tasks(executor, supervisor.line, configured, count):
            yield supervisor.lost(task, str(line)) if isinstance(line, WorkerLost) else line


def _task(config: RunConfig, code: Callable[[str], bytes], submission: Submission) -> GradeTask:
    """Return a supervisor's task, with a digest of all that the result depends on."""
    source = source_of(submission)
    seed = config.seed if config.key is None else derive(config.key, submission.student, submission.slug)
    text = source.text if isinstance(source, Source) else str(source).encode()
    form = type(source).__name__ + (".ipynb" if isinstance(source, Source) and source.notebook else "")
    remark = source.remark if isinstance(source, Source) else ""
    words = form, submission.student, submission.slug, str(seed), remark
    parts = *map(str.encode, words), text, code(submission.slug)  # hashed with their lengths, to keep them distinct
    digest = hashlib.sha256(b"".join(len(part).to_bytes(8) + part for part in parts)).hexdigest()
    return GradeTask(config.course, submission.student, submission.slug, seed, source, digest, submission.path is None)


def _code_digests(config: RunConfig) -> Callable[[str], bytes]:
    """Return a function from slug to a digest of the limits, isolation, platform, libraries and the grader's code."""
    kept_apart = config.cluster.isolation if config.cluster else isolation()
    names = config.limits, kept_apart, sys.version, platform.machine(), _installed(), config.speed
    engine = hashlib.sha256(repr(names).encode() + assignments.engine_digest()).digest()
    return functools.cache(lambda slug: assignments.checks_digest(config.course, slug) + engine)


def _installed() -> list[str]:
    """Return names and versions of the installed libraries from their folders; faster than importlib.metadata."""
    return sorted(info.name for folder in sys.path if folder for info in Path(folder).glob("*-info"))
