"""The pages in headless Chromium: light and dark, by mouse and by keyboard."""

import contextlib
import json
from dataclasses import replace

import pytest

from tam570_grader.checks import assignments
from tam570_grader.diagnosis.mistakes import overlays
from tam570_grader.grading.run_checks import not_graded
from tam570_grader.reports import feedback, report
from tam570_grader.results import store

axe = pytest.importorskip("axe_playwright_python.sync_playwright", reason="no axe: pip install axe-playwright-python")
pytestmark = pytest.mark.slow  # half a minute of Chromium
CHECKS = assignments.find() / "autograder" / "checks"
SHOWN = {"hw07_double_pendulum": "too_few_steps", "hw05_constrained_pendulum": "gravity_up"}
FILES = ["report.html", "feedback/ada/hw07_double_pendulum.html", *(f"feedback/ben/{slug}.html" for slug in SHOWN)]


@pytest.fixture(scope="module")
def folder(tmp_path_factory, course, grade):
    """Return the folder of a small class's results, with its pages and its report."""
    folder = tmp_path_factory.mktemp("class")
    records = []
    for slug, mistake in SHOWN.items():
        correct = (course / "solutions" / f"{slug}.py").read_text()
        wrong = overlays(CHECKS / slug)[mistake]
        for student, text in {"ada": correct, "ben": f"{correct}\n\n{wrong}", "cora": ""}.items():
            records.append(replace(grade(slug, text, 1, speed=True), student=student).record())
    for slug in ("hw03_angular_momentum_rate", "hw05_constrained_pendulum"):  # one of them has a long title
        records.append(not_graded("dan", assignments.assignment(course, slug), "missing", "no file", 1).record())
    (folder / "results.jsonl").write_text("".join(json.dumps(item) + "\n" for item in records))
    with contextlib.closing(store.results(folder)) as results:
        feedback.write_pages(folder / "feedback", results, course)
    assert report.run(folder, course, None, None, {}, ()) == 0
    return folder


@pytest.fixture
def opened(open_tab, folder):
    """`opened(file, scheme)` -> the tab of the page."""
    return lambda file, scheme="light": open_tab((folder / file).as_uri(), color_scheme=scheme)


OTHER_COLOURS = """() => {  // of texts in figures, which axe passes over, than those of other texts
  const colours = (which, key) => new Set([...document.querySelectorAll(which)].map(e => getComputedStyle(e)[key]));
  const others = colours('main :not(svg *)', 'color');
  return [...colours('figure svg text', 'fill')].filter(colour => !others.has(colour));
}"""


@pytest.mark.parametrize("scheme", ["light", "dark"])
@pytest.mark.parametrize("file", FILES)
def test_axe_finds_no_fault_in_light_and_dark(opened, file, scheme):
    page = opened(file, scheme)
    violations = axe.Axe().run(page, options={"resultTypes": ["violations"]}).response["violations"]
    assert not [(rule["id"], rule["nodes"][0]["html"]) for rule in violations]
    assert page.evaluate(OTHER_COLOURS) == []


def test_the_report_is_sorted_and_filtered_by_keyboard_alone(opened):
    page = opened("report.html")
    for _ in range(60):
        page.keyboard.press("Tab")
        if page.evaluate("document.activeElement.id") == "words":
            break
    page.keyboard.type("cora")
    assert page.locator("#scores tbody tr:visible th[scope=row]").all_inner_texts() == ["cora"]
    for _ in range(60):
        page.keyboard.press("Tab")
        if page.evaluate("!!document.activeElement.closest('#scores thead')"):
            break
    outline = page.evaluate("getComputedStyle(document.activeElement).outlineStyle")
    page.keyboard.press("Enter")
    assert outline == "solid" and page.locator("#scores th").first.get_attribute("aria-sort") == "ascending"


def test_the_filter_narrows_every_table_and_says_how_much_is_left(opened):
    from playwright.sync_api import expect

    page = opened("report.html")
    everything = page.locator("tbody tr:visible").count()
    page.get_by_role("combobox", name="Assignment").select_option("hw05_constrained_pendulum")
    assert set(page.locator("#checks tbody tr:visible td:first-child").all_inner_texts()) == {"hw05"}
    page.get_by_role("searchbox").fill("energy after")
    shown = page.locator("tbody tr:visible").count()
    assert 0 < shown < everything and page.get_by_role("status").inner_text() == f"{shown} of {everything} rows"
    assert page.locator("#scores .none").is_visible()
    page.get_by_role("button", name="Show all").click()
    expect(page.get_by_role("status")).to_have_text(f"{everything} of {everything} rows")
    assert page.locator("tbody tr:visible").count() == everything
