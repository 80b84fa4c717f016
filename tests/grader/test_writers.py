"""One writer for terminals and one for tables: what a student calls things moves no cursor and is no formula."""

import ast

import pytest

TERMINAL, TABLES = "errors.py", "results/tables.py"


def calls(path):
    for node in ast.walk(ast.parse(path.read_text())):
        if isinstance(node, ast.Call):
            yield ast.unparse(node.func)


@pytest.mark.parametrize(("name", "home"), [("print", TERMINAL), ("csv.writer", TABLES), ("csv.DictWriter", TABLES)])
def test_nothing_else_prints_or_writes_tables(course, name, home):
    package = course / "autograder" / "tam570_grader"
    found = [path for path in package.rglob("*.py") if name in calls(path)]
    found = [path.relative_to(package).as_posix() for path in found if "templates" not in path.parts]
    assert found == ([] if name == "csv.DictWriter" else [home])
