"""`check --watch`: from a saved file to the result."""

import os
import re
import signal
import subprocess
import sys

import pytest

from tam570.checking.changes import calls
from tam570.checking.examples import load_examples
from tam570.course import folder

SLUG = "hw08_axis_angle"
REFUSED = "test_rotate_refuses_what_is_no_axis"  # a parametrized test with three cases


@pytest.fixture
def watching(hw08, tmp_path_factory):
    """`watching(text)` -> the output after this text is saved, or of the first run if text is None."""
    file = hw08()
    command = [sys.executable, "-m", "tam570", "check", "hw08", "--watch"]
    temporary = tmp_path_factory.mktemp("temporary")
    buffered = {**os.environ, "TMPDIR": str(temporary), "PYTHONUNBUFFERED": ""}  # the usual default
    process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, env=buffered)

    def after(text=None, until=("all done", "next:")):
        if text is not None:
            draft = file.with_suffix(".new")
            draft.write_text(text)
            draft.replace(file)  # as editors do
        said = ""
        for printed in process.stdout:
            said += printed
            if any(words in printed for words in ((until,) if isinstance(until, str) else until)):
                return said
        raise AssertionError(f"ended with {process.wait()}: {said}")

    after.process = process
    yield after
    with process:
        process.terminate()
    assert not list(temporary.iterdir())


def count(said):
    """Return the number of tests that were run."""
    return int(re.search(r"(\d+) tests? run", said)[1])


def test_a_save_runs_the_tests_that_it_concerns_and_no_other(watching, desk, solution_text):
    everything = int(re.search(r"(\d+) of \d+ tests pass", watching())[1])
    solution = solution_text(SLUG)
    last = "\n\ndef {}(*args):\n    return None\n"
    assert "Nothing has changed that a test sees" in watching(solution + "\n# a remark\n")
    wrong = watching(solution + last.format("rotate"))
    assert 0 < count(wrong) < everything and "next: rotate" in wrong
    text = (desk / SLUG / f"test_{SLUG}.py").read_text() + load_examples(folder(SLUG)).module(SLUG)
    apart = everything - sum(1 + 2 * (test == REFUSED) for test, used in calls(text, SLUG).items() if "rotate" in used)
    assert f"{apart} of {everything} tests pass" in wrong
    repeated = watching(solution + last.format("unused"))
    assert "all done" in repeated and count(repeated) == count(wrong)


def test_a_mistake_is_that_of_the_function_that_changed(watching, solution_text):
    """Tests that call only `rotate` passed before and are not run again, so they name no mistake."""
    watching()
    wrong = "\n\nright = rotation_matrix\n\ndef rotation_matrix(*args):\n    return right(*args).T\n"
    said = watching(solution_text(SLUG) + wrong)
    mistakes = re.findall(r"match this mistake:([^.]*)\.", said)
    assert mistakes and all("rotation_matrix" in mistake for mistake in mistakes)


def test_a_file_that_is_half_written_is_said_so_and_the_next_save_is_tested(watching, solution_text):
    watching()
    assert "SyntaxError" in watching("def skew(", until="SyntaxError")
    assert "all done" in watching(solution_text(SLUG) + "\nMORE = 1\n")


def test_a_save_ends_tests_that_hang(watching, solution_text):
    watching()
    hanging = solution_text(SLUG) + "\n\ndef skew(v):\n    print('hangs', flush=True)\n    while True:\n        pass\n"
    hanging += "\n\nprint('loaded', flush=True)\n"
    watching(hanging, until="loaded")
    assert "all done" in watching(solution_text(SLUG) + "\nMORE = 2\n")


def test_ctrl_c_ends_it_without_a_traceback(watching):
    watching()
    watching.process.send_signal(signal.SIGINT)
    out, _ = watching.process.communicate()
    assert watching.process.returncode == 0 and "Traceback" not in out and "no longer watching" in out
