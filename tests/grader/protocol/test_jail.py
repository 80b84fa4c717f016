"""The monitor reports who killed a sandbox process, and a submission leaves no process behind."""

import contextlib
import os
import socket
import subprocess
import sys
import threading

import pytest

from tam570_grader.protocol import jail
from tam570_grader.protocol.refusals import program
from tam570_grader.sandbox.process import SandboxProcess

ASLEEP = [sys.executable, "-c", "import time; print(flush=True); time.sleep(60)"]
pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="grading needs Linux or macOS")
DEATHS = {  # event: (how the test causes it, b"1" if the sandbox process is not to blame for its death)
    "it dies with its worker": (lambda lifeline, **_: os.close(lifeline), b"1"),
    "a stranger kills it": (lambda child, **_: os.kill(child.pid, 9), b"1"),
    "the supervisor has it killed": (lambda leash, **_: leash.sendall(b"k"), b"0"),
    "it ends by itself": (lambda child, **_: os.kill(child.pid, 11), b"0"),
}


@pytest.mark.parametrize(("happen", "word"), DEATHS.values(), ids=DEATHS)
def test_the_monitors_last_word_is_whose_fault_a_death_is(happen, word):
    leash, monitors_end = socket.socketpair()
    lifeline, held = os.pipe()
    limits = jail.Limits(cpu=60, memory=2**30, file_size=2**20, processes=1, namespaces=True, user=None)
    with leash, monitors_end, subprocess.Popen(ASLEEP, stdout=subprocess.PIPE) as child:
        child.stdout.readline()
        monitor = threading.Thread(target=jail.watch, args=(child.pid, monitors_end, lifeline, limits))
        monitor.start()
        happen(child=child, leash=leash, lifeline=held)
        reply = leash.recv(64).split()
        monitor.join()
        child.returncode = 0  # the monitor has reaped it
    os.close(lifeline)
    with contextlib.suppress(OSError):
        os.close(held)
    assert reply[-1] == word


@pytest.mark.parametrize("asks_first", [False, True])
@pytest.mark.parametrize("word", ["0", "1"])
def test_the_supervisor_hears_the_last_word_of_a_monitor_that_has_gone(word, asks_first):
    """On a busy machine, a monitor may end before the next order; the supervisor still reads its last message."""
    channel, leash, monitors_end = socket.socket(), *socket.socketpair()
    process = SandboxProcess(channel, leash, call_limit=1.0)
    monitors_end.sendall(f"0.25\n0.5 {word}\n".encode())
    monitors_end.close()
    with leash:
        assert not asks_first or [process.seconds(), process.seconds()] == [0.25, 0.5]
        assert process.end() == 0.5
    assert process.monitored and process.killed_from_outside == (word == "1")


linux = pytest.mark.skipif(sys.platform != "linux", reason="prctl and /proc are Linux's")
LIMITS = "jail.Limits(cpu=60, memory=2**30, file_size=2**20, processes=3, namespaces=False, user=None)"
RUNS_AWAY = f"""
import os, socket, time
from tam570_grader.protocol import jail
from tam570_grader.protocol.refusals import program
(leash, end), (lifeline, held), (hears, reports) = socket.socketpair(), os.pipe(), os.pipe()
child = os.fork()
if child == 0:
    if os.fork() == 0:
        os.setsid()
        os.write(reports, str(os.getpid()).encode())
        time.sleep(60)
    print(os.read(hears, 9).decode(), flush=True)
    os._exit(0)
jail.watch(child, end, lifeline, {LIMITS})
"""
REFUSED = """
import os
from tam570_grader.protocol.refusals import refuse_calls
refuse_calls(signals=True, forks=True)
for attempt in (os.fork, lambda: os.kill(os.getppid(), 0), lambda: os.posix_spawn("/bin/true", ["true"], {})):
    try:
        attempt()
        print("worked")
    except OSError as error:
        print(error.errno)
"""


def printed(script):
    done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    return done.stdout.split()


@linux
def test_without_namespaces_what_a_submission_leaves_behind_ends_with_it():
    """A process in another session and with another parent also ends with the submission."""
    (pid,) = printed(RUNS_AWAY)
    assert not os.path.exists(f"/proc/{pid}")


@linux
@pytest.mark.skipif(not program(signals=True, forks=True), reason="no filter for this machine")
def test_without_namespaces_a_submission_starts_and_signals_no_process():
    assert printed(REFUSED) == ["1", "1", "1"]  # EPERM
