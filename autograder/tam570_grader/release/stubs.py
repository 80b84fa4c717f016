"""Generate students' stubs from the reference solutions: signatures and docstrings without bodies.

Also generate the contract (the forms of the results), the figure, and the points in the README.
"""

import ast
import re
from itertools import pairwise
from pathlib import Path

from tam570_grader.checks import assignments
from tam570_grader.checks.rubric import load_rubric, with_rubric
from tam570_grader.course.contract import contract, with_points
from tam570_grader.errors import say

BODY = "raise NotImplementedError"


def run(course: Path, *, check: bool) -> int:
    """Write each generated file that is out of date, or with `check` only print its path; return the exit code."""
    generated = {path: text for slug in assignments.slugs(course) for path, text in _generated(course, slug).items()}
    stale = {
        path: text for path, text in generated.items() if not path.exists() or path.read_text(encoding="utf-8") != text
    }
    for path, text in stale.items():
        if not check:
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding="utf-8")
        say(f"{path} {'is out of date: run tam570-grader stubs' if check else 'written'}", error=True)
    return 1 if check and stale else 0


def _generated(course: Path, slug: str) -> dict[Path, str]:
    """Return path and text of an assignment's generated files: stub, contract, README with points, figure."""
    released, solution = course / "assignments" / slug, course / "solutions" / f"{slug}.py"
    readme, rubric = released / "README.md", load_rubric(released)
    figure = assignments.figure(course, slug)
    worth = assignments.assignment(course, slug).worth
    texts = {
        released / f"{slug}.py": stub(solution.read_text(encoding="utf-8")),
        released / "contract.json": contract(assignments.assignment(course, slug)),
    }
    if readme.exists():
        texts[readme] = with_points(with_rubric(readme.read_text(encoding="utf-8"), rubric), worth)
    if figure:
        texts[released / "figure.svg"] = figure.svg()
    return texts


def stub(source: str) -> str:
    """Return the stub of a solution's source.

    A function named in `__all__` keeps its signature and docstring; other public definitions are unchanged. Private
    ones are removed, also all comments between definitions, and imports and constants that are then unused.
    """
    tree = ast.parse(source)
    names = exported(tree)
    public = [node for node in tree.body if not _private(node)]
    texts = {node: _text(source, node, names) for node in public}
    while unused := [node for node in public if _unused(node, public, texts)]:
        public = [node for node in public if node not in unused]
    return _joined([(node, texts[node]) for node in public])


def exported(tree: ast.Module) -> set[str]:
    """Return the names in `__all__`: the functions that students write."""
    for node in tree.body:
        if isinstance(node, ast.Assign) and ast.unparse(node.targets[0]) == "__all__":
            return set(ast.literal_eval(node.value))
    raise ValueError("a solution must name what students write in __all__")


def _names(node: ast.stmt) -> list[str]:
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


def _unused(node: ast.stmt, others_too: list[ast.stmt], texts: dict[ast.stmt, str]) -> bool:
    """Return whether no other remaining definition uses an import or a constant; `np` counts as used."""
    if not isinstance(node, ast.Import | ast.ImportFrom | ast.Assign) or {"__all__", "np"} & set(_names(node)):
        return False
    others = " ".join(texts[other] for other in others_too if other is not node)
    code = re.sub(r'"""[\s\S]*?"""', "", others)  # without docstrings
    return not any(re.search(rf"\b{re.escape(name)}\b", code) for name in _names(node))


def _joined(parts: list[tuple[ast.stmt, str]]) -> str:
    """Return the texts with two blank lines around functions and classes, none between imports, else one."""
    out = parts[0][1]
    for (before, _), (node, text) in pairwise(parts):
        has_definition = any(isinstance(each, ast.FunctionDef | ast.ClassDef) for each in (before, node))
        both_imports = all(isinstance(each, ast.Import | ast.ImportFrom) for each in (before, node))
        out += ("\n\n\n" if has_definition else "\n" if both_imports else "\n\n") + text
    return out + "\n"
