"""Whose fault a death is: the guard's last word."""

import contextlib
import os
import socket
import subprocess
import sys
import threading

import pytest

from tam570_grader.protocol import jail

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
