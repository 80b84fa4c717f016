"""Scenes of the reference solutions, and of files that are wrong, unfinished, or hostile."""

import importlib
import json
import re
import shutil
import signal
import time
import warnings
from html import unescape
from io import BytesIO

import numpy as np
import pytest
from parameters import SLUGS, first
from PIL import Image
from processes import imported_modules

from tam570 import cli
from tam570.lectures import bodies, load
from tam570.show import Trouble, load_student, save, show
from tam570.show.compact import PIXELS, STEPS, packed
from tam570.show.page import page
from tam570.show.patience import patience
from tam570.show.pictures import _drawn
from tam570.show.plots import drift_caption
from tam570.show.scene import Panel, Scene, Shape, frame_times
from tam570_grader.checks import assignments
from tam570_grader.diagnosis.mistakes import overlays

CHECKS = assignments.find() / "autograder" / "checks"
HW07 = "hw07_double_pendulum"


def data(document):
    """Return the data that the player of a page reads."""
    return json.loads(re.search(r'<script type="application/json" id="data">(.*?)</script>', document, re.S)[1])


def unpacked(document):
    """Return the points of each shape of a packed film at every sample, (n, m, dim), px, as the player does."""
    keys = np.cumsum(document["keys"])
    samples = np.arange(keys[-1] + 1)
    moving = document["tracks"]
    tracks = [np.transpose([np.interp(samples, keys, np.cumsum(axis)) for axis in track]) for track in moving]

    def position(number):
        index, sort = divmod(number, 3)
        if sort == 2:
            return sum(weight * position(shape) for shape, weight in document["mixed"][index])
        return tracks[index] if sort == 0 else np.array(document["fixed"][index], dtype=float)

    return [
        np.stack(np.broadcast_arrays(*(position(number) for number in shape["at"])), axis=-2) / STEPS
        for panel in document["panels"]
        for shape in panel["shapes"]
    ]


def in_pixels(scene):
    """Yield the points of each shape relative to the middle of its panel, in pixels of a large screen."""
    for panel in scene.panels:
        rows = np.concatenate([shape.points.reshape(-1, shape.points.shape[-1]) for shape in panel.shapes])
        low, high = rows.min(axis=0), rows.max(axis=0)
        for shape in panel.shapes:
            points = (shape.points - (low + high) / 2) / (high - low).max() * PIXELS
            yield np.pad(points, [(0, 0)] * (points.ndim - 1) + [(0, scene.in_space and points.shape[-1] == 2)])


def test_what_is_stored_is_the_motion_to_a_pixel(scenes, slug):
    stored = unpacked(packed(scenes(slug)))
    for points, kept_points in zip(in_pixels(scenes(slug)), stored, strict=True):
        # half a pixel by interpolation, a quarter by rounding, as much again by combining rounded points
        assert np.abs(kept_points - points).max() < 1.5


def test_a_page_takes_neither_matplotlib_nor_scipy(course, tmp_path):
    file = course / "solutions" / f"{HW07}.py"
    arguments = ["show", "hw07", str(file), "--save", str(tmp_path / "hw07.html")]
    modules = imported_modules(f"from tam570.cli import main\nassert main({arguments}) == 0")
    assert "numpy" in modules and not modules & {"matplotlib", "scipy", "sympy", "PIL", "IPython", "pytest"}
    assert (tmp_path / "hw07.html").exists()


@pytest.mark.parametrize("slug", first(2, SLUGS))
def test_of_a_stub_the_command_says_what_is_not_written(course, slug, tmp_path, capsys):
    stub = course / "assignments" / slug / f"{slug}.py"
    assert cli.main(["show", slug, str(stub), "--save", str(tmp_path / "a.html")]) == 1
    assert "is not written yet" in capsys.readouterr().err and not (tmp_path / "a.html").exists()


TROUBLES = {  # code below the solution: pattern of the message
    "simulate = lambda t, *_, **__: np.full((len(t), 4), np.nan)": "NaN or infinity, first in row 0",
    "def simulate(t, *_, **__):\n    a = np.ones((len(t), 4))\n    a[37:] = np.inf\n    return a": "row 37",
    "simulate = lambda t, *_, **__: np.zeros((4, len(t)))": r"\(4, 1201\), not .*\(1201, 4\)",
    "def simulate(t, *_, **__):\n    raise ValueError('</pre>no step left')": r"Line \d+, in simulate: .*\n.*left",
    "def simulate(t, *_, **__):\n    raise SystemExit('bye')": "exception",
    "simulate = lambda *_, **__: None": "returned None.*return",
    "del simulate": "no function simulate",
    "wireframe = lambda theta, lengths: np.full((2, 2, 2), 1e308 * np.sign(theta[0] - 1))": "no screen",
    "def simulate(:": "SyntaxError",
    "raise SystemExit(0)": "cannot be imported",
}


@pytest.mark.parametrize("text", TROUBLES)
def test_what_cannot_be_shown_is_said(edited, tmp_path, capsys, text):
    file = edited(HW07, text)
    assert cli.main(["show", "hw07", str(file), "--save", str(tmp_path / "a.html")]) == 1
    said = capsys.readouterr().err
    assert re.search(TROUBLES[text], said) and "tam570/show" not in said
    assert not (tmp_path / "a.html").exists()


@pytest.mark.parametrize("body", ["raise NotImplementedError", "return np.nan"])
def test_without_an_energy_the_motion_is_shown_all_the_same(edited, tmp_path, capsys, body):
    text, where = f"def energy(*_, **__):\n    {body}", tmp_path / "a.html"
    assert cli.main(["show", "hw07", str(edited(HW07, text)), "--save", str(where)]) == 0
    assert "energy" in capsys.readouterr().err
    assert 'class="note">energy ' in where.read_text() and len(data(where.read_text())["time_plots"]) == 1


def test_wrong_physics_looks_wrong(edited):
    wrong = overlays(CHECKS / HW07)["sign_of_the_sine_term"]
    time_plot, _ = show(edited(HW07, wrong)).scene.time_plots
    assert time_plot.alarm and "not conserved" in time_plot.caption and time_plot.span[1] > 10.0  # %


@pytest.mark.slow
def test_no_wrong_file_breaks_a_page(edited, slug, capsys):
    """Each wrong file is shown, with numbers that JSON can represent, or a message says why not."""
    texts = overlays(CHECKS / slug)
    assert len(texts) > 5
    for name, text in texts.items():
        with np.errstate(all="ignore"), warnings.catch_warnings(action="ignore"):
            shown = show(edited(slug, text))
        assert data(page(shown.scene)) if shown.scene else shown.trouble, name


def test_rounding_does_not_look_wrong():
    assert not drift_caption(1 + 1e-12 * np.sin(99 * frame_times(1.0)))[1]


def test_a_file_elsewhere_and_one_that_is_not_there(edited, here, capsys):
    edited("hw05_constrained_pendulum", "")
    assert cli.main(["show", "hw05", "--save", "swing.html"]) == 0
    assert cli.main(["show", "hw07"]) == cli.main(["show", "hw05", "no.py"]) == cli.main(["show", "hw99"]) == 2
    assert cli.main(["show", "hw05", "--save", "swing.txt"]) == 1


def test_strings_stay_data(scenes, tmp_path):
    scene, bad = scenes(HW07), "</script><script>document.title='taken'</script><!--"
    shapes = [Shape("text", np.zeros((1, 2)), words=bad, name=bad)]
    document = page(Scene(bad, f'"{bad}', scene.times, [Panel(shapes, bad)], scene.time_plots, notes=[bad]))
    assert document.count("</script>") == 2 and document.count("<script") == 2 and "<!--" not in document
    assert data(document)["panels"][0]["shapes"][0]["words"] == bad


def test_a_notebook_shows_the_page_in_a_frame_that_cannot_reach_out(course):
    file = course / "solutions" / f"{HW07}.py"
    shown = show(load_student(file, HW07))
    inline = shown._repr_html_()
    assert 'sandbox="allow-scripts"' in inline
    assert unescape(re.search(r'srcdoc="([^"]*)"', inline)[1]) == page(shown.scene)
    functions = vars(load_student(file, HW07))
    assert show(dict(functions), assignment="hw07").scene is not None


@pytest.fixture
def short(course):
    """Return a scene of 0.2 s of the double pendulum."""
    return show(course / "solutions" / f"{HW07}.py", numbers={"seconds": 0.2}).scene


@pytest.mark.parametrize(("suffix", "frames"), first(2, [(".png", 1), (".gif", 5), (".webp", 5)]))
def test_a_picture_has_the_frames_of_the_film(short, suffix, frames, tmp_path):
    save(short, tmp_path / f"a{suffix}")
    with Image.open(tmp_path / f"a{suffix}") as picture:
        assert picture.n_frames == frames and len(picture.convert("RGB").getcolors(1 << 20)) > 20


def test_a_frame_on_its_backdrop_is_the_frame_drawn_whole(short):
    figure, moving = _drawn(short)
    pixels = []
    for keep in (False, True):
        if keep:
            figure.keep_backdrop({artist for artist, _ in moving})
        for sample in (0, 9):
            for _, update in moving:
                update(sample)
            figure.savefig(buffer := BytesIO(), format="rgba")
            pixels.append(buffer.getvalue())
    assert pixels[0] != pixels[1] and pixels[:2] == pixels[2:]


def test_an_interrupted_picture_leaves_no_file(short, tmp_path, monkeypatch):
    grab = "matplotlib.animation.PillowWriter.grab_frame"
    monkeypatch.setattr(grab, lambda writer: signal.raise_signal(signal.SIGINT))
    with pytest.raises(KeyboardInterrupt):
        save(short, tmp_path / "film.gif")
    assert not list(tmp_path.iterdir())


def test_a_video_is_written_and_without_ffmpeg_refused_with_another_way(short, tmp_path, monkeypatch):
    if shutil.which("ffmpeg"):
        save(short, tmp_path / "a.mp4")
        assert b"ftyp" in (tmp_path / "a.mp4").read_bytes()[:16]
        (tmp_path / "a.mp4").unlink()
    monkeypatch.setenv("PATH", str(tmp_path))
    with pytest.raises(Trouble, match=r"needs ffmpeg.*\.gif"):
        save(short, tmp_path / "a.mp4")
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize("screen", [True, False])
def test_show_opens_the_page_in_a_browser_where_there_is_a_screen(course, here, monkeypatch, capsys, screen):
    """With or without a screen, the page is written into the folder."""
    opened = []
    monkeypatch.setattr("webbrowser.open", lambda address: opened.append(address) or True)
    for name in ("BROWSER", "DISPLAY", "WAYLAND_DISPLAY"):
        monkeypatch.delenv(name, raising=False)
    if screen:
        monkeypatch.setenv("BROWSER", "some")
    assert cli.main(["show", "hw05", str(course / "solutions" / "hw05_constrained_pendulum.py")]) == 0
    page = here / "hw05_constrained_pendulum.html"
    assert opened == [page.as_uri()] * screen and 'id="scrub"' in page.read_text()
    assert page.name in capsys.readouterr().out


@pytest.mark.parametrize("slug", first(2, SLUGS))
def test_an_assignment_is_shown_with_other_numbers(slug, course, tmp_path):
    scene = importlib.import_module(f"tam570.show.scenes.{slug[:4]}")
    file, where = course / "solutions" / f"{slug}.py", tmp_path / "a.html"
    name = next(iter(scene.EXAMPLE))
    value = np.multiply(1.05, scene.EXAMPLE[name]).tolist()
    text = ",".join(map(str, value)) if isinstance(value, list) else str(value)
    assert cli.main(["show", slug, str(file), "--set", f"{name}={text}", "--save", str(where)]) == 0
    assert re.search(rf"{name} = \(?{str(value).strip('[]').split(',')[0]}", where.read_text())
    assert cli.main(["show", slug, str(file), "--set", "nonsense=3", "--save", str(where)]) == 2


def test_what_moves_too_fast_or_for_too_long_is_refused():
    assert "try gravity nearer to 9.81" in show(load("chains"), numbers={"gravity": 1e60}).trouble
    assert "188 rad/s" in show(bodies, numbers={"newton": 1e6}).trouble
    assert "start.phi_rate" in show(load("top"), numbers={"start.phi_rate": 1e6}).trouble
    with pytest.raises(ValueError, match="the motion takes longer"), patience("the motion", 0.0):
        while True:  # until `patience` has read the clock twice
            time.sleep(0.01)
