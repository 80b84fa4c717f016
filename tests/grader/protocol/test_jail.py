"""Whose fault a death is: the guard's last word."""

import contextlib
import os
import socket
import subprocess
import sys
import threading

import pytest

from tam570_grader.protocol import jail
from tam570_grader.protocol.refusals import program

ASLEEP = [sys.executable, "-c", "import time; print(flush=True); time.sleep(60)"]
pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="grading needs Linux or macOS")


def last_word(happens):
    """What is told of a prisoner after something has happened to it, or to its worker."""
    leash, guards_end = socket.socketpair()
    lifeline, held = os.pipe()
    limits = jail.Limits(cpu=60, memory=2**30, file_size=2**20, processes=1, namespaces=True, user=None)
    with leash, guards_end, subprocess.Popen(ASLEEP, stdout=subprocess.PIPE) as child:
        child.stdout.readline()
        monitor = threading.Thread(target=jail.watch, args=(child.pid, guards_end, lifeline, limits))
        monitor.start()
        happens(child=child, leash=leash, lifeline=held)
        said = leash.recv(64).split()
        monitor.join()
        child.returncode = 0  # the guard has waited for it
    os.close(lifeline)
    with contextlib.suppress(OSError):
        os.close(held)
    return said[-1]


def test_one_that_dies_with_its_worker_is_not_to_blame():
    assert last_word(lambda lifeline, **_: os.close(lifeline)) == b"1"


def test_one_that_is_killed_by_a_stranger_is_not_to_blame():
    assert last_word(lambda child, **_: os.kill(child.pid, 9)) == b"1"


def test_one_that_is_killed_on_the_supervisors_order_is_to_blame():
    assert last_word(lambda leash, **_: leash.sendall(b"k")) == b"0"


def test_one_that_ends_by_itself_is_to_blame():
    assert last_word(lambda child, **_: os.kill(child.pid, 11)) == b"0"


linux = pytest.mark.skipif(sys.platform != "linux", reason="prctl and /proc are Linux's")
LIMITS = "jail.Limits(cpu=60, memory=2**30, file_size=2**20, processes=3, namespaces=False, user=None)"
RUNS_AWAY = f"""
import os, socket, time
from tam570_grader.protocol import jail
from tam570_grader.protocol.refusals import program
(leash, end), (lifeline, held), (told, tells) = socket.socketpair(), os.pipe(), os.pipe()
child = os.fork()
if child == 0:
    if os.fork() == 0:
        os.setsid()
        os.write(tells, str(os.getpid()).encode())
        time.sleep(60)
    print(os.read(told, 9).decode(), flush=True)
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
    """Also in a session of its own, with another parent."""
    (pid,) = printed(RUNS_AWAY)
    assert not os.path.exists(f"/proc/{pid}")


@linux
@pytest.mark.skipif(not program(signals=True, forks=True), reason="no filter for this machine")
def test_without_namespaces_a_submission_starts_and_signals_no_process():
    assert printed(REFUSED) == ["1", "1", "1"]  # EPERM
