"""A submission's process: time limits, messages, deaths and retries, and calls that are off limits."""

import contextlib
import gc

import numpy as np
import pytest

from tam570_grader.checks.case import Case
from tam570_grader.checks.expect import Failed, check_context, expect
from tam570_grader.grading.supervisor import GradeTask, result
from tam570_grader.sandbox.launch import isolation
from tam570_grader.sandbox.pool import ATTEMPTS, sandboxes
from tam570_grader.sandbox.process import SandboxProcess
from tam570_grader.sandbox.student import Source
from tam570_grader.sandbox.zygote import ResourceLimits, Zygote, ZygoteLost

SLUG = "hw08_axis_angle"
WRAPPED = "def _kept(f): return lambda *given: f(*given)\n"
ALIASES = {
    "by another name": "_same = rotation_matrix",
    "in a table": "_same = {'it': rotation_matrix}.__getitem__('it')",
    "kept by a closure": "def _keeping(f): return lambda *given: f(*given)\n_same = _keeping(rotation_matrix)",
    "of a decorated one": f"{WRAPPED}rotation_matrix = _same = _kept(rotation_matrix)",
    "in a table, of a decorated one": f"{WRAPPED}rotation_matrix = _kept(rotation_matrix)\n"
    "_table = [rotation_matrix]\ndef _same(*given): return _table[0](*given)",
    "of no plain function": "import functools\nrotation_matrix = _same = functools.partial(rotation_matrix)",
}
DEATHS = {
    "hangs up": "os.close(3)\n    time.sleep(60)",
    "is awake at ticks alone": """phase = ticks()
    while time.monotonic() < phase + 6:
        now = time.monotonic()
        tick = now - (now - phase) % 0.004 + 0.004
        time.sleep(max(0.0, tick - now - 0.0005))
        while time.monotonic() < tick + 0.0001:
            pass""",
}
TICKS = """
import os, time
def ticks():
    clock = ~os.getpid() << 3
    before = time.clock_gettime(clock)
    while time.clock_gettime(clock) - before < 0.004:
        pass
    return time.monotonic()
"""


def test_one_that_sleeps_through_its_calls_is_ended(grade, solution_text, monkeypatch):
    monkeypatch.setattr("tam570_grader.sandbox.student.PATIENCE", 1)
    received, receive = [], SandboxProcess.receive
    monkeypatch.setattr(SandboxProcess, "receive", lambda *args: received.append(receive(*args)) or received[-1])
    text = solution_text(SLUG) + "\n_skew = skew\ndef skew(v):\n    time.sleep(0.3)\n    return _skew(v)\nimport time\n"
    outcome = grade(SLUG, text, limits=ResourceLimits(cpu=2, call=1))
    assert outcome.status == "timeout" and outcome.score < 10 and "little processor time" in outcome.message
    assert len(received) < 20, "it is ended within a batch of calls"


@pytest.mark.slow
def test_one_that_sleeps_at_every_import_and_call_is_ended(grade, solution_text, monkeypatch):
    """Each function of hw02 has its own bans, and so its own sandbox process."""
    monkeypatch.setattr("tam570_grader.sandbox.student.PATIENCE", 1)
    slow = "import time\ntime.sleep(0.8)\n" + solution_text("hw02_ballistics")
    asleep = "import time\nskew = rotate = rotation_matrix = lambda *_, **__: time.sleep(9)\n"
    for slug, text in (("hw02_ballistics", slow), (SLUG, asleep)):
        outcome = grade(slug, text, limits=ResourceLimits(cpu=1.5, call=1))
        assert outcome.status == "timeout" and "little processor time" in outcome.message


@pytest.mark.parametrize(
    "text", ["assert os.getpgrp() == os.getpid() == os.getsid(0)", "block = bytearray(200 * 2**20)"]
)
def test_a_submission_has_a_process_group_of_its_own_and_its_memory_without_the_libraries(grade, solution_text, text):
    text = f"import os\n{text}\n{solution_text(SLUG)}"
    assert grade(SLUG, text, limits=ResourceLimits(memory=2**28)).score == 10


@pytest.fixture
def zygote():
    with contextlib.closing(Zygote(["numpy"], ResourceLimits())) as zygote:
        yield zygote


def test_a_monitor_watches_one_process_after_another(zygote):
    first, second = zygote.process(5), zygote.process(6)
    assert first.leash is not second.leash
    assert first.end() > 0
    third = zygote.process(5)
    assert third.leash is first.leash
    assert second.end() > 0 and third.end() > 0 and third.monitored


@pytest.mark.skipif(isolation() != "bubblewrap", reason="each process sees the others")
def test_the_next_process_of_a_kind_is_ready_when_it_is_asked_for(zygote):
    first, second = zygote.process(7), zygote.process(7)
    ready = zygote._spare
    third = zygote.process(7)
    assert third is ready and zygote._spare not in (None, first, second, third)
    last = zygote._spare
    fourth = zygote.process(8)
    assert zygote._spare is None
    for process in (first, second, third, last, fourth):
        process.end()
        assert process.monitored


def test_one_that_is_tried_again_is_not_quoted(grade):
    first, second = (grade(SLUG, "1 / 0", attempt=attempt) for attempt in ATTEMPTS[:2])
    assert "division" in first.message and "second time" in second.message and "division" not in second.message


def test_a_worker_that_dies_is_replaced(solution_text, course, cold):
    started = []

    class Mortal(Zygote):
        """A zygote: the first is killed before it is ready, the second when it is ready."""

        def __init__(self, *arguments):
            super().__init__(*arguments)
            started.append(self)
            if len(started) == 1:
                self._launched.kill()
            elif len(started) == 2:
                self._await_ready()
                self._launched.kill()

    with pytest.MonkeyPatch.context() as patch, sandboxes():
        patch.setattr("tam570_grader.sandbox.pool.Zygote", Mortal)
        outcome = result(GradeTask(course, "ada", SLUG, 1, Source(solution_text(SLUG).encode())))
    assert outcome.score == 10.0 and len(started) == 3


def test_a_zygote_that_has_died_leaves_no_socket_open():
    zygote = Zygote(["numpy"], ResourceLimits())
    zygote.process(cpu=1.0).drop()
    zygote._launched.kill()
    zygote._launched.wait()
    with pytest.raises(ZygoteLost):
        zygote.process(cpu=1.0)
    zygote.close()
    gc.collect()  # an open socket warns, and pytest turns warnings into errors


@pytest.mark.parametrize("body", ["raise ValueError", "return float('nan')", "return None", "v[0] = 0.0"])
def test_a_call_that_fails_says_which_it_was_and_of_what_kind_where_another_works(body, student_of):
    text = f"def skew(v):\n    if v[0] != 1: return [[0.0] * 3] * 3\n    {body}\n"
    student = student_of(SLUG, text)
    call = Case(np.ones(3)).labelled("a short v")
    with pytest.raises(Failed) as failed:
        student.skew.many([call])
    assert not failed.value.failure.label, "it may be so for any input"
    student.skew(np.zeros(3))
    with pytest.raises(Failed) as failed:
        student.skew.many([call])
    assert (failed.value.failure.label, failed.value.failure.at) == ("a short v", call)
    assert failed.value.failure.function == "skew"


TEXTS = {
    "np.ones(2) + np.ones(3)": "ValueError (operands could not be broadcast together)",
    "math.sqrt(-1)": "ValueError (math domain error)",
    "np.linalg.solve(np.zeros((2, 2)), np.ones(2))": "ValueError (Singular matrix)",
    "float(np.ones(2))": "TypeError (only 0-dimensional arrays can be converted to Python scalars)",
    "scipy.integrate.solve_ivp(np.dot, (0, 1), [1.0], t_eval=[2.0])": "ValueError (Values in `t_eval` are not within "
    "`t_span`)",
    "scipy.optimize.brentq(abs, 1, 2)": "ValueError (f(a) and f(b) must have different signs)",
    "raise ValueError(v[0])": "ValueError",
    "raise KeyError('Singular matrix')": "KeyError",
}


@pytest.mark.parametrize("body", TEXTS)
def test_of_an_exceptions_text_only_what_the_grader_knows_is_shown(body, student_of):
    text = f"import math, numpy as np, scipy.integrate, scipy.optimize\ndef skew(v):\n    {body}\n"
    with pytest.raises(Failed) as failed:
        student_of(SLUG, text).skew(np.ones(3))
    assert failed.value.failure.message == f"skew raised {TEXTS[body]}"


def test_what_is_called_for_the_words_ends_no_function_and_is_not_judged(student_of):
    """A function that exits in a call that a hint makes can still be called, and that call is not recorded."""
    text = "import os\ndef skew(v):\n    return np.zeros((3, 3)) if v[0] else os._exit(1)\nimport numpy as np\n"
    student = student_of(SLUG, text)

    def hint():
        return f"It gives {student.skew(np.zeros(3))}"

    with pytest.raises(Failed) as failed, check_context(aside=student.aside):
        actual = student.skew(np.ones(3))
        expect(actual, np.ones((3, 3)), tolerance=1e-9, hint=hint)
    assert failed.value.failure.hint == "" and failed.value.failure.fault == ""
    assert len(student.calls) == 1 and student.skew(np.ones(3)).shape == (3, 3)


@pytest.mark.parametrize("alias", ALIASES.values(), ids=ALIASES)
def test_a_function_that_may_not_be_called_may_not_by_another_name(grade, solution_text, alias):
    text = f"{solution_text(SLUG)}\n{alias}\ndef rotate(r, axis, angle): return _same(axis, angle) @ np.asarray(r)\n"
    outcome = grade(SLUG, text)
    assert outcome.score == 6.0, outcome
    said = [check.message for check in outcome.checks if check.outcome == "failed"]
    assert said and all(item.startswith("rotate uses what is off limits in it: rotation_matrix.") for item in said)


@pytest.mark.slow
@pytest.mark.skipif(isolation() != "bubblewrap", reason="a process can kill itself elsewhere")
@pytest.mark.parametrize("death", DEATHS.values(), ids=DEATHS)
def test_who_looks_as_if_killed_by_others_is_not_tried_again(death, grade, solution_text):
    """The kernel enforces the limit of processor time in ticks of 4 ms, so it can kill a process that used less."""
    text = f"{solution_text(SLUG)}{TICKS}\ndef skew(v):\n    {death}\n"
    assert grade(SLUG, text, limits=ResourceLimits(cpu=2, call=1.5), attempt=ATTEMPTS[0]).score < 10


def test_what_chooses_words_leaves_half_of_the_time(student_of, solution_text, monkeypatch):
    student, vector = student_of(SLUG, solution_text(SLUG)), Case(np.ones(3))
    assert student.skew.aside(vector).shape == (3, 3)
    monkeypatch.setattr(student, "seconds", lambda: 0.6 * ResourceLimits().cpu)
    with pytest.raises(Failed):
        student.skew.aside(vector)
    assert student.skew(np.ones(3)).shape == (3, 3) and len(student.calls) == 1
