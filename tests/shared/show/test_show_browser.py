"""The scenes in headless Chromium: played, scrubbed, turned and moved, by mouse, keys, touch and slider."""

import numpy as np
import pytest
from parameters import SLUGS, first

from tam570.course import assignments
from tam570.integrate import solve
from tam570.lectures import load, names
from tam570.show import load_student, scene_of
from tam570.show.compact import packed
from tam570.show.live import program
from tam570.show.page import framed, page
from tam570.show.plots import value_plot
from tam570.show.scene import Panel, Scene, Shape, frame_times, with_slider

PLANE, SPACE = "hw07_double_pendulum", "hw14_rolling_disk"
DESKTOP, PHONE = (1280, 720), (390, 844)
PIXELS = "id => document.getElementById(id).toDataURL()"
TIME = "() => Number(document.getElementById('scrub').value)"


@pytest.fixture
def opened(open_page, scenes):
    """`opened(name or document, size)` -> the tab with the page of a scene, paused unless motion is wanted."""

    def opened(what, size=DESKTOP, **options):
        return open_page(what if what.startswith("<") else page(scenes(what)), size, **options)

    return opened


def until(tab, condition):
    """Wait until a condition is true; the page's security policy forbids the driver's way of waiting."""
    for _ in range(6000):
        if tab.evaluate(condition):
            return
        tab.wait_for_timeout(50)
    raise AssertionError(f"not within 5 minutes: {condition}")


def ink(tab, canvas):
    """Return the number of pixels of a canvas that are not transparent."""
    return tab.evaluate(
        """id => { const canvas = document.getElementById(id), copy = new OffscreenCanvas(canvas.width, canvas.height);
                   copy.getContext("2d").drawImage(canvas, 0, 0);
                   const {data} = copy.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
                   let count = 0;
                   for (let i = 3; i < data.length; i += 4) count += data[i] > 0;
                   return count; }""",
        canvas,
    )


@pytest.mark.parametrize("slug", first(1, SLUGS))
def test_every_scene_is_drawn_and_has_names(opened, slug, scenes):
    tab, scene = opened(slug), scenes(slug)
    tab.keyboard.press("End")
    for width, height in (DESKTOP, PHONE):
        tab.set_viewport_size({"width": width, "height": height})
        until(tab, f"stage.live.width < {width} && stage.live.width > {width} / 2")
        assert ink(tab, "live") > 300
    assert tab.get_by_role("img", name=scene.alt_text, exact=True).count() == 1
    assert tab.get_by_role("img").count() == 1 + len(scene.time_plots)
    assert tab.get_by_role("button", name="Play", exact=True).count() == 1
    assert tab.get_by_role("slider", name="Time").count() == tab.get_by_role("combobox", name="Speed").count() == 1
    assert tab.get_by_role("button", name="Reset view").count() == scene.in_space


def test_it_plays_by_itself_and_stops_and_goes_on(opened):
    tab = opened(PLANE, reduced_motion="no-preference")
    until(tab, "state.time > 0.1")
    tab.get_by_role("button", name="Pause").click()
    stopped, picture = tab.evaluate(TIME), tab.evaluate(PIXELS, "live")
    tab.wait_for_timeout(150)
    assert tab.evaluate(TIME) == stopped and tab.evaluate(PIXELS, "live") == picture
    tab.locator("h1").click()
    tab.keyboard.press("Space")
    until(tab, f"state.time > {stopped} + 0.1")
    assert tab.evaluate(PIXELS, "live") != picture


def test_the_time_is_scrubbed_by_keys_and_by_mouse(opened):
    tab = opened(PLANE)
    tab.keyboard.press("ArrowRight")
    assert tab.evaluate(TIME) == pytest.approx(1 / 30)
    tab.keyboard.press("ArrowLeft")
    assert tab.evaluate(TIME) == 0
    before = tab.evaluate(PIXELS, "live")
    box = tab.locator("#scrub").bounding_box()
    tab.mouse.click(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
    assert tab.evaluate(TIME) == pytest.approx(10.0, abs=0.3)
    assert tab.evaluate(PIXELS, "live") != before and tab.locator("#clock").inner_text().endswith(" s")
    tab.locator("#scrub").press("Home")
    assert tab.evaluate(TIME) == 0 and tab.evaluate(PIXELS, "live") == before


def test_a_scene_in_space_is_turned_by_mouse_and_keys_and_back(opened):
    tab = opened(SPACE)
    pictures = [tab.evaluate(PIXELS, "still")]
    box = tab.locator("#live").bounding_box()
    x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
    tab.mouse.move(x, y)
    tab.mouse.down()
    tab.mouse.move(x + 90, y + 30, steps=3)
    tab.mouse.up()
    tab.mouse.move(x, y)
    pictures.append(tab.evaluate(PIXELS, "still"))
    tab.get_by_role("button", name="Reset view").click()
    assert tab.evaluate(PIXELS, "still") == pictures[0]
    tab.locator("#live").focus()
    for key in ("Shift+ArrowLeft", "Shift+ArrowUp"):
        tab.keyboard.press(key)
        pictures.append(tab.evaluate(PIXELS, "still"))
    assert len(set(pictures)) == 4 and tab.evaluate(TIME) == 0


def test_a_scene_in_space_is_turned_by_touch(opened):
    tab = opened(SPACE, PHONE, has_touch=True)
    before = tab.evaluate("camera.azimuth")
    session = tab.context.new_cdp_session(tab)
    for event_type, points in (("touchStart", [(150, 300)]), ("touchMove", [(220, 300)]), ("touchEnd", [])):
        touches = [{"x": x, "y": y} for x, y in points]
        session.send("Input.dispatchTouchEvent", {"type": event_type, "touchPoints": touches})
    assert tab.evaluate("camera.azimuth") != before


def test_the_tip_is_where_the_student_has_it(opened, scenes):
    tab, scene = opened(PLANE), scenes(PLANE)
    (tip,) = (shape.points[:, 0] for shape in scene.panels[0].shapes if shape.form == "trail")
    for sample in (0, 333, 700, 1200):
        tab.evaluate("time => goTo(time)", scene.times[sample])
        x, y, unit = tab.evaluate(
            """() => { const {shapes, unit} = scene.panels[0], key = keyBefore(state.time);
                       const [from, next] = [key, key + 1].map((k) => keys[k] * scene.step);
                       const trail = shapes.find((one) => one.kind === "trail").at[0];
                       const hinge = shapes.find((one) => one.kind === "dot").at.find((point) => point % 3 === 1);
                       const [x, y] = place(trail, key, Math.min(1, (state.time - from) / (next - from)));
                       const [ox, oy] = place(hinge, 0, 0);
                       return [x - ox, y - oy, unit]; }"""
        )
        off = np.hypot(x * unit - tip[sample, 0], y * unit - tip[sample, 1])
        assert off < 2.5 * unit  # a pixel, which is two units, and rounding


def test_in_a_notebook_it_plays_in_its_frame(opened, scenes):
    tab = opened(f"<!doctype html><title>book</title>{framed(page(scenes(PLANE)), 'Double pendulum', 620)}")
    frame = tab.frame_locator("iframe[title='Double pendulum']")
    if frame.locator("#play").inner_text() == "Play":
        frame.locator("#play").click()
    until(tab.frames[1], "state.time > 0")
    frame.get_by_role("button", name="Pause").click()
    assert frame.locator("#clock").inner_text() != "0.00 s"


def grown(size):
    """Return a scene of a point that moves `size` m in `size` s."""
    times = frame_times(size)
    path = np.column_stack([size * times / times[-1], 0 * times])
    shapes = [Shape("dot", path[:, None], name=f"to {size:g}"), Shape("dot", np.zeros((1, 2)))]
    time_plot = value_plot(f"place of {size:g}", times, {"": path[:, 0]}, "m")
    return Scene(f"goes {size:g}", "", times, [Panel(shapes)], [time_plot])


@pytest.fixture
def film(opened):
    """Return the tab of the film of 2 m, with a slider to 1 m and 4 m."""
    return opened(page(with_slider(grown, "size", "m", [4.0, 1.0, 2.0], 2.0)), PHONE)


def test_all_films_of_a_slider_share_one_scale():
    document = packed(with_slider(grown, "size", "m", [4.0, 1.0], 2.0))
    assert document["slider"]["values"] == [1.0, 2.0, 4.0] and document["slider"]["chosen"] == 1
    small, chosen, large = document["slider"]["scenes"]
    assert chosen is None and {scene["panels"][0]["unit"] for scene in (small, document, large)} == {4.0 / 2000}
    assert small["panels"][0]["size"] == large["panels"][0]["size"]


def test_keys_change_the_value_the_length_and_what_is_shown(film):
    assert film.locator("#chosen").inner_text() == "2 m" and film.locator("#legend").inner_text() == "to 2"
    film.keyboard.press("End")
    assert film.evaluate("state.time") == pytest.approx(2.0)
    film.keyboard.press("]")
    assert film.locator("#chosen").inner_text() == "4 m" and film.evaluate("duration") == pytest.approx(4.0)
    assert film.evaluate("state.time") == pytest.approx(2.0)  # the same moment of the other motion
    assert "place of 4" in film.locator("figure").inner_text()
    film.keyboard.press("]")
    assert film.locator("#chosen").inner_text() == "4 m"
    film.get_by_label("size").focus()
    film.keyboard.press("ArrowLeft")
    film.keyboard.press("ArrowLeft")
    assert film.locator("#chosen").inner_text() == "1 m" and film.evaluate("state.time") == pytest.approx(1.0)
    assert film.get_by_label("size").get_attribute("aria-valuetext") == "1 m"
    assert film.locator("#legend").inner_text() == "to 1" and film.locator("figure").count() == 1


HOMEWORK = [slug for slug in assignments() if slug[:4] in {f"hw{n:02}" for n in (1, 4, 5, 6, 7, 10, 12, 13, 14)}]
LECTURES = [name for name in names() if hasattr(load(name), "START") and name != "rocket"]  # it branches on its mass
SECONDS = 1.0


@pytest.mark.parametrize("name", first(3, [*HOMEWORK, *LECTURES]))
def test_the_page_moves_as_solve_does(opened, scenes, name):
    tab, live = opened(name), scenes(name).live
    piece = SECONDS / 60  # s per call, as in the page, because a call takes a limited number of steps
    ends = f"i * {piece}, (i + 1) * {piece}"
    result = tab.evaluate(f"[...Array(60).keys()].reduce((s, i) => integrate(s, live.p, {ends}), grasped.start)")
    expected = solve(live.rates, [0.0, SECONDS], live.start, parameters=live.parameters, rtol=1e-12)[-1]
    assert np.abs(np.array(result) - expected).max() < 1e-6 * (1 + np.abs(expected).max())
    places = tab.evaluate(
        "grasped.handles.map(({at, dim}) => program.drawn(0, grasped.start, live.p).slice(at, at + dim))"
    )
    for position, handle in zip(places, live.handles, strict=True):
        assert position == pytest.approx(np.ravel(handle.point(np.array(live.start), **live.parameters)), abs=1e-9)


@pytest.mark.parametrize("name", [*HOMEWORK, *LECTURES])
def test_what_a_hand_holds_is_where_the_hand_is(scenes, name):
    """A handle that is grabbed at its own place stays there, by the Python functions of the scene."""
    live = scenes(name).live
    state = np.array(live.start)
    for handle in live.handles:
        position = np.ravel(handle.point(state, **live.parameters)).astype(float)
        grabbed = np.array(handle.grab([*position, 0.0][:3], state, **live.parameters), dtype=float)
        assert len(grabbed) == len(live.start)
        assert np.ravel(handle.point(grabbed, **live.parameters)) == pytest.approx(position, abs=1e-9)


def test_after_a_jump_in_time_a_hand_takes_hold_of_what_the_film_shows(opened, scenes):
    """The page integrates to the film's time, though the motion needs more steps than one call of its integrator."""
    scene, tab = scenes(SPACE), opened(SPACE)
    tab.evaluate("goTo(duration)")
    live, times = scene.live, [0.0, tab.evaluate("live.t")]
    expected = solve(live.rates, times, live.start, parameters=live.parameters, rtol=1e-12)[-1]
    assert times[1] == pytest.approx(scene.times[-1]) and tab.evaluate("live.s") == pytest.approx(expected, abs=1e-8)


@pytest.mark.parametrize("size", [DESKTOP, pytest.param(PHONE, marks=pytest.mark.slow)], ids=["desktop", "phone"])
def test_the_bob_goes_where_it_is_dragged_and_swings_on(opened, scenes, size):
    tab = opened("hw01_simple_pendulum", size)
    before, hinge = tab.evaluate("() => { followFilm(); return [handlePlace(grasped.handles[0]), livePoint([0, 0])]; }")
    box = tab.locator("#live").bounding_box()
    x, y = before[0] + box["x"], before[1] + box["y"]
    tab.mouse.move(x, y)
    tab.mouse.down()
    tab.mouse.move(x - 40, y + 30, steps=4)
    playing, (theta, omega) = tab.evaluate("[live.on, live.s]")
    tab.mouse.up()
    assert playing and omega == 0.0
    wanted = np.array(before) + [-40, 30] - hinge
    assert np.arctan2(wanted[0], wanted[1]) == pytest.approx(theta, abs=0.02)
    tab.evaluate("advanceLive(0.5)")
    parameters = {"length": 1.0, "gravity": 9.81}
    now, state = tab.evaluate("[live.t, live.s]")
    expected = solve(scenes("hw01_simple_pendulum").live.rates, [0.0, now], [theta, 0.0], parameters=parameters)[-1]
    assert state == pytest.approx(expected.tolist(), abs=1e-6)
    tab.get_by_role("button", name="Back to the film").click()
    assert not tab.evaluate("live.on")


def test_a_slider_sets_its_parameter(opened):
    tab = opened(PLANE, PHONE)
    sliders = tab.locator("#sliders input")
    assert sliders.count() == 5
    sliders.nth(4).evaluate("(slider) => { slider.value = 5; slider.dispatchEvent(new Event('input')); }")
    assert tab.evaluate("live.p[4]") == 5.0


def test_what_cannot_be_traced_stays_a_film(opened, edited):
    asks = """
_correct = angular_momentum_balance


def angular_momentum_balance(theta, omega, *, mass, length, gravity):
    mass = 1.0 * mass if {condition} else mass
    return _correct(theta, omega, mass=mass, length=length, gravity=gravity)
"""
    for condition, sliders in (("length > 0", 0), ("theta > 100", None)):
        file = edited("hw01_simple_pendulum", asks.format(condition=condition))
        scene = scene_of(load_student(file, file.stem), file.stem)
        written = program(scene.live)
        assert (written is None) == (sliders is None)
        assert written is None or len(written[1]["parameters"]) == sliders
    assert opened(page(scene)).evaluate("grasped === null && program === null && !live.on")
