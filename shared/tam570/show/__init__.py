"""Animated scenes: `show` runs a student's functions, or those of a lecture, and draws the motion."""

import os
import sys
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from html import escape
from importlib import import_module
from pathlib import Path
from types import ModuleType, SimpleNamespace

from tam570.course import contract, folder, slug_of
from tam570.lectures import is_lecture
from tam570.loading import Trouble
from tam570.show.lecture import filmed, lecture_module
from tam570.show.patience import patience
from tam570.show.scene import Scene
from tam570.show.student import StudentModule, load_student
from tam570.values import Numbers, Parameters

__all__ = ["Shown", "Trouble", "load_student", "present", "save", "scene_of", "show"]

SAVED_AS = (".html", ".png", ".gif", ".webp", ".mp4")


@dataclass(frozen=True)
class Shown:
    """A scene, or the reason why there is none; a notebook shows it inline.

    Parameters
    ----------
    scene : Scene or None
    trouble : str
        The reason, if there is no scene.
    height : int
        In pixels, in a notebook.
    """

    scene: Scene | None
    trouble: str = ""
    height: int = 620  # pixels, in a notebook

    def _repr_html_(self) -> str:
        from tam570.show.page import framed, page

        if self.scene is None:
            return f"<pre>{escape(self.trouble)}</pre>"
        return framed(page(self.scene), self.scene.title, self.height)

    def __repr__(self) -> str:
        return self.trouble if self.scene is None else f"<{self.scene.title}: {self.scene.times[-1]:g} s>"

    def save(self, file: str | Path) -> None:
        """Write the scene to a file .html, .png, .gif, .webp or .mp4; raise Trouble if that fails."""
        if self.scene is None:
            raise Trouble(self.trouble)
        save(self.scene, Path(file))


def show(what: object, *, assignment: str | None = None, numbers: Parameters | None = None, height: int = 620) -> Shown:
    """Make the scene of an assignment from the student's functions, or the scene of a lecture.

    Parameters
    ----------
    what : module, path or dict
        The student's module or its file; in a notebook also `globals()`, with the name of the assignment; or the
        module of a lecture, or the file of a copy.
    assignment : str, optional
        Such as "hw07", if the name of the module does not tell.
    numbers : mapping, optional
        Other values, such as {"mass": 2.0, "start.vx": 3.0}.
    height : int
        In pixels, in a notebook.

    Returns
    -------
    Shown
        With the reason, if there is no scene.

    Raises
    ------
    Unknown
        If an assignment or a number has no such name.

    Examples
    --------
    >>> from tam570.lectures import top
    >>> show(top, numbers={"seconds": 2.0})
    <Heavy top: 2 s>
    """
    try:
        return Shown(_scene(what, assignment, numbers), height=height)
    except Trouble as trouble:
        return Shown(None, str(trouble), height)


def _scene(what: Numbers, assignment: str | None, numbers: Parameters | None) -> Scene:
    if isinstance(what, str | Path):
        if assignment is None and is_lecture(str(what)):
            return filmed(lecture_module(str(what)), numbers)
        slug = folder(assignment).name if assignment else slug_of(Path(what))
        return scene_of(load_student(Path(what), slug), slug, numbers)
    if assignment is None and hasattr(what, "EXAMPLE"):
        return filmed(what, numbers)
    if isinstance(what, dict):
        what = SimpleNamespace(**what)
    return scene_of(what, folder(assignment or what.__name__).name, numbers)


def scene_of(module: ModuleType, slug: str, numbers: Parameters | None = None) -> Scene:
    """Make an assignment's scene from the functions of a module, with other numbers. Raise Trouble if that fails."""
    name = f"tam570.show.scenes.{slug[:4]}"
    try:
        scene = import_module(name)
    except ModuleNotFoundError as error:
        if error.name != name:
            raise
        raise Trouble(f"{slug} has no scene; write shared/tam570/show/scenes/{slug[:4]}.py") from None
    student = StudentModule(module, contract(slug)["results"])
    return replace(filmed(scene, numbers, student), notes=student.notes)


def present(film: Callable[[], Scene], where: Path | None, name: str, notes: Sequence[str] = ()) -> int:
    """Make a scene and save it, or write its page here and open it in a browser; return 0, or 1 if that fails.

    name  : of the page, without .html
    notes : shown with the scene
    """
    file = where or Path(f"{name}.html")
    try:
        scene = film()
        scene = replace(scene, notes=[*notes, *scene.notes])
        with patience(file.name):
            save(scene, file)
    except Trouble as trouble:
        print(f"tam570: {trouble}", file=sys.stderr)
        return 1
    for caption in scene.notes:
        print(caption, file=sys.stderr)
    print(file)
    if where is None and not _opened(file):
        print("There is no browser to open it in; the page plays in any, on a phone too.", file=sys.stderr)
    return 0


def _opened(page: Path) -> bool:
    """Open the page in a graphical browser and return whether that worked; start no browser in the terminal."""
    import webbrowser

    screen = sys.platform in ("win32", "darwin") or {"DISPLAY", "WAYLAND_DISPLAY", "BROWSER"} & set(os.environ)
    return bool(screen) and webbrowser.open(page.resolve().as_uri())


def save(scene: Scene, file: Path) -> None:
    """Write a scene to a file in the format of its suffix. Raise Trouble if that fails."""
    if file.suffix == ".html":
        from tam570.show.page import page

        file.write_text(page(scene), encoding="utf-8")
    elif file.suffix in SAVED_AS:
        from tam570.show.pictures import write

        write(scene, file)
    else:
        raise Trouble(f"cannot save {file.name}; choose a name that ends in {', '.join(SAVED_AS)}")
