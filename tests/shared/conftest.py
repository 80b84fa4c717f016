"""A student's desk, with a folder to work in and the command as a student gives it; pages in a browser."""

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
    """A student's empty folder, and nothing remembered."""
    return here


@pytest.fixture
def tam570(desk, capfd):
    """`tam570(*arguments)` -> the exit code, and what is printed; in a folder, with variables of the environment."""

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
    """`check` tests work that ends by itself in this process, where NumPy and pytest are imported already."""

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
    """`hw08(text)` -> the file of hw08, started: the solution, and this text below it; None for the stub."""
    assert cli.main(["start", "hw08"]) == 0
    file = desk / HW08 / f"{HW08}.py"

    def hw08(below="", above=""):
        if below is not None:
            file.write_text(f"{above}{solution_text(HW08)}\n\n{below}\n")
        return file

    return hw08


@pytest.fixture(scope="session")
def scenes(course):
    """`scenes(name)` -> the scene of an assignment, by its reference solution, or of a lecture, made once."""

    @cache
    def scene(name):
        if name in names():
            return filmed(load(name))
        return scene_of(load_student(course / "solutions" / f"{name}.py", name), name)

    return scene


@pytest.fixture
def open_page(open_tab, tmp_path):
    """`open_page(document, size, **options)` -> its tab, laid out."""

    def open_page(document, size=(1280, 720), reduced_motion="reduce", **options):
        (tmp_path / "page.html").write_text(document, encoding="utf-8")
        tab = open_tab((tmp_path / "page.html").as_uri(), size, reduced_motion=reduced_motion, **options)
        # an observer of sizes is first called at the end of a page's first frame
        tab.evaluate("() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))")
        return tab

    return open_page
