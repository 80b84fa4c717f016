"""Run every command and program of the site's pages, in the order of the page, in an empty folder.

A comment above a block can give a command for what a reader does by hand, `% prepared: COMMAND`, another exit code,
`% exits 1: REASON`, or the reason why the block is not run, `% not run: REASON`.
"""

import doctest
import importlib
import os
import re
import subprocess
import sys
from pathlib import Path
from typing import NamedTuple

import pytest

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


class Block(NamedTuple):
    """A block of a page."""

    language: str  # sh, python, or pycon
    text: str
    code: int  # the exit code that it should have
    reason: str  # why it is not run, or empty
    prepared: str  # commands to run first, instead of what a reader does by hand


def blocks(text):
    """Yield the blocks of a page."""
    code, reason, prepared = 0, "", []
    for part in PARTS.finditer(text):
        directive, words, language, body = part.groups()
        if language:
            yield Block(language, body, code, reason, "\n".join(prepared))
            code, reason, prepared = 0, "", []
        elif directive == "prepared":
            prepared.append(words)
        elif directive == "exits":
            code = int(words.partition(":")[0])
        else:
            reason = words


def texts(page):
    return list(blocks((DOCS / page).read_text()))


def run(block, folder, environment):
    """Run the commands before a block, then the block, which stops at its first line that fails."""
    program = [sys.executable, "-W", "error", "-"] if block.language == "python" else ["bash", "-e", "-s"]
    if block.prepared:
        subprocess.run(["bash", "-e", "-c", block.prepared], cwd=folder, env=environment, check=True)
    return subprocess.run(program, input=block.text, cwd=folder, env=environment, capture_output=True, text=True)


@pytest.fixture
def environment(tmp_path):
    """Return the environment of a reader: the course's commands on the path, and an empty home folder."""
    path = f"{os.path.dirname(sys.executable)}{os.pathsep}{os.environ['PATH']}"
    return {**os.environ, "PATH": path, "COURSE": str(DOCS.parent), "HOME": str(tmp_path / "home"), "MPLBACKEND": "Agg"}


@pytest.mark.slow
@pytest.mark.parametrize("page", [page for page in PAGES if any(block.language != "pycon" for block in texts(page))])
def test_the_commands_of_a_page_work_in_their_order(page, tmp_path, environment):
    (tmp_path / "home").mkdir()
    (tmp_path / "here").mkdir()
    for block in texts(page):
        if block.language != "pycon" and not block.reason:
            done = run(block, tmp_path / "here", environment)
            assert done.returncode == block.code, f"{block.text}\n{done.stdout}\n{done.stderr}"


@pytest.mark.parametrize("page", [page for page in PAGES if any(block.language == "pycon" for block in texts(page))])
def test_the_examples_of_a_page_give_what_they_say(page):
    text = "\n".join(block.text for block in texts(page) if block.language == "pycon")
    example = doctest.DocTestParser().get_doctest(text, {}, page, str(Path(DOCS, page)), 0)
    words = []
    result = doctest.DocTestRunner().run(example, out=words.append)
    assert result.attempted and not result.failed, "".join(words)


@pytest.mark.parametrize("name", [*MODULES, "tam570_grader"])
def test_the_examples_of_docstrings_give_what_they_say(name):
    assert not doctest.testmod(importlib.import_module(name.removesuffix(".__init__"))).failed
