"""Every command and program of the site's pages is run, in the order of its page, in an empty folder.

A comment above a block says what a reader does by hand, `% prepared: COMMAND`, another exit code, `% exits 1: REASON`,
or why the block is not run, `% not run: REASON`.
"""

import doctest
import importlib
import os
import re
import runpy
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

import pytest

from tam570 import lectures
from tam570_grader import cli
from tam570_grader.checks import assignments

DOCS = assignments.find() / "docs"
PAGES = sorted(page.relative_to(DOCS).as_posix() for page in DOCS.glob("*/*.md") if page.parent.name != "generated")
PARTS = re.compile(
    r"^% (prepared|exits|not run):? ?([^\n]*)$|^```(sh|python|pycon)\n(.*?)^```$", re.MULTILINE | re.DOTALL
)
SHARED = DOCS.parent / "shared"
MODULES = sorted(
    ".".join(file.relative_to(SHARED).with_suffix("").parts)
    for file in SHARED.rglob("*.py")
    if re.search(r"^ *>>> ", file.read_text(), re.M)
)


@dataclass(frozen=True)
class Block:
    """A block of a page.

    kind     : sh, python, or pycon
    code     : the exit code that it should have
    reason   : why it is not run, or empty
    prepared : commands that stand for what a reader does by hand before
    """

    kind: str
    text: str
    code: int = 0
    reason: str = ""
    prepared: str = ""


def blocks(text):
    """The blocks of a page."""
    code, reason, prepared = 0, "", []
    for found in PARTS.finditer(text):
        mark, told, kind, inside = found.groups()
        if kind:
            yield Block(kind, inside, code, reason, "\n".join(prepared))
            code, reason, prepared = 0, "", []
        elif mark == "prepared":
            prepared.append(told)
        elif mark == "exits":
            code = int(told.partition(":")[0])
        else:
            reason = told


def texts(page):
    return list(blocks((DOCS / page).read_text()))


def run(block, folder, environment):
    """Run a block, and what comes before it; a block of several lines stops at the first that fails."""
    program = [sys.executable, "-W", "error", "-"] if block.kind == "python" else ["bash", "-e", "-s"]
    if block.prepared:
        subprocess.run(["bash", "-e", "-c", block.prepared], cwd=folder, env=environment, check=True)
    return subprocess.run(
        program, input=block.text, cwd=folder, env=environment, capture_output=True, text=True, timeout=120
    )


@pytest.fixture
def environment(tmp_path):
    """That of a reader: our commands on the path, a home and nothing in it."""
    path = f"{os.path.dirname(sys.executable)}{os.pathsep}{os.environ['PATH']}"
    return {**os.environ, "PATH": path, "COURSE": str(DOCS.parent), "HOME": str(tmp_path / "home"), "MPLBACKEND": "Agg"}


@pytest.mark.slow
@pytest.mark.parametrize("page", [page for page in PAGES if any(one.kind != "pycon" for one in texts(page))])
def test_the_commands_of_a_page_work_in_their_order(page, tmp_path, environment):
    (tmp_path / "home").mkdir()
    (tmp_path / "here").mkdir()
    for block in texts(page):
        if block.kind != "pycon" and not block.reason:
            done = run(block, tmp_path / "here", environment)
            assert done.returncode == block.code, f"{block.text}\n{done.stdout}\n{done.stderr}"


def test_a_command_that_fails_is_seen(tmp_path, environment):
    exits, two = "% exits 3: it says so\n```sh\nexit 3\n```\n", "```sh\nls a b\nfalse\ntrue\n```\n"
    first, second = blocks(f"{exits}% prepared: touch a\n% prepared: touch b\n{two}")
    assert run(first, tmp_path, environment).returncode == first.code == 3
    done = run(second, tmp_path, environment)
    assert done.stdout == "a\nb\n" and done.returncode == 1 != second.code


def sample_class():
    return list(runpy.run_path(str(DOCS.parent / "tests" / "sample_class.py"))["sample_class"]())


@pytest.mark.slow
def test_the_first_hour_shows_what_the_demo_prints(tmp_path, capsys):
    shown = re.search(r"^```text\n(student .*?)^```$", (DOCS / "instructors" / "index.md").read_text(), re.M | re.S)[1]
    rows = shown.splitlines()
    wanted = {tuple(row.split()[:2]) for row in rows[1:]}
    for student, slug, text in sample_class():
        if (student, slug) in wanted:
            (tmp_path / student / slug).mkdir(parents=True)
            (tmp_path / student / slug / f"{slug}.py").write_text(text)
    capsys.readouterr()
    assert cli.main(["grade", str(tmp_path), "--seed", "570", "--call", "2", "--jobs", "1"]) == 0
    printed = capsys.readouterr().out.splitlines()
    columns = [[line.split()[:6] for line in lines] for lines in (rows, printed[: len(rows)])]
    assert columns[0] == columns[1], "docs/instructors/index.md: student, score and status"


@pytest.mark.parametrize("page", [page for page in PAGES if any(one.kind == "pycon" for one in texts(page))])
def test_the_examples_of_a_page_give_what_they_say(page):
    text = "\n".join(block.text for block in texts(page) if block.kind == "pycon")
    example = doctest.DocTestParser().get_doctest(text, {}, page, str(Path(DOCS, page)), 0)
    told = []
    result = doctest.DocTestRunner().run(example, out=told.append)
    assert result.attempted and not result.failed, "".join(told)


@pytest.mark.parametrize("name", [*MODULES, "tam570_grader"])
def test_the_examples_of_docstrings_give_what_they_say(name):
    assert not doctest.testmod(importlib.import_module(name.removesuffix(".__init__"))).failed


def test_every_lecture_has_a_page_and_a_row_at_its_dates():
    rows = (DOCS / "lectures.md").read_text().splitlines()
    for name, lecture in lectures.catalogue().items():
        assert (DOCS / "lectures" / f"{name}.md").is_file(), f"docs/lectures/{name}.md: what the page says"
        days = {row.split("|")[1].strip() for row in rows if f"lectures/{name}.md" in row}
        *firsts, last = lecture.date.split(", ")
        month = last.split()[1]
        assert days == {*(day if " " in day else f"{day} {month}" for day in firsts), last}, f"docs/lectures.md: {name}"
