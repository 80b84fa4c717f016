"""A film as one page of HTML that needs nothing else."""

import html
import json
from pathlib import Path
from string import Template
from typing import Any

from tam570.show.compact import packed
from tam570.show.film import Film

__all__ = ["HERE", "framed", "page"]

HERE = Path(__file__).parent / "player"


def page(film: Film) -> str:
    """The page. What comes from a student is data in it, never markup or code."""
    return Template(_part("page.html")).substitute(
        title=html.escape(film.title),
        sight=html.escape(film.sight),
        notes="".join(f'<p class="note">{html.escape(note)}</p>' for note in film.notes),
        style=_part("page.css"),
        view=_part("space.js" if film.in_space else "plane.js"),
        strips=_part("strips.js"),
        player=_part("player.js"),
        film=_data(packed(film)),
    )


def framed(document: str, title: str, height: int) -> str:
    """A page inside another, a notebook say; it cannot reach out of its frame."""
    style = f"width:100%;height:{height}px;border:0"
    return (
        f'<iframe title="{html.escape(title)}" style="{style}" sandbox="allow-scripts" '
        f'srcdoc="{html.escape(document)}"></iframe>'
    )


def _data(film: dict[str, Any]) -> str:
    """JSON that no string in it can end early."""
    return json.dumps(film, ensure_ascii=True, allow_nan=False, separators=(",", ":")).replace("<", "\\u003c")


def _part(name: str) -> str:
    return (HERE / name).read_text(encoding="utf-8")
