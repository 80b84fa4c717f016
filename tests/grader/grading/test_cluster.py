"""A cluster of processes on this machine: if some of them die, the results still equal those without a cluster."""

import json
import os
import signal
import subprocess
import sys
import time
from contextlib import contextmanager
from importlib.util import find_spec

import pytest
from classes import HW08, hand_in, outcome, results

from tam570_grader import cli
from tam570_grader.sandbox.launch import isolation

pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(find_spec("distributed") is None, reason="no dask.distributed: pip install 'tam570[cluster]'"),
    pytest.mark.skipif(isolation() != "bubblewrap", reason="workers refuse without bubblewrap"),
]
STUDENTS = 24
ENDS = ("", "def skew(v): return v\n", "def (", "import time\ntime.sleep(0.3)\n")


@pytest.fixture(scope="module")
def certificates(tmp_path_factory):
    folder = tmp_path_factory.mktemp("keys") / "keys"
    assert cli.main(["certificates", str(folder)]) == 0
    assert {path.stat().st_mode & 0o077 for path in folder.iterdir()} == {0}
    return folder


@pytest.fixture(scope="module")
def tree(tmp_path_factory, solution_text):
    texts = {f"s{k:02}": f"{solution_text(HW08)}\n# {k}\n{ENDS[k % len(ENDS)]}" for k in range(STUDENTS)}
    return hand_in(tmp_path_factory.mktemp("class") / "submitted", texts)


@pytest.fixture(scope="module")
def alone(tree, tmp_path_factory):
    """Return the outcome of a run without a cluster."""
    out = tmp_path_factory.mktemp("alone")
    with grading(tree, out) as coordinator:
        assert coordinator.wait() == 0
    return outcome(out)


@contextmanager
def started(module, *arguments, **more):
    """Start a process; kill it at the end of the block if it still runs."""
    command = [sys.executable, "-m", module, *map(str, arguments)]
    with subprocess.Popen(command, text=True, stderr=subprocess.PIPE, stdout=subprocess.DEVNULL, **more) as process:
        try:
            yield process
        finally:
            process.kill()


def grading(tree, out, *arguments):
    return started("tam570_grader", "grade", tree, "--out", out, "--seed", 570, "--jobs", 1, *arguments)


class Net:
    """A scheduler and its workers, with certificates."""

    def __init__(self, keys, folder):
        self._tls = ["--tls-ca-file", keys / "certificate.pem", "--tls-cert", keys / "certificate.pem"]
        self._tls += ["--tls-key", keys / "key.pem"]
        self.folder, self._file = folder, folder / "scheduler.json"
        self._options = ["--certificates", keys]

    def scheduler(self):
        self._file.unlink(missing_ok=True)
        address = ["--host", "127.0.0.1", "--port", 0, "--protocol", "tls", "--no-dashboard"]
        return started("dask", "scheduler", *address, "--scheduler-file", self._file, *self._tls)

    @property
    def address(self):
        wait_for(lambda: self._file.exists() and self._file.read_text().rstrip().endswith("}"))  # completely written
        return json.loads(self._file.read_text())["address"]

    def worker(self, **more):
        options = ["--no-nanny", "--no-dashboard", "--nthreads", 1, "--local-directory", self.folder]
        return started("dask", "worker", self.address, *options, *self._tls, **more)

    def grading(self, tree, out, *more):
        return grading(tree, out, "--cluster", self.address, *self._options, *more)


@pytest.fixture
def net(certificates, tmp_path):
    return Net(certificates, tmp_path)


def wait_for(happens, seconds=600):
    deadline = time.monotonic() + seconds
    while not happens():
        assert time.monotonic() < deadline, "waited in vain"
        time.sleep(0.05)


def graded(out):
    return (out / "results.jsonl").read_text().count("\n") if (out / "results.jsonl").exists() else 0


def test_a_worker_that_is_killed_and_one_that_joins_late_change_nothing(net, tree, tmp_path, alone):
    out = tmp_path / "out"
    with net.scheduler(), net.worker() as first, net.grading(tree, out) as coordinator:
        wait_for(lambda: graded(out) >= 3)
        first.kill()
        with net.worker():
            assert coordinator.wait() == 0, coordinator.stderr.read()
    assert outcome(out) == alone


def test_a_head_that_is_killed_and_a_scheduler_that_is_lost_change_nothing(net, tree, tmp_path, alone):
    out = tmp_path / "out"
    with net.scheduler() as scheduler, net.worker():
        with net.grading(tree, out) as coordinator:
            wait_for(lambda: graded(out) >= 3)
            coordinator.kill()
        before = graded(out)
        with net.grading(tree, out) as coordinator:
            wait_for(lambda: graded(out) >= before + 3)
            scheduler.kill()
            assert coordinator.wait() == 1
            said = coordinator.stderr.read()
            assert "the scheduler at tls://" in said and "results kept" in said and "Traceback" not in said
    assert 6 <= graded(out) < STUDENTS
    with net.scheduler(), net.worker(), net.grading(tree, out) as coordinator:
        assert coordinator.wait() == 0, coordinator.stderr.read()
    assert outcome(out) == alone


def test_who_has_no_certificate_is_kept_out(net, tree, tmp_path, capsys):
    others = tmp_path / "others"
    assert cli.main(["certificates", str(others)]) == 0
    with net.scheduler():
        plain = net.address.replace("tls://", "tcp://")
        request = ["grade", str(tree), "--out", str(tmp_path / "out")]
        assert cli.main([*request, "--cluster", plain]) == 2
        assert "certificates DIR" in capsys.readouterr().err
        with net.grading(tree, tmp_path / "out", "--certificates", others) as coordinator:
            assert coordinator.wait() == 2
            assert "no scheduler lets us in" in coordinator.stderr.read()
        with started("tam570_grader", "certificates", others) as repeated:
            assert repeated.wait() == 2  # existing keys are not overwritten


def test_a_worker_without_bubblewrap_refuses_unless_told_otherwise(net, tree, tmp_path):
    item = tree / "s00"
    bare = tmp_path / "bin"
    bare.mkdir()
    with net.scheduler(), net.worker(env={**os.environ, "PATH": str(bare)}):
        with net.grading(item, tmp_path / "out") as coordinator:
            assert coordinator.wait() == 2
            assert "no bubblewrap" in coordinator.stderr.read()
        with net.grading(item, tmp_path / "out", "--unconfined") as coordinator:
            code, said = coordinator.wait(), coordinator.stderr.read()
    if os.geteuid() == 0 and "may not enter" in said:
        pytest.skip("root without bubblewrap cannot grade from a closed folder, on a cluster or off it")
    assert code == 0, said
    assert results(tmp_path / "out")[0]["isolation"] == "processes"


def test_a_cluster_on_this_machine_gives_the_same(tree, tmp_path, alone):
    out = tmp_path / "out"
    with grading(tree, out, "--cluster", "local") as coordinator:
        assert coordinator.wait() == 0, coordinator.stderr.read()
    assert outcome(out) == alone
    with grading(tree, tmp_path / "ended", "--cluster", "local") as coordinator:
        wait_for(lambda: graded(tmp_path / "ended") >= 3)
        coordinator.send_signal(signal.SIGINT)
        assert coordinator.wait() == 130, coordinator.stderr.read()
