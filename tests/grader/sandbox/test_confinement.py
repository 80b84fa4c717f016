"""A submission affects no other: its errors at import, its folder, hidden files, and machines without confinement."""

import json
import re
import subprocess
import sys
from pathlib import Path

import pytest
from classes import HW08, hand_in, notebook
from parameters import first

from tam570_grader import cli
from tam570_grader.checks import assignments
from tam570_grader.grading import submissions
from tam570_grader.grading.run_checks import graded
from tam570_grader.grading.supervisor import GradeTask, WorkerConfig, result
from tam570_grader.sandbox import zygote
from tam570_grader.sandbox.launch import isolation, other_packages
from tam570_grader.sandbox.pool import sandboxes
from tam570_grader.sandbox.student import Source
from tam570_grader.sandbox.zygote import ResourceLimits, Zygote

confined = pytest.mark.skipif(isolation() != "bubblewrap", reason="needs bubblewrap and namespaces")
KILLED_AT_FIRST = """#!/bin/sh
echo >> {count}
[ $(wc -l < {count}) -gt {deaths} ] || kill -9 $$
"""
DIGS = """
import gc, types
gc.unfreeze()
found = [one for one in gc.get_objects() if isinstance(one, types.FunctionType)]
if any(str(one.__module__).startswith("tam570.rotations") for one in found):
    raise SystemExit("found")
"""
SEEN = """
import os
from tam570_grader.sandbox import launch
launch.isolation = lambda: "processes"
launch.hide_from_submissions()
print(open("/proc/self/cmdline").read().replace("\\0", " "), os.stat("/proc/self/environ").st_uid)
"""


@pytest.mark.parametrize(
    ("text", "status", "words"),
    [
        ("import nunpy", "unreadable", "ModuleNotFoundError at line 1: No module named 'nunpy'$"),
        ("from numpy import ar_ray", "unreadable", "ImportError at line 1: cannot import name 'ar_ray' from 'numpy'$"),
        ("\nx = whatever", "unreadable", "NameError at line 2: name 'whatever' is not defined$"),
        ("def skew(v:", "unreadable", r"SyntaxError at line 1: '\(' was never closed$"),
        # messages that the file writes itself are not quoted
        ("raise ValueError('1.25')", "unreadable", "ValueError at line 1$"),
        ("raise NameError(f\"name '{'wha' + 'tever'}' is not defined\")", "unreadable", "NameError at line 1$"),
        ("class Odd(Exception): pass\nraise Odd('1.25')", "unreadable", "Exception at line 2$"),
        (bytes(range(256)) * 40, "unreadable", "cannot be"),
        ("{" * 100_000, "unreadable", "."),
        ("import tam570.rotations", "unreadable", "it imports tam570.rotations, which is off limits"),
        ("class Forbidden(Exception): pass\nraise Forbidden('1.25')", "unreadable", "was not graded: it imports"),
        ("x = 1\nimport sys\nsys.exit()", "crashed", "ends itself at line 3"),
        ("\nx = input('x')", "unreadable", r"calls input\(\) at line 2"),
        ("import os\nos._exit(0)", "crashed", "ended its process at import"),
        ("while True: pass", "timeout", "."),
    ],
)
def test_what_a_file_does_at_import_is_named_and_scores_nothing(grade, text, status, words):
    result = grade(HW08, text, limits=ResourceLimits(call=1), notebook=text[0] == "{")
    assert (result.status, result.score) == (status, 0.0) and re.search(words, result.message)
    assert "1.25" not in result.message and all(check.outcome == "not_run" for check in result.checks)


@confined
@pytest.mark.parametrize(
    "starting",
    [
        "import threading\nthreading.Thread(target=print).start()",
        "from concurrent.futures import *\nlist(ThreadPoolExecutor().map(abs, [1]))",
        "import multiprocessing\nmultiprocessing.Pool(2)",
        "import multiprocessing\nmultiprocessing.Process(target=print).start()",
        "import subprocess\nsubprocess.run(['ls'])",
        "import os\nos.fork()",
    ],
)
def test_who_starts_a_thread_or_a_process_is_told_that_it_may_not(grade, solution_text, starting):
    forbidden = "starts a thread or a process{}, which is off limits"
    assert grade(HW08, starting).message == f"Your file {forbidden.format(' at line 2')}"
    body = "\n    ".join(starting.replace("*", "ThreadPoolExecutor", 1).split("\n"))
    said = [check.message for check in grade(HW08, f"{solution_text(HW08)}\ndef skew(v):\n    {body}").checks]
    assert any(message.startswith(f"skew {forbidden.format('')}") for message in said), said
    result = grade(HW08, notebook(solution_text(HW08), starting), notebook=True)
    assert result.score == 10.0 and forbidden.format("") in result.message


def test_of_the_cells_that_were_skipped_three_are_named(grade, solution_text):
    result = grade(HW08, notebook(solution_text(HW08), *(f"x{i}" for i in range(9))), notebook=True)
    assert result.score == 10.0 and result.message.count("is not defined") == 3
    assert result.message.endswith("and others")


@pytest.mark.parametrize("folder", ["ben", f"ben/{HW08}"])
def test_a_folder_of_many_files_is_a_note(run, tree, scores, folder):
    for i in range(submissions.MOST_FILES + 1):
        (tree / folder / f"{i}.py").touch()
    _, lines, _ = run(tree)
    assert scores(lines) == {"ada": 10.0, "ben": 0.0, "cora": 0.0}
    assert "hand in the module" in next(line for line in lines if line["student"] == "ben")["message"]


def test_a_submission_of_many_files_is_looked_at_once_a_file(tmp_path):
    """The number of comparisons grows with the number of files, not with its square."""
    compared = []

    class Counted(type(tmp_path)):
        def __eq__(self, other):
            compared.append(1)
            return super().__eq__(other)

        __hash__ = type(tmp_path).__hash__

    entries = [(Counted(tmp_path / f"{number}.py"), False) for number in range(300)]
    submissions._of_files(entries, "ben", HW08, tmp_path)
    assert len(compared) <= 2 * len(entries)


@confined
@pytest.mark.parametrize(("limit", "code"), [("-t 5", 2), ("-f 1000", 0), ("-n 32", 0)])
@pytest.mark.parametrize("container", first(1, [["unshare", "-Ur"], []]), ids=["one user", "here"])
def test_a_shells_own_limits_cost_nobody_points(tmp_path, solution_text, limit, code, container):
    """Published against graders in rootless containers, where root is the only user and cannot raise limits."""
    if container and subprocess.run([*container, "true"], check=False).returncode:
        pytest.skip("no user namespaces")
    (tmp_path / "hw08.py").write_text(solution_text(HW08))
    grading = [*container, sys.executable, "-m", "tam570_grader", "grade", str(tmp_path / "hw08.py"), "--json"]
    limited = ["bash", "-c", f'ulimit {limit}; exec "$@"', "-", *grading]
    done = subprocess.run(limited, capture_output=True, text=True, check=False)
    assert done.returncode == code, done.stderr
    if code:
        assert "cannot be confined" in done.stderr and "ulimit" in done.stderr and not done.stdout
    else:
        assert json.loads(done.stdout)["score"] == 10.0


@pytest.mark.parametrize(("was", "becomes"), [(b"2 * x", b"3 * x"), (b"while True:", b"if True:")])
def test_a_worker_that_fails_the_canary_grades_nobody(solution_text, tmp_path, monkeypatch, capsys, was, becomes, cold):
    """A worker in which correct calls fail, or endless calls are not stopped, is not used."""
    monkeypatch.setattr(zygote, "CANARY", zygote.CANARY.replace(was, becomes))
    monkeypatch.setattr(zygote, "STOPPED_AFTER", 10.0)  # s, because calls that end take longer on a busy machine
    (tmp_path / "hw08.py").write_text(solution_text(HW08))
    assert cli.main(["grade", str(tmp_path / "hw08.py")]) == 2
    assert "without that none is graded" in capsys.readouterr().err


def test_renaming_a_file_does_not_keep_its_score(run, tmp_path, solution_text):
    """The same bytes are a correct module, and no notebook."""
    path = hand_in(tmp_path, {"ada": solution_text(HW08)}) / "ada" / HW08 / f"{HW08}.py"
    assert run(tmp_path / "ada", "--out", tmp_path / "out")[1][0]["score"] == 10.0
    path.rename(path.with_suffix(".ipynb"))
    result = run(tmp_path / "ada", "--out", tmp_path / "out")[1][0]
    assert result["score"] == 0.0 and "no notebook" in result["message"]


@confined
def test_what_is_hidden_is_empty_and_takes_no_notes(course, solution_text):
    """Hidden folders and the packages of other interpreters, to which bans do not apply, are empty and read-only."""
    hidden = Path(pytest.__file__).parent
    others = [path for path in other_packages([str(hidden.parent)]) if path.is_dir()]
    places = [str(path) for path in (hidden, *others)]
    is_hidden = "not os.listdir(place) and os.statvfs(place).f_flag & os.ST_RDONLY"
    looks = f"for place in {places}:\n    assert {is_hidden}, place\n"
    worker = Zygote(["numpy"], ResourceLimits(), [hidden])
    source = Source(f"import os\n{looks}{solution_text(HW08)}".encode())
    outcome = graded("eve", source, assignments.assignment(course, HW08), worker, 1)
    worker.close()
    assert outcome.score == 10, (outcome.message, places)


def test_what_is_off_limits_is_not_in_a_workers_memory_though_others_import_it(course, solution_text):
    request = WorkerConfig(ResourceLimits(), preload=("tam570.rotations",))
    with sandboxes():
        source = Source((DIGS + solution_text(HW08)).encode())
        outcome = result(GradeTask(course, "eve", HW08, 1, source, conditions=request))
    assert outcome.score == 10, outcome.message


@pytest.mark.skipif(sys.platform != "linux", reason="bubblewrap is for Linux")
@pytest.mark.parametrize(("deaths", "decided"), [(0, "bubblewrap"), (1, "bubblewrap"), (9, "processes")])
def test_a_trial_of_bubblewrap_that_is_killed_is_repeated(deaths, decided, tmp_path, monkeypatch):
    program = tmp_path / "bwrap"
    program.write_text(KILLED_AT_FIRST.format(count=tmp_path / "count", deaths=deaths))
    program.chmod(0o755)
    monkeypatch.setenv("PATH", str(tmp_path), prepend=":")
    assert isolation.__wrapped__() == decided


@pytest.mark.skipif(sys.platform != "linux", reason="reads /proc")
@pytest.mark.parametrize("options", [["--seed", "57057057"], ["--seed=57057057"], ["--see", "57057057"]])
def test_a_plain_process_reads_no_seed_in_a_command_line(options):
    done = subprocess.run([sys.executable, "-c", SEEN, *options, "--out", "results"], capture_output=True, text=True)
    assert "57057057" not in done.stdout and "********" in done.stdout and "--out results" in done.stdout, done.stderr
