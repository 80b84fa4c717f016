"""Find which tests a change of the code affects: those that call a function that has changed, directly or not.

Changes of comments, blank lines and docstrings do not count.
"""

import ast
import hashlib
from collections.abc import Iterable, Iterator, Mapping

ANY = "*"  # in place of a function's name: the test may call any function
Statements = Mapping[str, list[ast.stmt]]  # of a module, by the names that they bind; "" for those that bind none


def keys(tests: str, code: str, module: str) -> dict[str, str]:
    """Return for each test a digest of everything in the two sources on which its outcome depends.

    module : the name by which the tests import the code
    Raise SyntaxError if a source is not Python.
    """
    here, there = _statements(tests), _statements(code)
    names = {}
    for name, used in calls(tests, module).items():
        digest = _digest(here, [name])
        names[name] = _hash([digest, _digest(there, sorted(there if ANY in used else used))])
    return names


def calls(tests: str, module: str) -> dict[str, set[str]]:
    """Return the functions of the module that each test names, directly or in its helpers.

    If a test passes on the module itself, as to getattr, these include ANY and all its strings.
    """
    here = _statements(tests)
    aliases, members = _imported(here, module)
    names: dict[str, set[str]] = {}
    for name in here:
        if name.startswith(("test_", "Test")):
            nodes = [node for reached in _reached(here, [name]) for node in here[reached]]
            names[name] = _named(nodes, aliases, members)
    return names


def by_parameters(names: Mapping[str, set[str]], tests: Iterable[str]) -> dict[str, set[str]]:
    """Return the functions that each of these tests calls, by the test's name with parameters.

    If a test may call any function, those that its parameters name are meant.
    """
    used = {}
    for test in tests:
        name, _, parameters = test.partition("[")
        functions = names.get(name, set())
        meant = functions & set(parameters.rstrip("]").split("-")) if ANY in functions else set()
        used[test] = meant or functions - {ANY}
    return used


def uses(code: str, names: Iterable[str]) -> set[str]:
    """Return these names of a source and all names that their definitions use, directly or not."""
    return _reached(_statements(code), names)


def _named(nodes: Iterable[ast.stmt], aliases: set[str], members: Mapping[str, str]) -> set[str]:
    names: set[str] = set()
    strings: set[str] = set()
    through_alias = alone = 0
    for node in (inner for statement in nodes for inner in ast.walk(statement)):
        if isinstance(node, ast.Attribute) and isinstance(node.value, ast.Name) and node.value.id in aliases:
            names.add(node.attr)
            through_alias += 1
        elif isinstance(node, ast.Name):
            alone += node.id in aliases
            names |= {members[node.id]} if node.id in members else set()
        elif isinstance(node, ast.Constant) and isinstance(node.value, str):
            strings.add(node.value)
    return names if alone == through_alias else names | strings | {ANY}


def _imported(statements: Statements, module: str) -> tuple[set[str], dict[str, str]]:
    """Return the names under which the module is imported, and its members by the names under which these are."""
    aliases: set[str] = set()
    members: dict[str, str] = {}
    for node in (node for nodes in statements.values() for node in nodes):
        if isinstance(node, ast.Import):
            aliases |= {alias.asname or alias.name for alias in node.names if alias.name == module}
        if isinstance(node, ast.ImportFrom) and node.module == module:
            members |= {alias.asname or alias.name: alias.name for alias in node.names}
    return aliases, members


def _statements(source: str) -> Statements:
    names: dict[str, list[ast.stmt]] = {"": []}
    for node in map(_undocumented, ast.parse(source).body):
        for name in _bound(node) or [""]:
            names.setdefault(name, []).append(node)
    return names


def _bound(node: ast.stmt) -> list[str]:
    """Return the names that a statement binds; none if it may have other effects."""
    if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef | ast.ClassDef):
        return [node.name]
    if isinstance(node, ast.Import | ast.ImportFrom):
        names = [alias.asname or alias.name.partition(".")[0] for alias in node.names]
        return [] if "*" in names else names
    if isinstance(node, ast.Assign | ast.AnnAssign):
        targets = node.targets if isinstance(node, ast.Assign) else [node.target]
        inner = [node for target in targets for node in ast.walk(target)]
        plain = all(isinstance(node, ast.Name | ast.Tuple | ast.expr_context) for node in inner)
        return [node.id for node in inner if isinstance(node, ast.Name)] if plain else []
    return []


def _reached(statements: Statements, names: Iterable[str]) -> set[str]:
    """Return these names and all that their definitions, and statements with other effects, use, directly or not."""
    reached: set[str] = set()
    waiting = ["", *names]
    while waiting:
        name = waiting.pop()
        if name in statements and name not in reached:
            reached.add(name)
            waiting += [used for node in statements[name] for used in _uses(node)]
    return reached


def _uses(node: ast.stmt) -> Iterator[str]:
    for inner in ast.walk(node):
        if isinstance(inner, ast.Name):
            yield inner.id
        elif isinstance(inner, ast.arg):
            yield inner.arg  # the name of an argument may be that of a fixture


def _digest(statements: Statements, names: Iterable[str]) -> str:
    names = list(names)
    reached = sorted(_reached(statements, names))
    written = [ast.dump(node) for name in reached for node in statements[name]]
    return _hash([*names, *written])


def _undocumented(node: ast.stmt) -> ast.stmt:
    if isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant):
        return ast.Pass()
    if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef | ast.ClassDef) and ast.get_docstring(node):
        node.body = node.body[1:] or [ast.Pass()]
    return node


def _hash(texts: Iterable[str]) -> str:
    return hashlib.sha256("\0".join(texts).encode()).hexdigest()[:16]
