"""What a module is used for elsewhere, it says in `__all__`; the common utilities say what it does, too."""

import ast

import pytest

from tam570_grader.checks import assignments

COURSE = assignments.find()
MODULES = {
    ".".join(path.relative_to(room).with_suffix("").parts).removesuffix(".__init__"): ast.parse(path.read_text())
    for room in (COURSE / "shared", COURSE / "autograder")
    for path in room.glob("tam570*/**/*.py")
}
SHARED = sorted(name for name in MODULES if name.partition(".")[0] == "tam570")


def exported(module):
    """The names in `__all__`, or None."""
    for one in MODULES[module].body:
        if isinstance(one, ast.Assign) and ast.unparse(one.targets[0]) == "__all__":
            return set(ast.literal_eval(one.value))
    return None


def taken(module):
    """(module, name) of all that one module takes from others: by `from m import name`, and as m.name."""
    tree = MODULES[module]
    scopes = [one for one in ast.walk(tree) if isinstance(one, ast.FunctionDef)]
    found = set().union(*(taken_in(one, ast.walk(one), module) for one in scopes))
    return found | taken_in(tree, tree.body, module)


def taken_in(scope, statements, module):
    """What is taken by the imports among these statements, of which the scope knows."""
    found, modules = set(), {}
    for one in (one for one in statements if isinstance(one, ast.ImportFrom)):
        source = f"{module.rpartition('.')[0]}.{one.module}" if one.level else one.module  # a neighbour
        for alias in one.names:
            whole = f"{source}.{alias.name}"
            if whole in MODULES:
                modules[alias.asname or alias.name] = whole
            elif source in MODULES:
                found.add((source, alias.name))
    used = [one for one in ast.walk(scope) if isinstance(one, ast.Attribute) and isinstance(one.value, ast.Name)]
    return found | {(modules[one.value.id], one.attr) for one in used if one.value.id in modules}


def functions(module):
    found = [one for one in MODULES[module].body if isinstance(one, ast.FunctionDef) and not one.name.startswith("_")]
    return [one for one in found if "overload" not in map(ast.unparse, one.decorator_list)]


def test_what_is_taken_is_told_from_what_is_exported():
    assert ("tam570.integrate.adaptive_loop", "let_pass") in taken("tam570.integrate.ensemble")
    assert ("tam570.integrate.adaptive_loop", "State") in taken("tam570.integrate.adaptive")
    assert ("tam570_grader.protocol.wire", "portable") in taken("tam570_grader.protocol.answer")
    assert "rhs" not in exported("tam570.integrate.adaptive_loop") and exported("tam570") is None


@pytest.mark.parametrize("module", sorted(MODULES))
def test_names_that_other_modules_take_are_exported(module):
    private = [(source, name) for source, name in taken(module) if name not in (exported(source) or {name})]
    assert not private


@pytest.mark.parametrize("module", SHARED)
def test_public_functions_have_a_docstring(module):
    assert not [one.name for one in functions(module) if not ast.get_docstring(one)]
