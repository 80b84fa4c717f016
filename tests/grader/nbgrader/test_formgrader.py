"""nbgrader's formgrader in a real browser: a part is graded by hand, and the total adds up."""

import shutil
import socket
import subprocess
import sys
import time
import urllib.error
import urllib.request

import pytest

from tam570_grader.diagnosis.mistakes import overlays

pytestmark = pytest.mark.slow  # half a minute of nbgrader
SLUG, MANUAL = "hw07_double_pendulum", "manual-c"
START = 60  # s, at most, until the server answers
TYPED, POSSIBLE = 1.5, 2.0  # points of the manual part
REMARK = "And if both swing as one?"
ROUNDED = 0.0051  # the page shows two digits


@pytest.fixture(scope="module")
def graded_course(course, tmp_path_factory, nbgrader, made_course):
    """A course with one submission, graded but for the part that is left to the teacher."""
    made, _ = made_course(tmp_path_factory.mktemp("formgrader"), [SLUG])
    nbgrader(made, "generate_assignment", SLUG)
    folder = made / "submitted" / "ben" / SLUG
    shutil.copytree(made / "release" / SLUG, folder)
    wrong = overlays(course / "autograder" / "checks" / SLUG)["too_few_steps"]
    solution = (course / "solutions" / f"{SLUG}.py").read_text()
    (folder / f"{SLUG}.py").write_text(f"{solution}\n\n{wrong}")
    notebook = folder / f"{SLUG}.ipynb"
    notebook.write_text(notebook.read_text().replace("*Your answer*", "One bar alone is a pendulum."))
    nbgrader(made, "autograde", SLUG)
    return made


@pytest.fixture(scope="module")
def formgrader(graded_course, jupyter_environment):
    """The address of a Jupyter server that runs in the course."""
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    options = [f"--port={port}", "--no-browser", "--allow-root", "--IdentityProvider.token="]
    home = {"HOME": str(graded_course), "JUPYTER_DATA_DIR": str(graded_course / "jupyter")}
    server = subprocess.Popen(
        [sys.executable, "-m", "jupyter", "server", *options],
        cwd=graded_course,
        env={**jupyter_environment, **home},
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
    )
    try:
        await_answer(f"http://127.0.0.1:{port}/api")
        yield f"http://127.0.0.1:{port}/formgrader"
    finally:
        server.terminate()
        server.wait()


def await_answer(address):
    until = time.monotonic() + START
    while True:
        try:
            urllib.request.urlopen(address).close()
            return
        except urllib.error.URLError:
            assert time.monotonic() < until, "the server does not start"
            time.sleep(0.2)


@pytest.fixture
def page(browser):
    """A page of headless Chromium."""
    page = browser.new_page()
    page.route(lambda address: "127.0.0.1" not in address, lambda route: route.abort())  # MathJax
    yield page
    page.close()


def test_a_part_is_graded_by_hand_and_the_total_adds_up(formgrader, page, graded_course, nbgrader, nbgrader_grades):
    automatic = sum(auto for (*_, cell), (auto, _) in nbgrader_grades(graded_course).items() if auto)
    assert 0 < automatic < 10 and automatic % 1  # a fraction, so that it must come through
    page.goto(f"{formgrader}/gradebook/{SLUG}/{SLUG}", wait_until="domcontentloaded")
    page.get_by_role("link", name="Submission #1").click()
    page.wait_for_function("window.formgrader && formgrader.grades?.loaded && formgrader.comments?.loaded")
    answer = page.locator(".nbgrader_cell", has_text="One bar alone is a pendulum.")
    assert answer.locator(".score").is_editable()
    messages = page.locator("td", has_text="is wrong by")
    assert messages.locator("svg").count() == 1  # what autograde has found, with its picture
    with page.expect_response(lambda reply: "/api/grade/" in reply.url and reply.request.method == "PUT"):
        answer.locator(".score").fill(str(TYPED))
        answer.locator(".score").press("Tab")
    with page.expect_response(lambda reply: "/api/comment/" in reply.url and reply.request.method == "PUT"):
        answer.locator("textarea").fill(REMARK)
        answer.locator("textarea").blur()
    page.goto(f"{formgrader}/gradebook/{SLUG}/{SLUG}", wait_until="domcontentloaded")
    total = page.locator("tbody tr td").filter(has_text=f"/ {10 + POSSIBLE:g}").first
    assert float(total.inner_text().split("/")[0]) == pytest.approx(automatic + TYPED, abs=ROUNDED)
    assert nbgrader_grades(graded_course)["ben", SLUG, MANUAL] == (None, TYPED)
    nbgrader(graded_course, "generate_feedback", SLUG)
    text = (graded_course / "feedback" / "ben" / SLUG / f"{SLUG}.html").read_text()
    assert REMARK in text and f"Score: {TYPED} / {POSSIBLE}" in text


def test_autograde_by_a_click_in_formgrader(formgrader, page, graded_course, nbgrader_grades):
    folder = graded_course / "autograded" / "ben" / SLUG
    before = (folder / f"{SLUG}.ipynb").stat().st_mtime_ns
    page.goto(f"{formgrader}/manage_submissions/{SLUG}", wait_until="domcontentloaded")
    page.locator(".autograde a").first.click()
    page.get_by_text("Successfully").first.wait_for(timeout=60_000)
    assert (folder / f"{SLUG}.ipynb").stat().st_mtime_ns > before
    assert nbgrader_grades(graded_course)["ben", SLUG, "part-d"][0] == 0.5
