"""A scene as one HTML page that needs no other file."""

import html
import json
from pathlib import Path
from string import Template

from tam570.show.compact import packed
from tam570.show.live import program
from tam570.show.scene import Scene

HERE = Path(__file__).parent / "player"


def page(scene: Scene) -> str:
    """Return the scene's page. Input from a student is data in it, never markup or code."""
    code, live = (scene.live and program(scene.live)) or ("const program = null;", None)
    data = {**packed(scene), "live": live}
    return Template(_read("page.html")).substitute(
        title=html.escape(scene.title),
        alt_text=html.escape(scene.alt_text),
        notes="".join(f'<p class="note">{html.escape(caption)}</p>' for caption in scene.notes),
        settings=html.escape(", ".join(f"{name} = {value}" for name, value in scene.settings.items())),
        style=_read("page.css"),
        view=_read("space.js" if scene.in_space else "plane.js"),
        program=code,
        live=_read("live.js"),
        time_plots=_read("time_plots.js"),
        player=_read("player.js"),
        # no string in the data can end the script element
        data=json.dumps(data, ensure_ascii=True, allow_nan=False, separators=(",", ":")).replace("<", "\\u003c"),
    )


def framed(document: str, title: str, height: int) -> str:
    """Return a page as a frame for another page, such as a notebook, which the framed page cannot access."""
    style = f"width:100%;height:{height}px;border:0"
    return (
        f'<iframe title="{html.escape(title)}" style="{style}" sandbox="allow-scripts" '
        f'srcdoc="{html.escape(document)}"></iframe>'
    )


def _read(name: str) -> str:
    return (HERE / name).read_text(encoding="utf-8")
