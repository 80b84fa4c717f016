"""A run of the grader: hands submissions to supervisors, and writes down what they give back.

The head reads bytes, hands out and writes; whatever takes time is done by the supervisors. What is known already is
not graded again.
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

FEW = 4  # submissions a process, for which to start one repays


@dataclass(frozen=True)
class RunConfig:
    """What is graded and how; by default nothing yet, by the installed course, with a seed that nobody can guess."""

    course: Path = field(default_factory=assignments.find)
    submissions: Sequence[Submission] = ()
    seed: int = field(default_factory=new_seed)
    jobs: int = field(default_factory=cores)
    limits: ResourceLimits = ResourceLimits()
    hidden: Sequence[Path] = ()  # what no submission may see
    speed: bool = False  # measure run time against error too
    key: bytes | None = None  # varies the hidden inputs from student to student; `seed` is then not used
    cluster: "Cluster | None" = None  # None: this machine

    def seed_of(self, submission: Submission) -> int:
        """Return the seed of a submission's hidden inputs: the class's, else one that only the key tells."""
        if self.key is None:
            return self.seed
        return derive(self.key, submission.student, submission.slug)


def grade(paths: Iterable[str | Path], config: RunConfig) -> Iterator[Result]:
    """Yield the results of what is at these paths: see `tam570_grader.grade`."""
    places = [Path(path) for path in paths]
    everyone = submissions(places, assignments.slugs(config.course))
    hidden = [config.course, *config.hidden, *(folder.resolve() for folder in places)]
    for record in records(replace(config, submissions=everyone, hidden=hidden)):
        yield result_records.read(record)


def records(config: RunConfig, store: ResultStore | None = None, old: Sequence[Results] = ()) -> Iterator[Record]:
    """Yield the result lines, each as soon as it is in the store; what is there or in old ones is not graded again."""
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
    # a zygote's import of a package pays off from the second submission that uses it
    preload = [name for name, count in users.items() if count > 1]
    tasks = (_task(config, code, submission) for submission in fresh)  # read once more: a class may fill the memory
    slugs = sorted({submission.slug for submission in fresh if submission.path})
    for line in lines(config, tasks, len(fresh), slugs, preload):
        record = json.loads(line)
        if store is not None:
            store.add(record, line)
        yield record


def digests(config: RunConfig) -> Iterator[tuple[str, str, str]]:
    """Student, assignment and digest of each submission: of all that its result depends on."""
    code = _code_digests(config)
    for submission in config.submissions:
        yield submission.student, submission.slug, _task(config, code, submission).digest


def lines(
    config: RunConfig, tasks: Iterable[GradeTask], count: int, slugs: Sequence[str], preload: Sequence[str] = ()
) -> Iterator[bytes]:
    """Yield the result lines of these tasks, as soon as each is there; an interrupt ends all supervisors.

    slugs : the assignments of those that can be read
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
        hidden = () if config.cluster else tuple(config.hidden)  # nothing of ours is there but the course
        shared = None  # a folder for dear answers, where several processes of this machine need the same
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
    """Return what a supervisor gets, with a digest of all that the result depends on."""
    source, seed = source_of(submission), config.seed_of(submission)
    text = source.text if isinstance(source, Source) else str(source).encode()
    form = type(source).__name__ + (".ipynb" if isinstance(source, Source) and source.notebook else "")
    words = form, submission.student, submission.slug, str(seed)
    parts = *map(str.encode, words), text, code(submission.slug)  # with their lengths: no two lists are the same text
    digest = hashlib.sha256(b"".join(len(part).to_bytes(8) + part for part in parts)).hexdigest()
    return GradeTask(config.course, submission.student, submission.slug, seed, source, digest, submission.path is None)


def _code_digests(config: RunConfig) -> Callable[[str], bytes]:
    """Of the limits, of what keeps submissions apart, and of all code, by the name of the assignment."""
    kept_apart = config.cluster.isolation if config.cluster else isolation()
    names = config.limits, kept_apart, sys.version, platform.machine(), _installed(), config.speed
    engine = hashlib.sha256(repr(names).encode() + assignments.engine_digest()).digest()
    return functools.cache(lambda slug: assignments.checks_digest(config.course, slug) + engine)


def _installed() -> list[str]:
    """Names and versions of the libraries, by their folders: importlib.metadata takes longer."""
    return sorted(info.name for folder in sys.path if folder for info in Path(folder).glob("*-info"))
