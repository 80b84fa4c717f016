"""What the tests share: the course, seeds, and grading in the real sandbox without a command line around it."""

import pytest

from tam570_grader import root
from tam570_grader.grade import graded
from tam570_grader.sandbox import Allowance, Worker
from tam570_grader.student import Source

COURSE = root.find()
SLUGS = root.slugs(COURSE)
QUICK_SEEDS, FULL_SEEDS = 5, 50


def pytest_addoption(parser):
    parser.addoption("--full", action="store_true", help="every figure in full: 50 seeds, the long runs")


def pytest_collection_modifyitems(config, items):
    if not config.getoption("--full"):
        skip = pytest.mark.skip(reason="long; run with --full")
        for item in items:
            if "full" in item.keywords:
                item.add_marker(skip)


def pytest_generate_tests(metafunc):
    """A test with `slug` runs for every assignment, one with `seed` for every seed."""
    if "slug" in metafunc.fixturenames and not _parametrized(metafunc, "slug"):
        metafunc.parametrize("slug", SLUGS)
    if "seed" in metafunc.fixturenames:
        metafunc.parametrize(
            "seed", range(FULL_SEEDS if metafunc.config.getoption("--full") else QUICK_SEEDS)
        )


def _parametrized(metafunc, name):
    marks = metafunc.definition.iter_markers("parametrize")
    return any(name == mark.args[0] or name in mark.args[0] for mark in marks)


@pytest.fixture(scope="session")
def course():
    return COURSE


@pytest.fixture(scope="session")
def workers():
    """A warm worker for each assignment and allowance, started when it is first asked for."""
    started = {}

    def worker(slug, allowance):
        key = (root.assignment(COURSE, slug).needs, allowance)
        if key not in started:
            started[key] = Worker(key[0], allowance)
        return started[key]

    yield worker
    for one in started.values():
        one.close()


@pytest.fixture
def grade(workers):
    """`grade(slug, text, seed=0)` -> the Result of a submission with this text."""

    def grade(slug, text, seed=0, *, allowance=None, notebook=False):
        source = Source(text.encode() if isinstance(text, str) else text, notebook)
        worker = workers(slug, allowance or Allowance())
        return graded("someone", source, root.assignment(COURSE, slug), worker, seed)

    return grade


@pytest.fixture(scope="session")
def solution_text():
    """The source of the reference solution of an assignment."""
    return lambda slug: (COURSE / "solutions" / f"{slug}.py").read_text()
