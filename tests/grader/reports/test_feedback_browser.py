"""The pages in headless Chromium: wide and narrow, light and dark, by mouse and by keyboard."""

import contextlib
import json
from dataclasses import replace

import pytest

from tam570_grader.checks import assignments
from tam570_grader.diagnosis.mistakes import overlays
from tam570_grader.grading.run_checks import not_graded
from tam570_grader.reports import feedback, report
from tam570_grader.results import store

pytestmark = pytest.mark.slow  # half a minute of Chromium
CHECKS = assignments.find() / "autograder" / "checks"
SHOWN = {"hw07_double_pendulum": "too_few_steps", "hw05_constrained_pendulum": "gravity_up"}
WIDTHS = {"desktop": 1280, "phone": 390}
CONTRAST = 4.5  # of text, WCAG 2 AA
FILES = ["report.html", "feedback/ada/hw07_double_pendulum.html", *(f"feedback/ben/{slug}.html" for slug in SHOWN)]


@pytest.fixture(scope="module")
def folder(tmp_path_factory, course, grade):
    """The results of a small class with its pages and its report."""
    folder = tmp_path_factory.mktemp("class")
    records = []
    for slug, mistake in SHOWN.items():
        correct = (course / "solutions" / f"{slug}.py").read_text()
        wrong = overlays(CHECKS / slug)[mistake]
        for student, text in {"ada": correct, "ben": f"{correct}\n\n{wrong}", "cora": ""}.items():
            records.append(replace(grade(slug, text, 1, speed=True), student=student).record())
    for slug in ("hw03_angular_momentum_rate", "hw05_constrained_pendulum"):  # one with a long title
        records.append(not_graded("dan", assignments.assignment(course, slug), "missing", "no file", 1).record())
    (folder / "results.jsonl").write_text("".join(json.dumps(item) + "\n" for item in records))
    with contextlib.closing(store.results(folder)) as results:
        feedback.write_pages(folder / "feedback", results, course)
    assert report.run(folder, course, None, None, {}, ()) == 0
    return folder


@pytest.fixture
def opened(open_tab, folder):
    """`opened(file, width, scheme)` -> the tab of the page."""
    return lambda file, width=1280, scheme="light": open_tab(
        (folder / file).as_uri(), (width, 800), color_scheme=scheme
    )


@pytest.mark.parametrize("width", WIDTHS.values(), ids=WIDTHS)
@pytest.mark.parametrize("file", FILES)
def test_a_page_fits_the_width_and_nothing_is_cut_off(opened, file, width):
    page = opened(file, width)
    assert page.evaluate("document.documentElement.scrollWidth") <= width
    for figure in page.locator("figure svg").all():
        box = figure.bounding_box()
        assert box["x"] >= 0 and box["x"] + box["width"] <= width and box["height"] > 100
        fits = figure.evaluate("""svg => [...svg.querySelectorAll('text')].every(text => {
            const [t, s] = [text.getBoundingClientRect(), svg.getBoundingClientRect()];
            return t.left >= s.left - 1 && t.right <= s.right + 1 && t.bottom <= s.bottom + 1; })""")
        assert fits


# The contrast of every text with what is behind it, by the colours that the browser computes.
CONTRASTS = """() => {
  const part = v => (v /= 255) <= 0.03928 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4;
  const light = c => 0.2126 * part(c[0]) + 0.7152 * part(c[1]) + 0.0722 * part(c[2]);
  const numbers = text => text.match(/[\\d.]+/g).map(Number);
  const behind = element => {
    for (let e = element; e; e = e.parentElement) {
      const c = numbers(getComputedStyle(e).backgroundColor);
      if (c.length < 4 || c[3] > 0) return c;
    }
    return [255, 255, 255];
  };
  return [...document.querySelectorAll('main *')]
    .filter(e => e.getClientRects().length && [...e.childNodes].some(n => n.nodeType === 3 && n.data.trim()))
    .filter(e => !e.closest('title'))
    .map(e => {
      const style = getComputedStyle(e), svg = e instanceof SVGElement;
      const [a, b] = [light(numbers(svg ? style.fill : style.color)), light(behind(svg ? e.closest('figure') : e))];
      return [(Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05), e.textContent.slice(0, 40)];
    });
}"""


@pytest.mark.parametrize("scheme", ["light", "dark"])
@pytest.mark.parametrize("file", FILES)
def test_every_text_can_be_read_in_light_and_dark(opened, file, scheme):
    contrasts = opened(file, scheme=scheme).evaluate(CONTRASTS)
    assert len(contrasts) > 20 and not [text for ratio, text in contrasts if ratio < CONTRAST]


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
