"""The site in headless Chromium: no errors, no other servers, accessible, on a phone, without scripts, on paper."""

import subprocess
import sys

import pytest

axe = pytest.importorskip("axe_playwright_python.sync_playwright", reason="no axe: pip install axe-playwright-python")
pytestmark = pytest.mark.slow
LECTURE, SCENES = "generated/lectures/top.html", "generated/assignments.html"
PHONE, DESK = (390, 844), (1280, 800)
AXE = {"iframes": False, "preload": False, "resultTypes": ["violations"]}  # scenes are checked as pages, not in iframes


@pytest.fixture
def opened(open_tab, address):
    """`opened(page, size, start, **options)` -> the tab of a page of the site."""

    def opened(name, size=PHONE, start=address, **options):
        return open_tab(start + name, size, (start, "data:"), reduced_motion="reduce", **options)

    return opened


@pytest.mark.parametrize("size, scheme", [(DESK, "light"), (DESK, "dark"), (PHONE, "light"), (PHONE, "dark")])
def test_axe_finds_no_fault_on_any_page(opened, site, address, size, scheme):
    tab, faults = opened("index.html", size, color_scheme=scheme), {}
    pages = [file.relative_to(site).as_posix() for file in sorted(site.rglob("*.html"))]
    scenes = [name for name in pages if name.startswith("scenes/")]
    for name in [*(name for name in pages if not name.startswith(("scenes/", "_static/"))), *scenes[::10]]:
        tab.goto(address + name)
        violations = axe.Axe().run(tab, options=AXE).response["violations"]
        if violations:
            faults[name] = [(rule["id"], rule["nodes"][0]["html"]) for rule in violations]
    assert not faults


def test_scenes_come_as_they_are_seen_and_go(opened):
    tab = opened(SCENES, DESK)
    figures = tab.locator("figure.scene")
    count = figures.count()
    assert count == 14 and tab.locator("figure.scene iframe").count() < 4
    figures.last.scroll_into_view_if_needed()
    tab.wait_for_selector("figure.scene.playing >> nth=-1")
    tab.wait_for_function("document.querySelectorAll('figure.scene')[13].querySelector('iframe') !== null")
    tab.wait_for_function("document.querySelectorAll('figure.scene')[0].querySelector('iframe') === null")


def test_paper_and_readers_without_scripts_have_a_still(opened):
    tab = opened(LECTURE, DESK)
    tab.wait_for_selector("figure.scene iframe")
    tab.emulate_media(media="print")
    assert tab.locator("figure.scene img").is_visible() and not tab.locator("figure.scene iframe").is_visible()
    plain = opened(LECTURE, DESK, java_script_enabled=False)
    assert plain.locator("figure.scene img").is_visible() and plain.locator("figure.scene img").get_attribute("alt")


def test_all_links_lead_somewhere_and_a_broken_one_is_told(course, site, tmp_path):
    check = [sys.executable, str(course / "docs" / "links.py")]
    assert subprocess.run([*check, str(site)]).returncode == 0
    (tmp_path / "a.html").write_text('<a href="b.html">b</a><img src="https://elsewhere/x.png"><a href="#none">c</a>')
    run = subprocess.run([*check, str(tmp_path)], capture_output=True, text=True)
    assert run.returncode == 1 and len(run.stdout.splitlines()) == 3
