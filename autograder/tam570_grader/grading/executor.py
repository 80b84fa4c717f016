"""Executors of the standard shape: in this process, or with a process for each job.

A process of ours that dies costs its task a try, and nothing else: concurrent.futures gives up the whole pool then.
Processes talk over a pair of sockets that nobody else can open. Each ends when its parent does, however that ended.
"""

import contextlib
import os
import pickle
import select
import signal
import socket
import subprocess
import sys
import threading
from collections.abc import Callable, Iterable, Iterator, Sequence
from concurrent.futures import Executor, Future, ThreadPoolExecutor
from dataclasses import dataclass
from functools import partial
from itertools import islice
from queue import Empty, SimpleQueue
from typing import Any, TypeVar

from tam570.values import Function
from tam570_grader.sandbox.launch import hide_from_submissions
from tam570_grader.sandbox.pool import TRIES, sandboxes

PREFETCH = 2  # bunches of tasks a job that are handed out: one is worked on, one waits
CHUNK = 8  # tasks at most: to hand one out costs the head more than to read it
SERVE = "from tam570_grader.grading.executor import serve; serve()"
HEARD = 0.5  # s, in which an interrupt is heard
PATIENCE = 5  # s, for a process to end by itself
T = TypeVar("T")
Outcome = TypeVar("Outcome")


def cores() -> int:
    """Return the processors that this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


class WorkerLost(Exception):
    """The process that worked on a task has died."""


@dataclass(frozen=True)
class TaskExecutor:
    """Who does the work: an executor, and how to treat it."""

    pool: Executor
    prefetch: Callable[[], int]  # how many tasks may be handed out at a time
    lost: tuple[type[Exception], ...] = (WorkerLost,)  # raised for a task whose process has died
    sent: Callable[[Function], Function] = lambda work: work  # what is submitted to have a work done


@contextlib.contextmanager
def executor(jobs: int) -> Iterator[TaskExecutor]:
    """So many processes of this machine; for a single job, this process."""
    with _Processes(jobs) if jobs > 1 else _Here() as pool:
        yield TaskExecutor(pool, lambda: PREFETCH * jobs if jobs > 1 else 1)


def run_tasks(
    executor: TaskExecutor, work: Callable[[T], Outcome], tasks: Iterable[T], count: int = 0
) -> Iterator[tuple[int, T, Outcome | WorkerLost]]:
    """Yield each task with its number and its outcome, as soon as that is there.

    The tasks of a lost process are repeated.

    tasks : read only when they can be handed out
    count : how many there are, if known; many are handed out in bunches, which become smaller towards the end
    """
    remaining, waiting = enumerate(tasks), dict[Future[list[Outcome]], tuple[list[tuple[int, T]], int]]()
    sent, ended = partial(_each, executor.sent(work)), SimpleQueue[Future[list[Outcome]]]()

    def hand_out(chunk: list[tuple[int, T]], tries: int = 1) -> int:
        future = executor.pool.submit(sent, [task for _, task in chunk])
        waiting[future] = chunk, tries
        future.add_done_callback(ended.put)
        return len(chunk)

    while True:
        while len(waiting) < (prefetch := executor.prefetch()) and (
            chunk := [*islice(remaining, _together(count, prefetch))]
        ):
            count -= hand_out(chunk)
        if not waiting:
            return
        future = _next(ended)
        chunk, tries = waiting.pop(future)
        try:
            outcomes: list[Outcome | WorkerLost] = [*future.result()]
        except executor.lost as lost:
            if len(chunk) > 1:  # it shows which of them it was
                for item in chunk:
                    hand_out([item])
                continue
            if tries < TRIES:
                hand_out(chunk, tries + 1)
                continue
            outcomes = [WorkerLost(str(lost))]
        for (number, task), outcome in zip(chunk, outcomes, strict=True):
            yield number, task, outcome


def _next(ended: SimpleQueue[Outcome]) -> Outcome:
    """Return the next that ends. An interrupt that comes just before a wait is heard after it: no wait is long."""
    while True:
        with contextlib.suppress(Empty):
            return ended.get(timeout=HEARD)


def _each(work: Callable[[T], Outcome], tasks: Sequence[T]) -> list[Outcome]:
    return [work(task) for task in tasks]


def _together(remaining: int, prefetch: int) -> int:
    """Return how many of the tasks that are left to hand out now: the processes shall end at the same time."""
    return max(1, min(CHUNK, remaining // (2 * prefetch))) if prefetch > 1 else 1


def in_order(executor: TaskExecutor, work: Callable[[T], Outcome], tasks: Iterable[T]) -> Iterator[Outcome]:
    """Yield what the work makes of each task, in the tasks' order; Lost where processes died."""
    early, due = dict[int, Outcome](), 0
    for number, _, outcome in run_tasks(executor, work, tasks):
        if isinstance(outcome, WorkerLost):
            raise outcome
        early[number] = outcome
        while due in early:
            yield early.pop(due)
            due += 1


class _Here(Executor):
    """Does a task at once, in this thread."""

    def submit(self, work: Function, /, *args: Any, **kwargs: Any) -> Future[Any]:
        future = Future[Any]()
        try:
            future.set_result(work(*args, **kwargs))
        except Exception as error:
            future.set_exception(error)
        return future

    def shutdown(self, wait: bool = True, *, cancel_futures: bool = False) -> None:
        with sandboxes():
            pass


class _Processes(ThreadPoolExecutor):
    """A thread for each process: it hands over a task and waits for the outcome."""

    def __init__(self, jobs: int) -> None:
        super().__init__(jobs)
        self._mine, self._all, self._lock, self._over = threading.local(), list[_Process](), threading.Lock(), False

    def submit(self, work: Function, /, *args: Any, **kwargs: Any) -> Future[Any]:
        return super().submit(self._done_there, (work, args, kwargs))

    def _done_there(self, order: Any) -> Any:
        if getattr(self._mine, "process", None) is None:
            with self._lock:
                if self._over:
                    raise WorkerLost("the run has ended")
                self._mine.process = _Process()
                self._all.append(self._mine.process)
        try:
            worked, outcome = self._mine.process.done(order)
        except WorkerLost:
            self._mine.process = None
            raise
        if not worked:
            raise outcome
        return outcome

    def shutdown(self, wait: bool = True, *, cancel_futures: bool = False) -> None:
        """End the processes at once, whatever they do: who wants outcomes has waited for them."""
        with self._lock:
            self._over = True
        for process in self._all:
            process.hang_up()
        super().shutdown(wait=True, cancel_futures=True)
        for process in self._all:
            process.close()


class _Process:
    """A process of ours that does what it is told, one thing at a time."""

    def __init__(self) -> None:
        self._socket, child_end = socket.socketpair()
        self._file = self._socket.makefile("rwb")
        with child_end:
            self._process = subprocess.Popen(
                [sys.executable, "-c", SERVE, str(child_end.fileno())],
                pass_fds=[child_end.fileno()],
                env={**os.environ, "PYTHONPATH": os.pathsep.join(filter(None, sys.path))},
                stdin=subprocess.DEVNULL,
                stdout=subprocess.DEVNULL,
                start_new_session=True,  # Ctrl-C is the parent's to hear
            )

    def done(self, order: Any) -> tuple[bool, Any]:
        """Return whether it worked, and the outcome or the exception."""
        try:
            pickle.dump(order, self._file, pickle.HIGHEST_PROTOCOL)
            self._file.flush()
            reply: tuple[bool, Any] = pickle.load(self._file)
        except (EOFError, OSError, pickle.UnpicklingError):
            raise WorkerLost("the process that graded it died") from None
        return reply

    def hang_up(self) -> None:
        with contextlib.suppress(OSError):
            self._socket.shutdown(socket.SHUT_RDWR)

    def close(self) -> None:
        with contextlib.suppress(OSError):  # what it has not taken is lost with it
            self._file.close()
        self._socket.close()
        try:
            self._process.wait(PATIENCE)
        except subprocess.TimeoutExpired:
            self._process.kill()
            self._process.wait()


def serve() -> None:
    """Live as a process: do what comes over the socket, until the other end is closed."""
    hide_from_submissions()
    with socket.socket(fileno=int(sys.argv[1])) as line, line.makefile("rwb") as file, sandboxes():
        threading.Thread(target=_end_with, args=[line.fileno()], daemon=True).start()
        with contextlib.suppress(EOFError, OSError):
            while True:
                work, args, kwargs = pickle.load(file)  # of our parent: no student's bytes are ever unpickled
                try:
                    reply = True, work(*args, **kwargs)
                except Exception as error:
                    reply = False, error
                pickle.dump(reply, file, pickle.HIGHEST_PROTOCOL)
                file.flush()


def _end_with(line: int) -> None:
    """End when the other end of the line is closed; the sandbox ends with its parent."""
    watch = select.poll()
    watch.register(line, 0)  # that it is closed is told unasked
    watch.poll()
    os.kill(os.getpid(), signal.SIGKILL)
