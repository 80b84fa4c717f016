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
import traceback
from collections.abc import Callable, Iterable, Iterator, Sequence
from concurrent.futures import Executor, Future, ThreadPoolExecutor
from dataclasses import dataclass
from functools import partial
from itertools import islice
from queue import Empty, SimpleQueue
from typing import Any, TypeVar

from tam570.values import Function
from tam570_grader.errors import Over
from tam570_grader.sandbox.launch import hide_from_submissions
from tam570_grader.sandbox.pool import TRIES, sandboxes

PREFETCH = 2  # bunches of tasks a job that are handed out: one is worked on, one waits
CHUNK = 8  # tasks at most: to hand one out costs the head more than to read it
SERVE = "import sys; from tam570_grader.grading.executor import serve; serve(int(sys.argv[1]))"
HEARD = 0.5  # s, in which an interrupt is heard
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
    """Yield each task with its number and its outcome, as soon as that is there; those of a lost process are repeated.

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
        self._jobs, self._idle, self._lock, self._over = jobs, SimpleQueue[_Process | None](), threading.Lock(), False
        self._all = list[_Process]()

    def submit(self, work: Function, /, *args: Any, **kwargs: Any) -> Future[Any]:
        while len(self._all) < self._jobs:  # before there are threads
            self._idle.put(self._start())
        return super().submit(self._done_there, (work, args, kwargs))

    def _start(self) -> "_Process":
        with self._lock:
            if self._over:
                raise WorkerLost("the run has ended")
            self._all.append(process := _Process(self._all))
        return process

    def _done_there(self, order: Any) -> Any:
        process = self._idle.get()
        try:
            process = process or self._start()
            worked, outcome = process.done(order)
        except WorkerLost:
            process = None
            raise
        finally:
            self._idle.put(process)
        if not worked:
            raise outcome
        return outcome

    def shutdown(self, wait: bool = True, *, cancel_futures: bool = False) -> None:
        """End the processes at once, whatever they do: who wants outcomes has waited for them."""
        with self._lock:
            self._over = True
        for process in self._all:
            process.kill()
        super().shutdown(wait=True, cancel_futures=True)
        for process in self._all:
            process.close()
        with sandboxes():
            pass


def forks() -> bool:
    """Return whether processes are forked from this one: on Linux, without other threads; macOS stands no fork."""
    return sys.platform == "linux" and threading.active_count() == 1


class _Process:
    """A process of ours that does one thing at a time; a fork, where that is safe, has all that this one has loaded."""

    def __init__(self, others: "Sequence[_Process]") -> None:
        self._socket, child_end = socket.socketpair()
        self._file = self._socket.makefile("rwb")
        with child_end:
            self._popen = None if forks() else _spawn(child_end)
            self._id = self._popen.pid if self._popen else _fork()
            if self._id == 0:
                for process in (self, *others):  # or none would notice that this end is closed
                    process.hang_up()
                _serve_forked(child_end)

    def done(self, order: Any) -> tuple[bool, Any]:
        """Return whether it worked, and the outcome or the exception."""
        try:
            pickle.dump(order, self._file, pickle.HIGHEST_PROTOCOL)
            self._file.flush()
            reply: tuple[bool, Any] = pickle.load(self._file)
        except (EOFError, OSError, pickle.UnpicklingError):
            raise WorkerLost("the process that graded it died") from None
        return reply

    def kill(self) -> None:
        os.kill(self._id, signal.SIGKILL)  # one that has ended waits for `close`

    def hang_up(self) -> None:
        with contextlib.suppress(OSError):  # what it has not taken is lost with it
            self._file.close()
        self._socket.close()

    def close(self) -> None:
        self.hang_up()
        if self._popen:
            self._popen.wait()
        else:
            os.waitpid(self._id, 0)


def _fork() -> int:
    """Fork. A signal that comes meanwhile is heard after it: Python drops what is raised in what it runs at a fork."""
    before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT, signal.SIGTERM, signal.SIGHUP})
    try:
        return os.fork()
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


def _spawn(line: socket.socket) -> subprocess.Popen[bytes]:
    """Start a process that imports what it needs by itself."""
    return subprocess.Popen(
        [sys.executable, "-c", SERVE, str(line.fileno())],
        pass_fds=[line.fileno()],
        env={**os.environ, "PYTHONPATH": os.pathsep.join(filter(None, sys.path))},
        stdin=subprocess.DEVNULL,
        stdout=subprocess.DEVNULL,
        start_new_session=True,  # Ctrl-C is the parent's to hear
    )


def _serve_forked(line: socket.socket) -> None:
    """Live as a process that was forked; never returns."""
    try:
        os.setsid()
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            signal.signal(number, signal.SIG_DFL)
        nowhere = os.open(os.devnull, os.O_RDWR)
        for standard in range(2):
            os.dup2(nowhere, standard)
        serve(line.detach())
    except BaseException:
        traceback.print_exc()
    finally:
        os._exit(0)


def serve(number: int) -> None:
    """Live as a process: do what comes over the socket of this number, until the other end is closed."""
    hide_from_submissions()
    with socket.socket(fileno=number) as line, line.makefile("rwb") as file, sandboxes():
        threading.Thread(target=_end_with, args=[line.fileno()], daemon=True).start()
        with contextlib.suppress(EOFError, OSError):
            while True:
                work, args, kwargs = pickle.load(file)  # of our parent: no student's bytes are ever unpickled
                try:
                    reply = True, work(*args, **kwargs)
                except (Exception, Over) as error:
                    reply = False, error
                pickle.dump(reply, file, pickle.HIGHEST_PROTOCOL)
                file.flush()


def _end_with(line: int) -> None:
    """End when the other end of the line is closed; the sandbox ends with its parent."""
    watch = select.poll()
    watch.register(line, 0)  # that it is closed is told unasked
    watch.poll()
    os.kill(os.getpid(), signal.SIGKILL)
