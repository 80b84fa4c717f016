"""What a module of the common utilities is used for elsewhere, it says in `__all__`, and says what it does."""

import ast

import pytest

from tam570_grader.writing import assignments

SHARED = assignments.find() / "shared"
MODULES = {
    ".".join(path.relative_to(SHARED).with_suffix("").parts).removesuffix(".__init__"): ast.parse(path.read_text())
    for path in SHARED.rglob("*.py")
}


def exported(module):
    """The names in `__all__`, or None."""
    for one in MODULES[module].body:
        if isinstance(one, ast.Assign) and ast.unparse(one.targets[0]) == "__all__":
            return set(ast.literal_eval(one.value))
    return None


def taken(module):
    """(module, name) of all that one module takes from others: by `from m import name`, and as m.name."""
    found, modules = set(), {}
    for one in ast.walk(MODULES[module]):
        if isinstance(one, ast.ImportFrom):
            for alias in one.names:
                whole = f"{one.module}.{alias.name}"
                if whole in MODULES:
                    modules[alias.asname or alias.name] = whole
                elif one.module in MODULES:
                    found.add((one.module, alias.name))
    for one in ast.walk(MODULES[module]):
        if isinstance(one, ast.Attribute) and isinstance(one.value, ast.Name) and one.value.id in modules:
            found.add((modules[one.value.id], one.attr))
    return found


def functions(module):
    found = [one for one in MODULES[module].body if isinstance(one, ast.FunctionDef) and not one.name.startswith("_")]
    return [one for one in found if "overload" not in map(ast.unparse, one.decorator_list)]


def test_what_is_taken_is_told_from_what_is_exported():
    assert ("tam570.integrate.adaptive_loop", "let_pass") in taken("tam570.integrate.ensemble")
    assert ("tam570.integrate.adaptive_loop", "State") in taken("tam570.integrate.adaptive")
    assert "rhs" not in exported("tam570.integrate.adaptive_loop") and exported("tam570") is None


@pytest.mark.parametrize("module", sorted(MODULES))
def test_names_that_other_modules_take_are_exported(module):
    private = [(source, name) for source, name in taken(module) if name not in (exported(source) or {name})]
    assert not private


@pytest.mark.parametrize("module", sorted(MODULES))
def test_public_functions_have_a_docstring(module):
    assert not [one.name for one in functions(module) if not ast.get_docstring(one)]
