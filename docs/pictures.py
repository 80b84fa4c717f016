"""Take the pictures of feedback and of the report that the site shows.

    make demo
    python docs/pictures.py build/sample_results

They are parts of the pages as Chromium shows them, in light. The feedback names a known mistake in a motion.
"""

import shutil
import sys
import tempfile
from pathlib import Path

from playwright.sync_api import sync_playwright

from tam570_grader import cli
from tam570_grader.diagnosis.mistakes import overlays

INTO = Path(__file__).parent / "pictures"
COURSE = Path(__file__).resolve().parent.parent
SLUG, MISTAKE, CHECK = "hw07_double_pendulum", "sign_of_the_sine_term", "simulation_follows_the_equations"


def main(results):
    browser = shutil.which("chromium") or shutil.which("google-chrome")
    with sync_playwright() as playwright:
        tab = playwright.chromium.launch(executable_path=browser, args=["--no-sandbox"]).new_page(
            viewport={"width": 760, "height": 1000}, color_scheme="light"
        )
        with tempfile.TemporaryDirectory() as folder:
            tab.goto(feedback(Path(folder)).as_uri())
            tab.locator(f"li#{CHECK}").screenshot(path=INTO / "feedback.png")
        tab.set_viewport_size({"width": 1180, "height": 830})
        tab.goto((results / "report.html").resolve().as_uri())
        tab.screenshot(path=INTO / "report.png")


def feedback(folder):
    """The page of a student whose pendulum has a term with the wrong sign."""
    mistake = overlays(COURSE / "autograder" / "checks" / SLUG)[MISTAKE]
    work = folder / f"{SLUG}.py"
    work.write_text((COURSE / "solutions" / work.name).read_text() + "\n\n" + mistake)
    cli.main(["grade", str(work), "--out", str(folder / "out"), "--seed", "570"])
    (page,) = folder.glob("out/feedback/*/*.html")
    return page


if __name__ == "__main__":
    main(Path(sys.argv[1]))
