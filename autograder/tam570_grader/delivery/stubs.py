"""Makes a student's stub from the reference solution: the bodies go, the signatures and docstrings stay."""

import ast
import re
import sys
from pathlib import Path

from tam570_grader.writing import assignments

__all__ = ["run", "stub"]

BODY = "raise NotImplementedError"


def run(course: Path, *, check: bool) -> int:
    """Write every stub that is out of date, or with `check` name it; the exit code."""
    stale = [slug for slug in assignments.slugs(course) if _stale(course, slug)]
    for slug in stale:
        if not check:
            path = _path(course, slug)
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(stub(_solution(course, slug)), encoding="utf-8")
        print(
            f"{_path(course, slug)} {'is out of date: run tam570-grader stubs' if check else 'written'}",
            file=sys.stderr,
        )
    return 1 if check and stale else 0


def stub(source: str) -> str:
    """The stub of a solution's source.

    A function named in `__all__` keeps its signature and docstring; other public definitions stay as they are;
    private ones go, and with them their comments and the imports and constants that nothing uses any more.
    """
    tree = ast.parse(source)
    exported = _exported(tree)
    kept = [node for node in tree.body if not _private(node)]
    texts = {node: _text(source, node, exported) for node in kept}
    while unused := [node for node in kept if _unused(node, kept, texts)]:
        kept = [node for node in kept if node not in unused]
    return _joined([(node, texts[node]) for node in kept])


def _exported(tree: ast.Module) -> set[str]:
    for node in tree.body:
        if isinstance(node, ast.Assign) and ast.unparse(node.targets[0]) == "__all__":
            return set(ast.literal_eval(node.value))
    raise ValueError("a solution must name what students write in __all__")


def _names(node: ast.stmt) -> list[str]:
    """The names that a statement defines."""
    if isinstance(node, ast.FunctionDef | ast.ClassDef):
        return [node.name]
    if isinstance(node, ast.Import | ast.ImportFrom):
        return [(alias.asname or alias.name).split(".")[0] for alias in node.names]
    if isinstance(node, ast.Assign):
        return [name.id for target in node.targets for name in ast.walk(target) if isinstance(name, ast.Name)]
    return []


def _private(node: ast.stmt) -> bool:
    names = _names(node)
    return bool(names) and all(name.startswith("_") and name != "__all__" for name in names)


def _text(source: str, node: ast.stmt, exported: set[str]) -> str:
    if not (isinstance(node, ast.FunctionDef) and node.name in exported):
        return ast.get_source_segment(source, node) or ""
    docstring = node.body[0]
    lines = source.splitlines()[node.lineno - 1 : docstring.end_lineno]
    return "\n".join([*lines, f"    {BODY}"])


def _unused(node: ast.stmt, kept: list[ast.stmt], texts: dict[ast.stmt, str]) -> bool:
    """Whether an import or a constant is used by nothing that is left; `np` stays, for students expect it."""
    if not isinstance(node, ast.Import | ast.ImportFrom | ast.Assign) or {"__all__", "np"} & set(_names(node)):
        return False
    others = " ".join(_code(texts[other]) for other in kept if other is not node)
    return not any(re.search(rf"\b{re.escape(name)}\b", others) for name in _names(node))


def _code(text: str) -> str:
    """The text without docstrings."""
    return re.sub(r'"""[\s\S]*?"""', "", text)


def _joined(parts: list[tuple[ast.stmt, str]]) -> str:
    """The texts, two blank lines around functions and one between other things, imports together."""
    out = ""
    for before, (node, text) in zip([None, *(node for node, _ in parts)], parts, strict=False):
        out += _gap(before, node) + text
    return out + "\n"


def _gap(before: ast.stmt | None, node: ast.stmt) -> str:
    if before is None:
        return ""
    if isinstance(before, ast.FunctionDef | ast.ClassDef) or isinstance(node, ast.FunctionDef | ast.ClassDef):
        return "\n\n\n"
    alike = isinstance(before, ast.Import | ast.ImportFrom) and isinstance(node, ast.Import | ast.ImportFrom)
    return "\n" if alike else "\n\n"


def _path(course: Path, slug: str) -> Path:
    return course / "assignments" / slug / f"{slug}.py"


def _solution(course: Path, slug: str) -> str:
    return (course / "solutions" / f"{slug}.py").read_text(encoding="utf-8")


def _stale(course: Path, slug: str) -> bool:
    path = _path(course, slug)
    return not path.exists() or path.read_text(encoding="utf-8") != stub(_solution(course, slug))
