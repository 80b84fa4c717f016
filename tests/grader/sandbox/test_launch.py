"""How submissions are kept apart is decided once, and no accident decides it."""

import subprocess
import sys

import pytest

from tam570_grader.sandbox.launch import isolation

KILLED_AT_FIRST = """#!/bin/sh
echo >> {count}
[ $(wc -l < {count}) -gt {deaths} ] || kill -9 $$
"""


@pytest.mark.skipif(sys.platform != "linux", reason="bubblewrap is for Linux")
@pytest.mark.parametrize(("deaths", "decided"), [(0, "bubblewrap"), (1, "bubblewrap"), (9, "processes")])
def test_a_trial_of_bubblewrap_that_is_killed_is_repeated(deaths, decided, tmp_path, monkeypatch):
    program = tmp_path / "bwrap"
    program.write_text(KILLED_AT_FIRST.format(count=tmp_path / "count", deaths=deaths))
    program.chmod(0o755)
    monkeypatch.setenv("PATH", str(tmp_path), prepend=":")
    assert isolation.__wrapped__() == decided


SEEN = """
import os
from tam570_grader.sandbox import launch
launch.isolation = lambda: "processes"
launch.hide_from_submissions()
print(open("/proc/self/cmdline").read().replace("\\0", " "), os.stat("/proc/self/environ").st_uid)
"""


@pytest.mark.skipif(sys.platform != "linux", reason="reads /proc")
@pytest.mark.parametrize("options", [["--seed", "57057057"], ["--seed=57057057"], ["--see", "57057057"]])
def test_a_plain_process_reads_no_seed_in_a_command_line(options):
    done = subprocess.run([sys.executable, "-c", SEEN, *options, "--out", "results"], capture_output=True, text=True)
    assert "57057057" not in done.stdout and "********" in done.stdout and "--out results" in done.stdout, done.stderr
