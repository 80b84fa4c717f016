"""Fixtures of the students' tests: an empty folder, the command `tam570`, scenes, and pages in a browser."""

from functools import cache

import pytest
from classes import HW08

from tam570 import checking, cli
from tam570.checking import session
from tam570.checking.trail import Trail
from tam570.lectures import load, names
from tam570.show import load_student, scene_of
from tam570.show.lecture import filmed


@pytest.fixture
def desk(here):
    """Return a student's empty folder, without stored progress."""
    return here


@pytest.fixture
def tam570(desk, capfd):
    """`tam570(*arguments, cwd, **variables)` -> (exit code, output) in a folder, with environment variables."""

    def tam570(*arguments, cwd=".", **variables):
        capfd.readouterr()
        with pytest.MonkeyPatch.context() as patch:
            patch.chdir(cwd)
            for name, value in variables.items():
                patch.setenv(name, value)
            try:
                code = cli.main(list(map(str, arguments)))
            except SystemExit as end:
                code = end.code
        return code, "".join(capfd.readouterr())

    return tam570


@pytest.fixture
def in_process(monkeypatch):
    """Run the tests of `check` in this process, which has imported NumPy and pytest; no test may hang or exit."""

    class Here:
        def __init__(self, ahead):
            self.successor, self.end = lambda ahead: None, lambda: None

        def run(self, work, **which):
            self.passed = [session.check(file.resolve(), slug, Trail(), lost={}, **which) for file, slug in work]

        def result(self):
            return 1 - all(self.passed)

    monkeypatch.setattr(checking, "Runner", Here)


@pytest.fixture
def hw08(desk, solution_text):
    """`hw08(below, above)` -> the file of hw08 with the solution between these texts, or the stub if below is None."""
    assert cli.main(["start", "hw08"]) == 0
    file = desk / HW08 / f"{HW08}.py"

    def hw08(below="", above=""):
        if below is not None:
            file.write_text(f"{above}{solution_text(HW08)}\n\n{below}\n")
        return file

    return hw08


@pytest.fixture
def edited(desk, solution_text):
    """`edited(slug, below)` -> a file with the solution and then this text."""

    def edited(slug, below=""):
        file = desk / f"{slug}.py"
        file.write_text(f"{solution_text(slug)}\n\n{below}\n")
        return file

    return edited


@pytest.fixture(scope="session")
def scenes(course):
    """`scenes(name)` -> the cached scene of a lecture, or of an assignment with its reference solution."""

    @cache
    def scene(name):
        if name in names():
            return filmed(load(name))
        return scene_of(load_student(course / "solutions" / f"{name}.py", name), name)

    return scene


@pytest.fixture
def open_page(open_tab, tmp_path):
    """`open_page(document, size, **options)` -> the tab of an HTML document, after its layout."""

    def open_page(document, size=(1280, 720), reduced_motion="reduce", **options):
        (tmp_path / "page.html").write_text(document, encoding="utf-8")
        tab = open_tab((tmp_path / "page.html").as_uri(), size, reduced_motion=reduced_motion, **options)
        # a ResizeObserver is first called at the end of the first frame
        tab.evaluate("() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))")
        return tab

    return open_page
