"""Grade submissions on other machines with dask.distributed.

Workers need only the installed package: each gets the checks when it joins the cluster, at any time, and each task
contains the bytes of its submission.
"""

import contextlib
import functools
import importlib
import importlib.util
import logging
import time
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import CancelledError
from dataclasses import dataclass
from pathlib import Path
from typing import Any, TypeAlias

from tam570_grader.errors import UsageError, say
from tam570_grader.grading.executor import PREFETCH, TaskExecutor
from tam570_grader.sandbox.launch import isolation

Dask: TypeAlias = Any  # a Dask client or Security; distributed has no type annotations

QUERY_INTERVAL = 2.0  # s between queries of the number of workers
LEAST = 4  # chunks of tasks in flight, however few workers there are
PATIENCE = 20  # s, timeout of the connection to a scheduler
GOODBYE = 5  # s, timeout of closing it
CERTIFICATES = ("certificate.pem", "key.pem")  # only a holder of the key can join the cluster
UNSAFE = (
    "{address}: whoever reaches a scheduler without certificates can run code on it. Run "
    "`tam570-grader certificates DIR`, start scheduler and workers as it says, and name "
    "--cluster tls://HOST:PORT --certificates DIR"
)


@dataclass(frozen=True)
class Cluster:
    """Address of a Dask scheduler, and what is needed to use its workers."""

    address: str  # tls://HOST:PORT of a scheduler, or "local"
    certificates: Path | None = None
    unconfined: bool = False  # workers without bubblewrap may grade

    def __post_init__(self) -> None:
        if importlib.util.find_spec("distributed") is None:
            raise UsageError("--cluster needs dask.distributed: pip install 'tam570[cluster]'")
        if not self.is_local and not (self.address.startswith("tls://") and self.certificates):
            raise UsageError(UNSAFE.format(address=self.address))

    @property
    def is_local(self) -> bool:
        return self.address == "local"

    @property
    def isolation(self) -> str:
        """Expected isolation of submissions on the workers, as part of each result's digest."""
        return isolation() if self.unconfined else "bubblewrap"

    @contextlib.contextmanager
    def executor(self, course: Path, slugs: Sequence[str], jobs: int) -> Iterator[TaskExecutor]:
        """Send these assignments to the workers and yield their executor; UsageError if a worker cannot grade."""
        from distributed.comm.core import CommClosedError
        from distributed.scheduler import KilledWorker

        from tam570_grader.grading.cluster_worker import CoursePlugin, course_for, refusal, there

        for name in ("distributed", "distributed.client", "tornado.application"):
            logging.getLogger(name).setLevel(logging.CRITICAL)  # errors that matter are also raised
        with contextlib.ExitStack() as stack:
            client = self._client(stack, jobs)
            stack.callback(_left, client)
            sent: CoursePlugin = course_for(course, slugs, self.unconfined)
            client.register_plugin(sent, name=sent.name)
            refusals = client.run(refusal, sent.name)  # for workers that join later, `there` raises
            if not refusals:
                say(f"tam570-grader: no worker has joined {self.address} yet; waiting for one", error=True)
            for worker, why in refusals.items():
                if why:
                    raise UsageError(f"the worker {worker} cannot grade: {why}")
            try:
                yield TaskExecutor(
                    client.get_executor(pure=False),
                    _prefetch(client),
                    (KilledWorker,),
                    lambda work: functools.partial(there, sent.name, work),
                )
            except (CancelledError, CommClosedError):  # raised by a task, or by a query of the scheduler
                raise ConnectionError(f"the scheduler at {self.address} was lost") from None

    def _client(self, stack: contextlib.ExitStack, jobs: int) -> Dask:
        dask = importlib.import_module("distributed")
        if self.is_local:
            security = dask.Security.temporary()
            cluster = dask.LocalCluster(
                n_workers=jobs,
                threads_per_worker=1,
                security=security,
                protocol="tls://",
                dashboard_address="127.0.0.1:0",  # any free port
                silence_logs=logging.CRITICAL,
            )
            return dask.Client(stack.enter_context(cluster), security=security, set_as_default=False)
        try:
            assert self.certificates is not None
            certificate, key = certificate_and_key(self.certificates)
            tls = {"tls_ca_file": certificate, "tls_client_cert": certificate, "tls_client_key": key}
            security = dask.Security(require_encryption=True, **tls)
            return dask.Client(self.address, security=security, timeout=PATIENCE, set_as_default=False)
        except (OSError, TimeoutError) as error:
            raise UsageError(f"no scheduler lets us in at {self.address}: {error}") from None


def _left(client: Dask) -> None:
    """Close the client; ignore a timeout, as the scheduler may be lost."""
    with contextlib.suppress(TimeoutError):
        client.close(timeout=GOODBYE)


def certificate_and_key(folder: Path) -> tuple[str, str]:
    """Return the paths of the certificate and the key in a folder; raise UsageError if one is missing."""
    paths = [folder / name for name in CERTIFICATES]
    if lacking := [path for path in paths if not path.is_file()]:
        raise UsageError(f"{lacking[0]} is not there; make it with: tam570-grader certificates {folder}")
    return str(paths[0]), str(paths[1])


def _prefetch(client: Dask) -> Callable[[], int]:
    """Return a function that gives the number of chunks to keep in flight, from the current number of workers."""

    @functools.lru_cache(maxsize=1)
    def prefetch(interval: int) -> int:
        threads: int = sum(client.nthreads().values())
        return max(LEAST, PREFETCH * threads)

    return lambda: prefetch(int(time.monotonic() / QUERY_INTERVAL))
