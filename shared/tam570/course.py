"""The released assignments: their folders, names, titles, contracts and stubs."""

import ast
import json
import re
from dataclasses import dataclass
from difflib import get_close_matches
from pathlib import Path

from tam570.values import Json


class Unknown(Exception):
    """No assignment, function or file has this name, or several have it; the message lists the choices."""


@dataclass(frozen=True)
class Stub:
    """The parameters of a function in a file, and whether its body is written."""

    positions: tuple[str, ...]
    keywords: tuple[str, ...]  # keyword-only
    written: bool
    takes_any: bool  # *args or **kwargs


def assignments() -> list[str]:
    """Return the names of all assignments, in order."""
    return sorted(path.name for path in _home().glob("hw*") if (path / "README.md").exists())


def folder(name: str, or_lecture: bool = False) -> Path:
    """Return the released folder of the assignment with this name: hw07, hw7, 7, double_pendulum, or its full name.

    or_lecture : whether the message of Unknown also suggests lectures
    """
    plain = name.lower().replace("-", "_")
    number = re.fullmatch(r"(?:hw)?0*(\d{1,2})", plain)
    matches = [slug for slug in assignments() if plain == slug or number and slug[2:4] == f"{int(number[1]):02}"]
    for part in ("_{}_", "{}"):  # whole words first
        if not (matches or number) and (len(plain) > 2 or part != "{}") and plain:
            matches = [slug for slug in assignments() if part.format(plain) in f"{slug[4:]}_"]
    if not matches and len(plain) > 2:
        matches = [slug for slug in assignments() if slug.startswith(plain)]
    if len(matches) == 1:
        return _home() / matches[0]
    if matches:
        raise Unknown(f"{name!r} matches {', '.join(matches)}; say which")
    what = "neither an assignment nor a lecture" if or_lecture else "not an assignment"
    raise Unknown(f"{name!r} is {what}{_meant(plain, or_lecture)}")


def _meant(name: str, or_lecture: bool) -> str:
    """Return the end of a message about an unknown name: similar names, and which commands list all."""
    from tam570.lectures import names  # not at the top: it imports this module

    if name in names():
        return f"; it is a lecture: tam570 show {name}"
    all_names = [*names()] * or_lecture + [part for slug in assignments() for part in (slug[5:], slug)]
    close = "".join(f"; did you mean {match}?" for match in get_close_matches(name, all_names, 1))
    lectures = ", `tam570 list --lectures` the lectures" * or_lecture
    return f"{close or ';'} `tam570 list` shows all{lectures}"


def slug_of(file: Path) -> str:
    """Return the assignment of a student's file by its name, such as hw07-final.py, else by its folder's name.

    Raise Unknown if neither names an assignment, or the name fits two.
    """
    for name in (file.stem, file.resolve().parent.name):
        number = re.match(r"hw\d\d(?!\d)", name, re.IGNORECASE)
        for slug in assignments():
            if number and slug.startswith(f"{number[0].lower()}_"):
                others = [other for other in assignments() if other[4:] in name.lower() and other[4:] not in slug]
                if others:
                    raise Unknown(f"{file.name} may be {slug} or {others[0]}; say which: --assignment {slug[:4]}")
                return slug
    raise Unknown(
        f"the name of {file.name} does not tell which assignment it is; say so: --assignment hw07, for example"
    )


def title(slug: str) -> str:
    """Return the title of an assignment: the heading of its README without the number."""
    with open(_home() / slug / "README.md", encoding="utf-8") as file:
        return file.readline().lstrip("# ").partition(": ")[2].strip()


def contract(slug: str) -> Json:
    """Return the forms of the functions' results and the bans: {"results": ..., "off_limits": ...}."""
    data: Json = json.loads((folder(slug) / "contract.json").read_text(encoding="utf-8"))
    return data


def stubs(source: str | bytes) -> dict[str, Stub]:
    """Return the top-level functions of a module by name. Raise SyntaxError if the source is not Python."""
    functions = {}
    for node in (node for node in ast.parse(source).body if isinstance(node, ast.FunctionDef)):
        last, returns = node.body[-1], any(isinstance(inner, ast.Return) for inner in ast.walk(node))
        empty = not returns and isinstance(last, ast.Raise) and "NotImplementedError" in ast.dump(last)
        signature = node.args
        positions = tuple(argument.arg for argument in signature.posonlyargs + signature.args)
        keywords = tuple(argument.arg for argument in signature.kwonlyargs)
        functions[node.name] = Stub(positions, keywords, not empty, bool(signature.vararg or signature.kwarg))
    return functions


def _home() -> Path:
    """Return the folder of all assignments: in an installed wheel, else in the checkout."""
    package = Path(__file__).resolve().parent
    installed = package / "assignments"
    return installed if installed.is_dir() else package.parents[1] / "assignments"
