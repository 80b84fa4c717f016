"""Parts of a class on several machines, joined: the results of one machine, and nothing is graded twice."""

import pytest
from classes import HW08, hand_in, outcome

from tam570_grader.cli.grade import _shard_of


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
