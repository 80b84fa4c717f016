"""Fixtures of all tests: the course, grading in the real sandbox without the command line, browser tabs, nbgrader."""

import contextlib
import json
import os
import re
import shutil
import signal
import subprocess
import sys
import warnings
import zlib
from functools import cache

import numpy as np
import pytest
from parameters import SLUGS

from tam570_grader import cli
from tam570_grader.checks import assignments
from tam570_grader.grading import executor
from tam570_grader.grading.run_checks import CheckOptions, graded
from tam570_grader.sandbox.pool import sandboxes
from tam570_grader.sandbox.preload import COMMON, imported
from tam570_grader.sandbox.student import Source, Student
from tam570_grader.sandbox.zygote import ResourceLimits, Zygote

COURSE = assignments.find()
BROWSERS = ("chromium", "chromium-browser", "google-chrome", "chrome")
NBGRADER = """
import json, os, sys, warnings
from nbgrader.apps import NbGraderApp
for line in sys.stdin:
    where, log, *command = json.loads(line)
    child = os.fork()
    if child == 0:
        os.chdir(where)
        os.environ["HOME"] = os.environ["JUPYTER_DATA_DIR"] = where
        for stream in (1, 2):
            os.dup2(os.open(log, os.O_WRONLY | os.O_CREAT | os.O_APPEND), stream)
        NbGraderApp.launch_instance(command)
        sys.stdout.flush()
        os._exit(0)
    print(os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]), flush=True)
"""


# Background jobs of a shell ignore SIGINT, and jobs under nohup SIGHUP; processes that tests start would inherit this.
signal.signal(signal.SIGINT, signal.default_int_handler)
signal.signal(signal.SIGHUP, signal.SIG_DFL)


@pytest.hookimpl(tryfirst=True)
def pytest_collection_modifyitems(items):
    """Run the tests of an assignment, of a module, or of the browser in one xdist process: they share fixtures."""
    for item in items:
        groups = [*re.findall(r"[-[](hw\d\d)", item.nodeid), item.nodeid.partition("::")[0]]
        item.add_marker(pytest.mark.xdist_group("browser" if "tabs" in item.fixturenames else groups[0]))


def pytest_make_parametrize_id(val):
    """Return an id that tells the case and agrees in all processes: zip files contain times, functions addresses."""
    if isinstance(val, bytes):
        return f"{len(val)} bytes"
    text = str(val)
    if isinstance(val, list | tuple | dict) and len(text) <= 80 and "\n" not in text and " at 0x" not in text:
        return text
    return f"{len(val)} characters" if isinstance(val, str) and len(val) > 80 else None


def pytest_generate_tests(metafunc):
    """Run each test that has a parameter `slug`, and does not parametrize it itself, for every assignment."""
    parameters = [decorator.args[0] for decorator in metafunc.definition.iter_markers("parametrize")]
    if "slug" in metafunc.fixturenames and not any(names == "slug" or "slug" in names for names in parameters):
        metafunc.parametrize("slug", SLUGS)


@pytest.fixture(autouse=True)
def _numbers_of_its_own(request):
    """Seed the module's generator DRAW for each test, so that its numbers do not depend on the tests before it."""
    if random_numbers := getattr(request.module, "DRAW", None):
        seed = zlib.crc32(request.node.nodeid.encode())
        random_numbers.bit_generator.state = np.random.default_rng(seed).bit_generator.state


@pytest.fixture(autouse=True)
def _handlers():
    """Restore the signal handlers after each test: commands replace them."""
    handlers = {number: signal.getsignal(number) for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)}
    yield
    for number, handler in handlers.items():
        signal.signal(number, handler)


@pytest.fixture(scope="session", autouse=True)
def _warm_workers():
    """Share the zygotes among all commands of this process: starting one takes longer than grading with it."""
    with pytest.MonkeyPatch.context() as patch, sandboxes():
        patch.setattr(executor, "sandboxes", contextlib.nullcontext)
        patch.setattr("tam570_grader.sandbox.pool.sandboxes", contextlib.nullcontext)
        yield


@pytest.fixture
def here(tmp_path, monkeypatch):
    """Return an empty folder, which is the working directory and contains the folder TAM570_HOME."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("TAM570_HOME", str(tmp_path / "home"))
    return tmp_path


@pytest.fixture
def cold():
    """Close all warm zygotes, so that the test starts new ones."""
    with sandboxes():
        pass


@pytest.fixture(scope="session")
def course():
    return COURSE


@pytest.fixture(scope="session")
def zygotes():
    """`zygote(slug, limits, text)` -> a zygote with the assignment's imports; with all imports if text has some."""
    started, imports = {}, {slug: assignments.sandbox_imports(COURSE, slug) for slug in SLUGS}
    everything = {*COMMON}.union(*(needed for needed, _ in imports.values()))

    def zygote(slug, limits, text=b""):
        needed, forbidden = imports[slug]
        needs = tuple(sorted((everything if imported(text) else needed) - forbidden))
        if (needs, limits) not in started:
            started[needs, limits] = Zygote(needs, limits)
        return started[needs, limits]

    yield zygote
    for entry in started.values():
        entry.close()


@pytest.fixture(scope="session")
def grade(zygotes):
    """`grade(slug, text, seed=0, **options)` -> the Result of a submission with this text."""

    def grade(slug, text, seed=0, *, limits=None, notebook=False, **options):
        source = Source(text.encode() if isinstance(text, str) else text, notebook)
        assignment = assignments.assignment(COURSE, slug)
        zygote = zygotes(slug, limits or ResourceLimits(), source.text)
        return graded("someone", source, assignment, zygote, seed, options=CheckOptions(**options))

    return grade


@pytest.fixture
def student_of(zygotes):
    """`student_of(slug, text)` -> the Student whose submission has this text; its process ends with the test."""
    with contextlib.ExitStack() as stack:

        def student_of(slug, text):
            assignment = assignments.assignment(COURSE, slug)
            student = Student(Source(text.encode()), assignment, zygotes(slug, ResourceLimits(), text.encode()))
            stack.callback(student.leave)
            return student

        yield student_of


@pytest.fixture(scope="session")
def solution_text():
    """`solution_text(slug)` -> the source of the reference solution of an assignment."""
    return lambda slug: (COURSE / "solutions" / f"{slug}.py").read_text()


@pytest.fixture(scope="session")
def tabs():
    """`tabs(**options)` -> a tab of headless Chromium, the same for the same options: starting it takes a second."""
    driver = pytest.importorskip("playwright.sync_api", reason="no playwright: pip install playwright")
    chromium = next((path for name in BROWSERS if (path := shutil.which(name))), None)
    if chromium is None:
        pytest.skip("there is no Chromium here")
    with driver.sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=chromium, args=["--no-sandbox"])
        yield cache(lambda **options: browser.new_context(**options).new_page())
        browser.close()


@pytest.fixture
def open_tab(tabs):
    """`open_tab(address, (width, height), **options)` -> the tab. Fail if it logs errors or requests other hosts."""
    complaints, opened = [], contextlib.ExitStack()

    def open_tab(address, size=(1280, 800), allowed=("file:", "data:"), **options):
        opened.close()
        tab = tabs(**options)
        for event, hear in {
            "console": lambda entry: complaints.append(entry.text) if entry.type in ("error", "warning") else None,
            "pageerror": lambda error: complaints.append(str(error)),
            "request": lambda request: request.url.startswith(allowed) or complaints.append(request.url),
        }.items():
            tab.on(event, hear)
            opened.callback(tab.remove_listener, event, hear)
        tab.set_default_timeout(300_000)  # ms, so that no test fails on a busy machine
        tab.set_viewport_size(dict(zip(("width", "height"), size, strict=True)))
        tab.emulate_media(media="null")
        tab.goto(address)
        opened.callback(tab.goto, "about:blank")
        return tab

    with opened:
        yield open_tab
    assert not complaints


@pytest.fixture(scope="session")
def nbgrader(tmp_path_factory):
    """`nbgrader(folder, *command)` -> what nbgrader prints; it runs in a fork of a process that has imported it."""
    log = tmp_path_factory.mktemp("log") / "log.txt"
    path = f"{os.path.dirname(sys.executable)}{os.pathsep}{os.environ['PATH']}"  # nbgrader starts alembic and jupyter
    pipes, environment = {"stdin": subprocess.PIPE, "stdout": subprocess.PIPE}, {**os.environ, "PATH": path}
    server = subprocess.Popen([sys.executable, "-c", NBGRADER], **pipes, text=True, env=environment)

    def nbgrader(folder, *command):
        log.write_text("")
        server.stdin.write(json.dumps([str(folder), str(log), *command]) + "\n")
        server.stdin.flush()
        assert int(server.stdout.readline()) == 0, log.read_text()
        return log.read_text()

    yield nbgrader
    server.stdin.close()
    server.wait()
    server.stdout.close()


@pytest.fixture(scope="session")
def made_course():
    """`made_course(folder, slugs)` -> the course folder that the command `course` writes, and a student's config."""

    def made_course(folder, slugs):
        assert cli.main(["--root", str(COURSE), "course", str(folder / "course"), *slugs]) == 0
        (folder / "exchange").mkdir(mode=0o777, exist_ok=True)
        setting = f'\nc.Exchange.root = "{folder / "exchange"}"\n'
        with open(folder / "course" / "nbgrader_config.py", "a") as config:
            config.write(setting)
        return folder / "course", f'c = get_config()\nc.CourseDirectory.course_id = "tam570"\n{setting}'

    return made_course


@pytest.fixture(scope="session")
def nbgrader_grades():
    """`nbgrader_grades(course)` -> {(student, assignment, cell): (auto, manual score)} of nbgrader's gradebook."""

    def grades(course):
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # SQLAlchemy warns about nbgrader's code
            from nbgrader.api import Gradebook

            with Gradebook(f"sqlite:///{course / 'gradebook.db'}") as book:
                return {
                    (submission.student_id, assignment.name, grade.name): (grade.auto_score, grade.manual_score)
                    for assignment in book.assignments
                    for submission in assignment.submissions
                    for entry in submission.notebooks
                    for grade in entry.grades
                }

    return grades
