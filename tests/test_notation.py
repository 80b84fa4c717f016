"""NOTATION.md explains every parameter that a student meets, in every meaning that it has."""

import ast
import re
from functools import cache

import pytest

from tam570_grader.checks import assignments

COURSE = assignments.find()
NOTATION = (COURSE / "NOTATION.md").read_text()
ROW = re.compile(r"^\|[^|]*\|(?P<names>[^|]*`[^|]*)\|[^|]*\|(?P<meaning>[^|]*)\|$", re.MULTILINE)


def explained(notation):
    """(name, assignments that the row is for, none for all) of every name of every row."""
    for row in ROW.finditer(notation):
        for name in re.findall(r"`(\w+)`", row["names"]):
            yield name, re.findall(r"hw\d\d", row["meaning"])


@cache
def parameters(slug):
    """The parameters of the functions that students write."""
    body = ast.parse((COURSE / "solutions" / f"{slug}.py").read_text()).body
    written = next(
        ast.literal_eval(item.value)
        for item in body
        if isinstance(item, ast.Assign) and ast.unparse(item.targets[0]) == "__all__"
    )
    functions = [item for item in body if isinstance(item, ast.FunctionDef) and item.name in written]
    return {given.arg for item in functions for given in (*item.args.args, *item.args.kwonlyargs)}


def unexplained(notation, slug):
    """The parameters of an assignment that no row explains."""
    fields = {name for name, slugs in explained(notation) if not slugs or slug[:4] in slugs}
    return parameters(slug) - fields


def test_every_parameter_is_explained(slug):
    assert not unexplained(NOTATION, slug), "add a row to NOTATION.md, or the assignment to that of its meaning"


RETURNS = {"angular_momentum", "kinetic", "lagrangian", "yaw"}  # the rows that explain no parameter, by a name


@pytest.mark.parametrize("row", list(ROW.finditer(NOTATION)), ids=lambda row: row["names"].strip(" `"))
def test_a_row_that_is_left_out_is_missed(row):
    without = NOTATION.replace(row[0] + "\n", "")
    missed = any(unexplained(without, slug) for slug in assignments.slugs(COURSE))
    assert missed == (not RETURNS & set(re.findall(r"`(\w+)`", row["names"])))
