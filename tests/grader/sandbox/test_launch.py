"""How submissions are kept apart is decided once, and no accident decides it."""

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
