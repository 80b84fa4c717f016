"""Executors with the interface of concurrent.futures: in this process, or with several worker processes.

If a worker process dies, only its task is retried, whereas ProcessPoolExecutor breaks the whole pool. Processes
communicate over socket pairs that no other process can open. A worker ends when its parent does, for any reason.
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

PREFETCH = 2  # chunks in flight per job: one in work, one waiting
CHUNK = 8  # most tasks per chunk; sending a task costs the coordinator more than reading its submission
SERVE = "import sys; from tam570_grader.grading.executor import serve; serve(int(sys.argv[1]))"
LONGEST_WAIT = 0.5  # s, longest wait, so that an interrupt is handled soon
T = TypeVar("T")
Outcome = TypeVar("Outcome")


def cores() -> int:
    """Return the number of processors that this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


class WorkerLost(Exception):
    """The process that was working on a task has died."""


@dataclass(frozen=True)
class TaskExecutor:
    """An executor, and what `run_tasks` needs to know of it."""

    pool: Executor
    prefetch: Callable[[], int]  # how many chunks of tasks may be in flight
    lost: tuple[type[Exception], ...] = (WorkerLost,)  # raised for a task whose process has died
    sent: Callable[[Function], Function] = lambda work: work  # from a function to the function that is submitted


@contextlib.contextmanager
def executor(jobs: int) -> Iterator[TaskExecutor]:
    """Yield an executor with `jobs` worker processes on this machine; for one job, it runs in this process."""
    with _Processes(jobs) if jobs > 1 else _Here() as pool:
        yield TaskExecutor(pool, lambda: PREFETCH * jobs if jobs > 1 else 1)


def run_tasks(
    executor: TaskExecutor, work: Callable[[T], Outcome], tasks: Iterable[T], count: int = 0
) -> Iterator[tuple[int, T, Outcome | WorkerLost]]:
    """Yield (number, task, outcome) of each task as it is done; retry tasks whose process died, then yield WorkerLost.

    tasks : an iterable, read only as fast as tasks can be submitted
    count : how many there are, if known; tasks are then sent in chunks, which become smaller towards the end
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
            if len(chunk) > 1:  # resubmit singly, to identify the task that kills its process
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
    """Return the next completed future. Wait in short intervals: a signal just before a wait is handled after it."""
    while True:
        with contextlib.suppress(Empty):
            return ended.get(timeout=LONGEST_WAIT)


def _each(work: Callable[[T], Outcome], tasks: Sequence[T]) -> list[Outcome]:
    return [work(task) for task in tasks]


def _together(remaining: int, prefetch: int) -> int:
    """Return the size of the next chunk: smaller towards the end, so that all processes finish at the same time."""
    return max(1, min(CHUNK, remaining // (2 * prefetch))) if prefetch > 1 else 1


def in_order(executor: TaskExecutor, work: Callable[[T], Outcome], tasks: Iterable[T]) -> Iterator[Outcome]:
    """Yield work(task) of each task, in the tasks' order; raise WorkerLost if a task's processes died."""
    early, due = dict[int, Outcome](), 0
    for number, _, outcome in run_tasks(executor, work, tasks):
        if isinstance(outcome, WorkerLost):
            raise outcome
        early[number] = outcome
        while due in early:
            yield early.pop(due)
            due += 1


class _Here(Executor):
    """Executor that runs each task in the calling thread when it is submitted."""

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
    """Thread pool in which each thread drives one worker process."""

    def __init__(self, jobs: int) -> None:
        super().__init__(jobs)
        self._jobs, self._idle, self._lock, self._over = jobs, SimpleQueue[_Process | None](), threading.Lock(), False
        self._all = list[_Process]()

    def submit(self, work: Function, /, *args: Any, **kwargs: Any) -> Future[Any]:
        while len(self._all) < self._jobs:  # before the pool has threads, so that workers can be forked
            self._idle.put(self._start())
        return super().submit(self._run_in_process, (work, args, kwargs))

    def _start(self) -> "_Process":
        with self._lock:
            if self._over:
                raise WorkerLost("the run has ended")
            self._all.append(process := _Process(self._all))
        return process

    def _run_in_process(self, order: Any) -> Any:
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
        """Kill all worker processes. Callers that need results must wait for their futures first."""
        with self._lock:
            self._over = True
        with sandboxes():  # they take as long to end as the processes, at the same time
            for process in self._all:
                process.kill()
        super().shutdown(wait=True, cancel_futures=True)
        for process in self._all:
            process.close()


def forks() -> bool:
    """Return whether workers are forked: only on Linux (fork is unsafe on macOS) and in a single-threaded process."""
    return sys.platform == "linux" and threading.active_count() == 1


class _Process:
    """A worker process that runs one task at a time; if forked, it has the modules and caches of this process."""

    def __init__(self, others: "Sequence[_Process]") -> None:
        self._socket, child_end = socket.socketpair()
        self._file = self._socket.makefile("rwb")
        with child_end:
            self._popen = None if forks() else _spawn(child_end)
            self._id = self._popen.pid if self._popen else _fork()
            if self._id == 0:
                for process in (self, *others):  # an inherited parent's end would keep that worker from seeing EOF
                    process.hang_up()
                _serve_forked(child_end)

    def done(self, order: Any) -> tuple[bool, Any]:
        """Run (function, args, kwargs) there; return (True, result) or (False, exception), or raise WorkerLost."""
        try:
            pickle.dump(order, self._file, pickle.HIGHEST_PROTOCOL)
            self._file.flush()
            reply: tuple[bool, Any] = pickle.load(self._file)
        except (EOFError, OSError, pickle.UnpicklingError):
            raise WorkerLost("the process that graded it died") from None
        return reply

    def kill(self) -> None:
        os.kill(self._id, signal.SIGKILL)  # a process that has ended keeps its id until `close` reaps it

    def hang_up(self) -> None:
        with contextlib.suppress(OSError):  # the process may have died before it read the buffered bytes
            self._file.close()
        self._socket.close()

    def close(self) -> None:
        self.hang_up()
        if self._popen:
            self._popen.wait()
        else:
            os.waitpid(self._id, 0)


def _fork() -> int:
    """Fork with signals blocked: Python discards exceptions that signal handlers raise in its at-fork callbacks."""
    before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT, signal.SIGTERM, signal.SIGHUP})
    try:
        return os.fork()
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


def _spawn(line: socket.socket) -> subprocess.Popen[bytes]:
    """Start a new Python interpreter that serves this socket."""
    return subprocess.Popen(
        [sys.executable, "-c", SERVE, str(line.fileno())],
        pass_fds=[line.fileno()],
        env={**os.environ, "PYTHONPATH": os.pathsep.join(filter(None, sys.path))},
        stdin=subprocess.DEVNULL,
        stdout=subprocess.DEVNULL,
        start_new_session=True,  # only the parent gets Ctrl-C
    )


def _serve_forked(line: socket.socket) -> None:
    """Run a forked worker process: detach it from the terminal, serve the socket, exit; never return."""
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
    """Run a worker process: execute the calls that arrive on this socket's file descriptor until its peer closes."""
    hide_from_submissions()
    with socket.socket(fileno=number) as line, line.makefile("rwb") as file, sandboxes():
        threading.Thread(target=_end_with, args=[line.fileno()], daemon=True).start()
        with contextlib.suppress(EOFError, OSError):
            while True:
                work, args, kwargs = pickle.load(file)  # only the parent writes here, never a submission
                try:
                    reply = True, work(*args, **kwargs)
                except (Exception, Over) as error:
                    reply = False, error
                pickle.dump(reply, file, pickle.HIGHEST_PROTOCOL)
                file.flush()


def _end_with(line: int) -> None:
    """Kill this process when the peer of a socket closes; its sandboxes end with it."""
    watch = select.poll()
    watch.register(line, 0)  # POLLHUP is reported even for an empty event mask
    watch.poll()
    os.kill(os.getpid(), signal.SIGKILL)
