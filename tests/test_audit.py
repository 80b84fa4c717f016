"""Mutants of the solutions, and what the audit says of them."""

import pytest

from tam570_grader import cli
from tam570_grader.mutate import mutants

SLUG = "hw08_axis_angle"


def slips(line):
    """What the mutants of a one-line function make of it."""
    return {f"{one.was} -> {one.now}" for one in mutants(SLUG, f"def f(a, b):\n    return {line}\n")}


@pytest.mark.parametrize(
    ("line", "expected"),
    [
        ("-a", {"-a -> a"}),
        ("a + b", {"a + b -> a - b", "a + b -> a", "a + b -> b", "a + b -> a + 2 * b"}),
        ("a * b", {"a * b -> a / b"}),
        ("a @ b", {"a @ b -> b @ a", "a @ b -> a.T @ b"}),
        ("a ** 2", {"a ** 2 -> a ** 3", "a ** 2 -> a ** 1", "2 -> 4"}),
        ("0.5", {"0.5 -> 1.0", "0.5 -> 0.25"}),
        ("np.sin(a)", {"np.sin(a) -> np.cos(a)"}),
        ("f(a, b)", {"f(a, b) -> f(b, a)"}),
        ("a[0]", {"a[0] -> a[1]"}),
        ("a if a < b else b", {"a if a < b else b -> a", "a if a < b else b -> b", "a < b -> a <= b"}),
        ("a.copy()", {"a.copy() -> a"}),
        ("a, b", {"(a, b) -> (b, a)"}),
    ],
)
def test_a_mutant_has_one_slip(line, expected):
    assert slips(line) == expected


def test_mutants_of_solutions_are_programs_with_names_of_their_own(slug, solution_text):
    found = mutants(slug, solution_text(slug))
    assert len(found) >= 50 and len({one.name for one in found}) == len(found)
    for one in found:
        compile(one.text, one.name, "exec")
        assert one.text != solution_text(slug)


def test_the_audit_of_an_assignment_finds_no_survivor(capsys):
    assert cli.main(["audit", "hw08"]) == 0
    out = capsys.readouterr().out
    assert "60 mutants, 57 killed, 3 equivalent, 0 survive" in out


def test_the_audit_fails_when_a_mutant_survives(capsys, monkeypatch):
    monkeypatch.setattr("tam570_grader.audit._equivalents", lambda course: {})
    assert cli.main(["audit", "hw08"]) == 1
    assert "np.dot(n, r) -> np.dot(r, n)" in capsys.readouterr().out
