"""The scenes of the site: a page and a still for each assignment, by its reference solution, and for each lecture."""

import html
import os
from concurrent.futures import ProcessPoolExecutor
from functools import cache
from pathlib import Path

from docutils import nodes
from PIL import Image
from sphinx.util.docutils import SphinxDirective
from sphinx.util.logging import getLogger

from tam570.course import assignments
from tam570.lectures import load, names
from tam570.show import load_student, save, scene_of
from tam570.show.lecture import filmed
from tam570.show.page import page

COURSE = Path(__file__).resolve().parents[2]
WIDTH, QUALITY = 800, 80  # pixels of a still, and of its WebP


def setup(app):
    app.connect("builder-inited", _write_all)
    app.add_directive("scene", SceneDirective)
    return {"parallel_read_safe": True}


@cache
def film(name):
    """Return the scene of an assignment, by its reference solution, or of a lecture."""
    if name in names():
        return filmed(load(name))
    return scene_of(load_student(COURSE / "solutions" / f"{name}.py", name), name)


def _write_all(app):
    if app.builder.format != "html":
        return
    folder = Path(app.outdir, "scenes")
    folder.mkdir(parents=True, exist_ok=True)
    getLogger(__name__).info("making the scenes and their stills")
    with ProcessPoolExecutor(os.cpu_count()) as processes:
        list(processes.map(_write, [folder] * 100, [*assignments(), *names()]))


def _write(folder, name):
    """Write the page of a scene and its still."""
    picture = folder / f"{name}.png"
    save(film(name), picture)
    with Image.open(picture) as image:
        small = image.convert("RGB").resize(
            (WIDTH, round(image.height * WIDTH / image.width)), Image.Resampling.LANCZOS
        )
        small.save(folder / f"{name}.webp", quality=QUALITY)
    picture.unlink()
    (folder / f"{name}.html").write_text(page(film(name)), encoding="utf-8")


class SceneDirective(SphinxDirective):
    """`{scene} NAME`: a still, which `scenes.js` replaces by the playing scene while it is on the screen."""

    required_arguments = 1

    def run(self):
        (name,), up = self.arguments, "../" * self.env.docname.count("/")
        alt_text, title = html.escape(film(name).alt_text), html.escape(film(name).title)
        markup = (
            f'<figure class="scene" data-page="{up}scenes/{name}.html" data-title="{title}">'
            f'<img src="{up}scenes/{name}.webp" width="800" height="448" loading="lazy" alt="{alt_text}">'
            f"</figure>"
        )
        return [nodes.raw("", markup, format="html")]
