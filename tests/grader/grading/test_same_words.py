"""Feedback does not depend on the speed of the machine: nor on the number of jobs: searches are counted, not timed."""

import contextlib
import os
import subprocess
import sys

import pytest
from classes import hand_in, outcome

from tam570_grader.audit.gradings import submissions

BUSY = 3  # loops for each processor: the grader has a quarter of it, at most


@contextlib.contextmanager
def busy_machine():
    loops = [subprocess.Popen([sys.executable, "-c", "while True: pass"]) for _ in range(BUSY * os.cpu_count())]
    try:
        yield
    finally:
        for loop in loops:
            loop.kill()
            loop.wait()


def grade(tree, out, jobs):
    command = [sys.executable, "-m", "tam570_grader", "grade", tree, "--out", out, "--seed", "570", "--jobs", jobs]
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL)


@pytest.mark.slow
def test_every_mistake_is_told_in_the_same_words_on_a_busy_machine(slug, course, solution_text, tmp_path):
    wrong = submissions(course, slug, "mistakes")
    texts = {name: f"{solution_text(slug)}\n\n{text}" for name, text in wrong.items()}
    tree = hand_in(tmp_path / "submitted", {**texts, **submissions(course, slug, "alternatives")}, slug)
    grade(tree, tmp_path / "calm", "1")
    with busy_machine():
        grade(tree, tmp_path / "busy", "2")
    assert outcome(tmp_path / "busy") == outcome(tmp_path / "calm")
