"""The slider of a film that is there for several values of a number."""

import numpy as np
import pytest

from tam570.show.compact import packed
from tam570.show.page import page
from tam570.show.plots import value_plot
from tam570.show.scene import Panel, Scene, Shape, frame_times, with_slider


def grown(size):
    """A point that goes as far as it is told, in as many seconds."""
    times = frame_times(size)
    path = np.column_stack([size * times / times[-1], 0 * times])
    return Scene(
        f"goes {size:g}",
        "",
        times,
        [Panel([Shape("dot", path[:, None], name=f"to {size:g}"), Shape("dot", np.zeros((1, 2)))])],
        [value_plot(f"place of {size:g}", times, {"": path[:, 0]}, "m")],
    )


@pytest.fixture
def tab(open_page):
    """The page of the film at 2, with a slider to 1 and 4."""
    return open_page(page(with_slider(grown, "size", "m", [4.0, 1.0, 2.0], 2.0)), (390, 844))


def test_all_films_of_a_slider_share_one_scale():
    document = packed(with_slider(grown, "size", "m", [4.0, 1.0], 2.0))
    assert document["slider"]["values"] == [1.0, 2.0, 4.0] and document["slider"]["chosen"] == 1
    small, chosen, large = document["slider"]["scenes"]
    assert chosen is None and {scene["panels"][0]["unit"] for scene in (small, document, large)} == {4.0 / 2000}
    assert small["panels"][0]["size"] == large["panels"][0]["size"]


def test_the_slider_begins_at_the_value_that_was_set(tab):
    assert tab.get_by_label("size").is_visible()
    assert tab.locator("#chosen").inner_text() == "2 m"
    assert tab.locator("#legend").inner_text() == "to 2" and tab.locator("figure").count() == 1
    assert tab.evaluate("document.documentElement.scrollWidth") <= 390


def test_keys_change_the_value_the_length_and_what_is_shown(tab):
    tab.keyboard.press("End")
    assert tab.evaluate("state.time") == pytest.approx(2.0)
    tab.keyboard.press("]")
    assert tab.locator("#chosen").inner_text() == "4 m" and tab.evaluate("duration") == pytest.approx(4.0)
    assert tab.evaluate("state.time") == pytest.approx(2.0)  # the same moment of the other motion
    assert "place of 4" in tab.locator("figure").inner_text()
    tab.keyboard.press("]")
    assert tab.locator("#chosen").inner_text() == "4 m"
    tab.get_by_label("size").focus()
    tab.keyboard.press("ArrowLeft")
    tab.keyboard.press("ArrowLeft")
    assert tab.locator("#chosen").inner_text() == "1 m" and tab.evaluate("state.time") == pytest.approx(1.0)
    assert tab.get_by_label("size").get_attribute("aria-valuetext") == "1 m"
    assert tab.locator("#legend").inner_text() == "to 1" and tab.locator("figure").count() == 1
