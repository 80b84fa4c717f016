"""`tam570-grader watch`: order of grading, attempts, restarts, and pages beside the submissions."""

import hashlib
import json
import os
import signal
import subprocess
import sys
import time

import classes
import pytest

from tam570_grader import cli
from tam570_grader.grading.watch import Arrival, Policy, Queue

pytest.importorskip("watchfiles")
SLUG = "hw08_axis_angle"
HALF = "\n\ndef rotate(r, axis, angle):\n    return np.asarray(r, float)\n"


@pytest.fixture
def hand_in(tmp_path, solution_text):
    def hand_in(student, more=""):
        classes.hand_in(tmp_path / "submitted", {student: solution_text(SLUG) + more})
        return tmp_path / "submitted" / student / SLUG / f"{SLUG}.py"

    return hand_in


@pytest.fixture
def watch(course, tmp_path):
    def watch(*options, source="submitted"):
        out = tmp_path / "results"
        command = ["--root", str(course), "watch", str(tmp_path / source), "--out", str(out), "--once", "--jobs", "1"]
        assert cli.main([*command, *map(str, options)]) == 0
        lines = [json.loads(line) for line in (out / "watch.jsonl").read_text().splitlines()]
        return [line for line in lines if line["event"] == "graded"]

    return watch


def scores(tmp_path):
    return {row["student"]: float(row["score"]) for row in classes.rows(tmp_path / "results" / "grades.csv")}


def test_each_attempt_has_its_own_inputs_and_the_best_counts(watch, hand_in, tmp_path, solution_text):
    hand_in("ann", HALF)
    hand_in("ben")
    work = classes.packed({f"{SLUG}.py": solution_text(SLUG)})
    classes.hand_in(tmp_path / "submitted", {"cy": work}, file="{0}_handin.zip")
    assert len(watch()) == 3
    hand_in("ann")
    hand_in("ben", HALF)
    attempts = watch()
    assert [(item["student"], item["attempt"]) for item in attempts[3:]] == [("ann", 2), ("ben", 2)]
    assert len({item["record"]["seed"] for item in attempts}) == 5
    assert scores(tmp_path) == {"ann": 10.0, "ben": 10.0, "cy": 10.0}
    assert len(watch()) == 5  # nothing new, nothing twice
    assert (tmp_path / "submitted" / "ben" / SLUG / f"{SLUG}-feedback.html").exists()
    assert (tmp_path / "submitted" / "cy" / f"{SLUG}_handin-feedback.html").exists()
    assert "ben" in (tmp_path / "results" / "status.html").read_text()


def test_our_page_beside_a_file_that_cannot_be_read_is_no_attempt(watch, tmp_path):
    classes.hand_in(tmp_path / "submitted", {"ann": b"Rar!"}, file="hw08.rar")
    assert len(watch()) == len(watch()) == 1


def test_a_file_that_tells_no_assignment_is_warned_of(watch, hand_in, tmp_path, capsys):
    hand_in("ann")
    classes.hand_in(tmp_path / "submitted", {"ben": "x"}, file="work.py")
    watch()
    assert "submitted/ben (it holds work.py) is not graded" in capsys.readouterr().err


def arrival(student, at):
    return Arrival(student, SLUG, f"{student}{at}", at, "", "", "")


def test_the_queue_keeps_the_order_over_a_restart_and_half_a_line(tmp_path):
    queue = Queue(tmp_path, Policy())
    for at, student in enumerate("cabca"):
        queue.take(arrival(student, float(at)))
    assert [item.student for item in queue.ready(9.0)] == ["c", "a", "b"]
    with open(tmp_path / "watch.jsonl", "ab") as file:
        file.write(b'{"event": "arr')
    restarted = Queue(tmp_path, Policy())
    assert restarted.arrivals == queue.arrivals and (tmp_path / "watch.jsonl").read_bytes().endswith(b"\n")
    restarted.log("graded", restarted.arrivals[0], attempt=1, graded_at=9.0, waited=1.0, record={"score": 1.0})
    assert [item.student for item in Queue(tmp_path, Policy()).ready(9.0)] == ["a", "b", "c"]
    later = Queue(tmp_path, Policy(every=10.0))
    assert [item.student for item in later.ready(10.0)] == ["a", "b"] and later.ready(19.0)[2].student == "c"


def test_a_page_is_written_through_no_link(watch, hand_in, tmp_path):
    path = hand_in("ann")
    (tmp_path / "mine").write_text("mine")
    (path.parent / f"{SLUG}-feedback.html").symlink_to(tmp_path / "mine")
    watch()
    assert (tmp_path / "mine").read_text() == "mine"
    assert "Attempt 1" in (path.parent / f"{SLUG}-feedback.html").read_text()


def test_an_exchange_of_nbgrader(watch, tmp_path, solution_text):
    """Files are where ExchangeSubmit.copy_files and ExchangeReleaseFeedback.copy_files of nbgrader 0.9 write them."""
    for n, student in enumerate(("ann", "ben")):
        folder = tmp_path / "exchange" / "inbound" / f"{student}+{SLUG}+2026-09-14 10:00:0{n} UTC+abc"
        classes.hand_in(folder.parent, {folder.name: solution_text(SLUG)}, file="{0}.py")
        (folder / f"{SLUG}.ipynb").write_text('{"cells": [], "metadata": {}, "nbformat": 4, "nbformat_minor": 5}')
        (folder / "timestamp.txt").write_text("2026-09-14 10:00:00 UTC")
        if student == "ann":
            (folder / "submission_secret.txt").write_text("secret")
    (done,) = watch(source="exchange")
    assert (done["student"], done["record"]["score"]) == ("ann", 10.0)
    name = hashlib.md5(b"secret" + SLUG.encode()).hexdigest()
    assert "Attempt 1" in (tmp_path / "exchange" / "feedback" / f"{name}.html").read_text()


@pytest.mark.slow
def test_a_watch_that_is_killed_loses_nothing(course, tmp_path, hand_in):
    (tmp_path / "submitted").mkdir()
    out = tmp_path / "results"
    command = [sys.executable, "-m", "tam570_grader", "--root", str(course), "watch", str(tmp_path / "submitted")]
    command += ["--out", str(out), "--jobs", "2"]
    for kill in range(6):
        process = subprocess.Popen(command, stderr=subprocess.DEVNULL)
        for n in range(5):
            hand_in(f"s{kill}{n}", f"\n# {kill}\n")
        time.sleep(0.3 + 0.4 * kill)
        process.send_signal(signal.SIGKILL)
        process.wait()
    assert subprocess.run([*command, "--once"]).returncode == 0
    lines = [json.loads(line) for line in (out / "watch.jsonl").read_text().splitlines()]
    graded = [line["student"] for line in lines if line["event"] == "graded"]
    everybody = {f"s{kill}{n}" for kill in range(6) for n in range(5)}
    assert sorted(graded) == sorted(everybody) and scores(tmp_path) == dict.fromkeys(everybody, 10.0)
    assert {path.parts[-3] for path in (tmp_path / "submitted").rglob("*-feedback.html")} == everybody
    assert not os.path.exists(out / "watch.jsonl.new")
