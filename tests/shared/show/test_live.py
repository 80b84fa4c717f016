"""Live scenes: the page integrates as `solve` does, follows the mouse, and has sliders for parameters."""

import numpy as np
import pytest
from parameters import first

from tam570.course import assignments
from tam570.integrate import solve
from tam570.lectures import load, names
from tam570.show import load_student, scene_of
from tam570.show.live import program
from tam570.show.page import page

HOMEWORK = [slug for slug in assignments() if slug[:4] in {f"hw{n:02}" for n in (1, 4, 5, 6, 7, 10, 12, 13, 14)}]
LECTURES = [name for name in names() if hasattr(load(name), "START") and name != "rocket"]  # it branches on its mass
SECONDS = 1.0
SIZES = [[1280, 720], [390, 844]]


@pytest.fixture
def tab(open_page):
    """`tab(scene, size)` -> the tab with the page of the scene."""
    return lambda scene, size=SIZES[0]: open_page(page(scene), size)


@pytest.mark.parametrize("name", first(3, [*HOMEWORK, *LECTURES]))
def test_the_page_moves_as_solve_does(tab, scenes, name):
    scene = scenes(name)
    opened, live = tab(scene), scene.live
    piece = SECONDS / 60  # s per call, as in the page, because a call takes a limited number of steps
    ends = f"i * {piece}, (i + 1) * {piece}"
    result = opened.evaluate(f"[...Array(60).keys()].reduce((s, i) => integrate(s, live.p, {ends}), grasped.start)")
    expected = solve(live.rates, [0.0, SECONDS], live.start, parameters=live.parameters, rtol=1e-12)[-1]
    assert np.abs(np.array(result) - expected).max() < 1e-6 * (1 + np.abs(expected).max())
    places = opened.evaluate(
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


def test_after_a_jump_in_time_a_hand_takes_hold_of_what_the_film_shows(tab, scenes):
    """The page integrates to the film's time, though the motion needs more steps than one call of its integrator."""
    scene = scenes("hw14_rolling_disk")
    opened, live = tab(scene), scene.live
    opened.evaluate("goTo(duration)")
    times = [0.0, opened.evaluate("live.t")]
    expected = solve(live.rates, times, live.start, parameters=live.parameters, rtol=1e-12)[-1]
    assert times[1] == pytest.approx(scene.times[-1]) and opened.evaluate("live.s") == pytest.approx(expected, abs=1e-8)


@pytest.mark.parametrize("size", first(1, SIZES))
def test_the_bob_goes_where_it_is_dragged_and_swings_on(tab, scenes, size):
    opened = tab(scenes("hw01_simple_pendulum"), size)
    before, hinge = opened.evaluate(
        "() => { followFilm(); return [handlePlace(grasped.handles[0]), livePoint([0, 0])]; }"
    )
    box = opened.locator("#live").bounding_box()
    x, y = before[0] + box["x"], before[1] + box["y"]
    opened.mouse.move(x, y)
    opened.mouse.down()
    opened.mouse.move(x - 40, y + 30, steps=4)
    playing, (theta, omega) = opened.evaluate("[live.on, live.s]")
    opened.mouse.up()
    assert playing and omega == 0.0
    wanted = np.array(before) + [-40, 30] - hinge
    assert np.arctan2(wanted[0], wanted[1]) == pytest.approx(theta, abs=0.02)
    opened.evaluate("advanceLive(0.5)")
    parameters = {"length": 1.0, "gravity": 9.81}
    now, state = opened.evaluate("[live.t, live.s]")
    expected = solve(scenes("hw01_simple_pendulum").live.rates, [0.0, now], [theta, 0.0], parameters=parameters)[-1]
    assert state == pytest.approx(expected.tolist(), abs=1e-6)
    opened.get_by_role("button", name="Back to the film").click()
    assert not opened.evaluate("live.on")


def test_a_slider_sets_its_parameter(tab, scenes):
    opened = tab(scenes("hw07_double_pendulum"), SIZES[1])
    sliders = opened.locator("#sliders input")
    assert sliders.count() == 5
    sliders.nth(4).evaluate("(slider) => { slider.value = 5; slider.dispatchEvent(new Event('input')); }")
    assert opened.evaluate("live.p[4]") == 5.0


def test_what_cannot_be_traced_stays_a_film(tab, tmp_path, solution_text):
    text = solution_text("hw01_simple_pendulum")
    asks = """

_correct = angular_momentum_balance


def angular_momentum_balance(theta, omega, *, mass, length, gravity):
    mass = 1.0 * mass if {condition} else mass
    return _correct(theta, omega, mass=mass, length=length, gravity=gravity)
"""
    file = tmp_path / "hw01_simple_pendulum.py"
    for condition, sliders in (("length > 0", 0), ("theta > 100", None)):
        file.write_text(text + asks.format(condition=condition))
        scene = scene_of(load_student(file, file.stem), file.stem)
        written = program(scene.live)
        assert (written is None) == (sliders is None)
        assert written is None or len(written.data["parameters"]) == sliders
    assert tab(scene).evaluate("grasped === null && program === null && !live.on")
