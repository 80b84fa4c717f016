"""Parts of a class on several machines, joined: the results of one machine, and nothing is graded twice."""

import json

import pytest

from tam570_grader.cli.grade import _shard_of
from tam570_grader.grading import supervisor

SLUG = "hw08_axis_angle"


@pytest.fixture
def tree(tmp_path, solution_text):
    for number in range(6):
        (tmp_path / "submitted" / f"s{number}").mkdir(parents=True)
        end = "def skew(v): return v\n" if number % 2 else ""
        (tmp_path / "submitted" / f"s{number}" / f"{SLUG}.py").write_text(f"{solution_text(SLUG)}\n{end}")
    return tmp_path / "submitted"


def same(out):
    lines = (out / "results.jsonl").read_text().splitlines()
    return [json.dumps({**json.loads(line), "seconds": 0}) for line in lines], (out / "grades.csv").read_text()


def test_parts_that_are_joined_are_the_whole_and_nothing_is_graded_twice(run, tree, tmp_path, monkeypatch):
    graded, real = [], supervisor.graded
    monkeypatch.setattr(
        supervisor, "graded", lambda name, *rest, **more: graded.append(name) or real(name, *rest, **more)
    )
    options = ["--seed", 5, "--jobs", 1]
    parts = [tmp_path / f"part{k}" for k in (1, 2)]
    for k, part in enumerate(parts, start=1):
        code, lines, _ = run(tree, "--out", part, "--shard", f"{k}/2", *options)
        assert code == 0 and {_shard_of(line["student"], 2) for line in lines} == {k}
    assert sorted(graded) == [f"s{number}" for number in range(6)]
    assert run(tree, "--out", tmp_path / "all", "--join", *parts, "--jobs", 1)[0] == 0
    assert len(graded) == 6
    assert run(tree, "--out", tmp_path / "alone", *options)[0] == 0
    assert same(tmp_path / "all") == same(tmp_path / "alone")


@pytest.mark.parametrize("part", ["0/2", "3/2", "2", "a/b"])
def test_a_part_that_cannot_be_is_refused(run, tree, part, capsys):
    with pytest.raises(SystemExit):
        run(tree, "--shard", part)
    assert "K/N" in capsys.readouterr().err
