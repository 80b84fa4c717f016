"""Regrading: whose score changes and why, other inputs for each student, and results of shards that are joined."""

import json
import shutil
from itertools import pairwise

import pytest
from classes import HW08, hand_in, outcome, results

from tam570_grader import cli
from tam570_grader.checks import assignments
from tam570_grader.cli.grade import _shard_of
from tam570_grader.grading import batch
from tam570_grader.grading.seeds import BITS, derive, new_seed, seed

OTHER = "hw03_angular_momentum_rate"
WRONG = "def skew(v): return [[0.0] * 3] * 3\n"


@pytest.fixture
def tree(tmp_path, solution_text):
    """Return a folder of two students and two assignments; ben's hw08 is wrong in one function."""
    correct = solution_text(HW08)
    hand_in(tmp_path / "submitted", dict.fromkeys(("ada", "ben"), solution_text(OTHER)), OTHER)
    return hand_in(tmp_path / "submitted", {"ada": correct, "ben": correct + WRONG})


def seeds(folder):
    return {record["seed"] for record in results(folder)}


def grade(*arguments):
    return cli.main(["grade", *map(str, arguments)])


def test_only_what_changed_is_run_again_and_told(tree, tmp_path, capsys, graded_works, solution_text):
    assert grade(tree, "--out", tmp_path / "old", "--seed", 7) == 0
    graded_works.clear()
    capsys.readouterr()
    assert grade(tree, "--against", tmp_path / "old") == 0
    assert graded_works == [] and "no score changes (4 compared)" in capsys.readouterr().out
    hand_in(tree, {"ben": solution_text(HW08)})
    assert grade(tree, "--against", tmp_path / "old", "--out", tmp_path / "new") == 0
    out = capsys.readouterr().out
    assert graded_works == [("ben", HW08)] and "1 of 4 scores change" in out and f"ben  {HW08}" in out
    assert seeds(tmp_path / "new") == {7}


def test_a_changed_check_is_named_with_whose_score_it_changes(tree, tmp_path, capsys, graded_works, course):
    copy = tmp_path / "course"
    for part in ("assignments", "solutions", "autograder/checks"):
        shutil.copytree(course / part, copy / part)
    shutil.copy(course / "pyproject.toml", copy)
    assert grade(tree, "--out", tmp_path / "old") == 0
    name = assignments.assignment(course, HW08).checks[0].name
    easy = f'@check("skew", points=1, part="a", line="anything.")\ndef {name}(student, rng):\n    pass\n'
    checks = copy / "autograder" / "checks" / HW08 / "checks.py"
    checks.write_text(checks.read_text().replace("\nASSIGNMENT = ", f"\n{easy}\n\nASSIGNMENT = "))
    graded_works.clear()
    capsys.readouterr()
    assert grade(tree, "--against", tmp_path / "old" / "results.jsonl", "--root", copy, "--json") == 0
    assert sorted(graded_works) == [("ada", HW08), ("ben", HW08)]
    lines = map(json.loads, capsys.readouterr().out.splitlines())
    changes = {(line["student"], line["assignment"]): line["change"] for line in lines}
    changed = changes.pop(("ben", HW08))
    assert set(changes.values()) == {None}
    assert changed["new"] > changed["old"] and changed["because"][0].startswith(f"{name}: failed 0/")


@pytest.mark.parametrize("what", ["isolation", "_installed"])
def test_all_is_run_again_where_something_else_runs_it(what, tree, tmp_path, graded_works, monkeypatch):
    assert grade(tree, "--out", tmp_path / "old") == 0
    graded_works.clear()
    monkeypatch.setattr(batch, what, lambda: "another")
    assert grade(tree, "--out", tmp_path / "old") == 0
    assert len(graded_works) == 4


def test_what_is_no_longer_handed_in_is_told(tree, tmp_path, capsys):
    assert grade(tree, "--out", tmp_path / "old") == 0
    shutil.rmtree(tree / "ben")
    shutil.rmtree(tree / "ada" / OTHER)
    for request, gone in (
        ([tree], [["ada", OTHER], ["ben", OTHER], ["ben", HW08]]),
        ([tree, "--only", "hw08"], [["ben", HW08]]),
        ([tree / "ada"], [["ada", OTHER]]),
        ([tree / "ada" / HW08], []),
    ):
        capsys.readouterr()
        assert grade(*request, "--against", tmp_path / "old") == 0
        reported = pairwise(capsys.readouterr().out.splitlines())
        assert sorted(line.split()[:2] for line, why in reported if why == "    no longer handed in") == gone


def test_each_student_has_a_seed_of_the_key_that_no_page_tells(tree, tmp_path, graded_works):
    key, out = tmp_path / "key", tmp_path / "out"
    assert grade(tree, "--vary", key, "--out", out) == 0
    assert key.stat().st_mode & 0o777 == 0o600 and len(seeds(out)) == 4
    assert {record["score"] for record in results(out) if record["student"] == "ada"} == {10.0}
    pages = [page.read_text() for page in (out / "feedback").rglob("*.*")]
    assert len(pages) >= 4 and not any(str(seed) in page for page in pages for seed in seeds(out))
    assert grade(tree, "--vary", key, "--out", tmp_path / "repeated", "--jobs", 1) == 0
    assert seeds(tmp_path / "repeated") == seeds(out)
    graded_works.clear()
    assert grade(tree, "--vary", key, "--out", out) == 0 and graded_works == []


def test_a_varied_run_needs_its_key_which_nobody_else_may_read(tree, tmp_path, capsys):
    key, out = tmp_path / "key", tmp_path / "out"
    key.write_text("0123456789abcdef")
    key.chmod(0o640)
    assert grade(tree, "--vary", key, "--out", out, "--only", "hw08") == 0
    assert f"chmod 600 {key}" in capsys.readouterr().err
    assert grade(tree, "--out", out) == 2 and "--vary" in capsys.readouterr().err
    key.unlink()
    assert grade(tree, "--vary", key, "--out", out) == 2 and not key.exists()


def test_a_seed_has_all_its_bits():
    seeds = {new_seed() for _ in range(100)}
    assert len(seeds) == 100 and 2 ** (BITS - 12) < max(seeds) < 2**BITS
    assert seed(None, [], None) != seed(None, [], None) and seed(570, [], None) == 570


def test_what_is_derived_depends_on_every_name_and_on_the_whole_secret():
    derived = [derive(secret, "hw07", "a") for secret in (1, 2, 1 + 2**127, b"key")]
    derived += [derive(1, "hw08", "a"), derive(1, "hw07", "b"), derive(1, "hw07a", ""), derive(1, "hw07", "a", "")]
    assert len(set(derived)) == len(derived) and max(derived) < 2**BITS
    assert derive(1, "hw07", "a") == derived[0]


def test_parts_that_are_joined_are_the_whole_and_nothing_is_graded_twice(run, solution_text, tmp_path, graded_works):
    ends = ("", "\ndef skew(v): return v\n")
    tree = hand_in(tmp_path / "submitted", {f"s{k}": solution_text(HW08) + ends[k % 2] for k in range(6)})
    options = ["--seed", 5, "--jobs", 1]
    parts = [tmp_path / f"part{k}" for k in (1, 2)]
    for k, part in enumerate(parts, start=1):
        code, lines, _ = run(tree, "--out", part, "--shard", f"{k}/2", *options)
        assert code == 0 and {_shard_of(line["student"], 2) for line in lines} == {k}
    assert sorted(graded_works) == [(f"s{k}", HW08) for k in range(6)]
    assert run(tree, "--out", tmp_path / "all", "--join", *parts, "--jobs", 1)[0] == 0
    assert len(graded_works) == 6
    assert run(tree, "--out", tmp_path / "alone", *options)[0] == 0
    assert outcome(tmp_path / "all") == outcome(tmp_path / "alone")
    with pytest.raises(SystemExit):
        run(tree, "--shard", "3/2")
