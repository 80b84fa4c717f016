"""Grading again: `--against` says whose score changes and why, `--vary` gives each student inputs of its own."""

import json
import shutil
from importlib import metadata
from itertools import pairwise

import pytest

from tam570_grader import cli
from tam570_grader.checks import assignments
from tam570_grader.grading import batch, regrade, supervisor

SLUG, OTHER = "hw08_axis_angle", "hw03_angular_momentum_rate"
WRONG = "def skew(v): return [[0.0] * 3] * 3\n"


@pytest.fixture
def graded(monkeypatch):
    """The submissions that were run, by student and assignment."""
    done, real = [], supervisor.graded

    def counted(name, source, assignment, *rest, **more):
        done.append((name, assignment.slug))
        return real(name, source, assignment, *rest, **more)

    monkeypatch.setattr(supervisor, "graded", counted)
    return done


@pytest.fixture
def tree(tmp_path, solution_text):
    """Two students, two assignments; ben's hw08 is wrong in one function."""
    for student in ("ada", "ben"):
        for slug in (SLUG, OTHER):
            folder = tmp_path / "submitted" / student / slug
            folder.mkdir(parents=True)
            spoiled = WRONG if (student, slug) == ("ben", SLUG) else ""
            (folder / f"{slug}.py").write_text(solution_text(slug) + spoiled)
    return tmp_path / "submitted"


@pytest.fixture
def other_course(tmp_path, course):
    """A copy of the course whose checks can be edited."""
    copy = tmp_path / "course"
    for part in ("assignments", "solutions", "autograder/checks"):
        shutil.copytree(course / part, copy / part)
    shutil.copy(course / "pyproject.toml", copy)
    return copy


def lines(capsys):
    return [json.loads(line) for line in capsys.readouterr().out.splitlines()]


def seeds(folder):
    return {json.loads(line)["seed"] for line in (folder / "results.jsonl").read_text().splitlines()}


def grade(*arguments):
    return cli.main(["grade", *map(str, arguments)])


# Against old results


def test_nothing_changes_and_nothing_is_run_again(tree, tmp_path, capsys, graded):
    assert grade(tree, "--out", tmp_path / "old") == 0
    graded.clear()
    assert grade(tree, "--against", tmp_path / "old") == 0
    assert graded == [] and "no score changes (4 compared)" in capsys.readouterr().out


def test_a_changed_check_is_named_with_whose_score_it_changes(tree, tmp_path, capsys, graded, course, other_course):
    assert grade(tree, "--out", tmp_path / "old") == 0
    checks = other_course / "autograder" / "checks" / SLUG / "checks.py"
    name = assignments.assignment(course, SLUG).checks[0].name
    easy = f'@check("skew", points=1, part="a", line="anything.")\ndef {name}(student, rng):\n    pass\n'
    checks.write_text(f"{checks.read_text()}\n\nfrom tam570_grader import check\n\n\n{easy}")
    graded.clear()
    capsys.readouterr()
    again = ("--against", tmp_path / "old" / "results.jsonl", "--root", other_course, "--json")
    assert grade(tree, *again) == 0
    assert sorted(graded) == [("ada", SLUG), ("ben", SLUG)]
    changes = {(line["student"], line["assignment"]): line["change"] for line in lines(capsys)}
    changed = changes.pop(("ben", SLUG))
    assert set(changes.values()) == {None}
    assert changed["new"] > changed["old"] and changed["because"][0].startswith(f"{name}: failed 0/")


@pytest.mark.parametrize("what", ["isolation", "_installed"])
def test_all_is_run_again_where_something_else_runs_it(what, tree, tmp_path, capsys, graded, monkeypatch):
    assert grade(tree, "--out", tmp_path / "old", "--jobs", 1) == 0
    graded.clear()
    monkeypatch.setattr(batch, what, lambda: "another")
    assert grade(tree, "--out", tmp_path / "old", "--jobs", 1) == 0
    assert len(graded) == 4


def test_what_is_installed_is_known_by_name_and_version():
    for library in ("numpy", "scipy", "sympy", "matplotlib", "msgpack"):
        assert any(one.startswith(f"{library}-{metadata.version(library)}.") for one in batch._installed())


def test_a_changed_submission_is_the_only_one_to_run(tree, tmp_path, capsys, graded, solution_text):
    assert grade(tree, "--out", tmp_path / "old", "--seed", 7) == 0
    (tree / "ben" / SLUG / f"{SLUG}.py").write_text(solution_text(SLUG))
    graded.clear()
    capsys.readouterr()
    assert grade(tree, "--against", tmp_path / "old", "--out", tmp_path / "new") == 0
    out = capsys.readouterr().out
    assert graded == [("ben", SLUG)] and "1 of 4 scores change" in out and f"ben  {SLUG}" in out
    assert seeds(tmp_path / "new") == {7}


@pytest.mark.parametrize(
    ("old", "new", "says"),
    [
        (None, {}, "not in the old results"),
        (
            {"checks": [{"name": "gone", "points": 1.0, "max_points": 1.0, "outcome": "passed"}]},
            {},
            "gone: passed 1/1 -> no such check",
        ),
        ({"status": "missing"}, {}, "missing -> graded"),
        ({}, {"score": None}, "none"),
    ],
)
def test_every_kind_of_change_is_told(old, new, says):
    record = {"student": "ada", "assignment": SLUG, "status": "graded", "score": 5.0, "checks": []}
    before = None if old is None else {**record, "score": 6.0, **old}
    told = regrade.table([regrade.change(before, {**record, **new})], 1)
    assert says in told and "1 of 1 scores change" in told


def gone(capsys):
    """Who is listed as gone."""
    told = capsys.readouterr().out.splitlines()
    return [line.split()[:2] for line, why in pairwise(told) if why == "    no longer handed in"]


def test_what_is_no_longer_handed_in_is_told(tree, tmp_path, capsys):
    assert grade(tree, "--out", tmp_path / "old") == 0
    against = "--against", tmp_path / "old"
    shutil.rmtree(tree / "ben")
    shutil.rmtree(tree / "ada" / OTHER)
    capsys.readouterr()
    assert grade(tree, *against) == 0
    assert sorted(gone(capsys)) == [["ada", OTHER], ["ben", OTHER], ["ben", SLUG]]
    assert grade(tree, "--only", "hw08", *against) == 0
    assert gone(capsys) == [["ben", SLUG]]
    assert grade(tree / "ada", *against) == 0
    assert gone(capsys) == [["ada", OTHER]]
    assert grade(tree / "ada" / SLUG, *against) == 0
    assert gone(capsys) == []


def test_a_score_that_is_gone_is_counted(tree, tmp_path, capsys):
    assert grade(tree, "--out", tmp_path / "old") == 0
    shutil.rmtree(tree / "ada" / SLUG)
    assert grade(tree, "--against", tmp_path / "old") == 0
    out = capsys.readouterr().out
    assert "1 of 4 scores change" in out and f"ada  {SLUG}  10 -> none" in out


@pytest.mark.parametrize("content", [None, "no result\n"])
def test_old_results_that_are_none_are_refused(tree, tmp_path, capsys, content):
    old = tmp_path / "old.jsonl"
    if content:
        old.write_text(content)
    assert grade(tree, "--against", old) == 2
    assert str(old) in capsys.readouterr().err


# Inputs of one's own


def test_each_student_has_a_seed_of_the_key(tree, tmp_path, capsys):
    key = tmp_path / "key"
    assert grade(tree, "--vary", key, "--json") == 0
    first = lines(capsys)
    assert key.stat().st_mode & 0o777 == 0o600
    assert len({line["seed"] for line in first}) == 4
    assert {line["score"] for line in first if line["student"] == "ada"} == {10.0}
    assert grade(tree, "--vary", key, "--json", "--jobs", 1) == 0
    assert [(a["student"], a["seed"], a["score"]) for a in in_order(lines(capsys))] == [
        (a["student"], a["seed"], a["score"]) for a in in_order(first)
    ]


def in_order(records):
    return sorted(records, key=lambda record: (record["student"], record["assignment"]))


def test_a_varied_run_goes_on_with_its_key_alone(tree, tmp_path, capsys, graded):
    key, out = tmp_path / "key", tmp_path / "out"
    assert grade(tree, "--vary", key, "--out", out) == 0
    graded.clear()
    assert grade(tree, "--vary", key, "--out", out) == 0
    assert graded == []
    capsys.readouterr()
    assert grade(tree, "--out", out) == 2 and "--vary" in capsys.readouterr().err
    key.unlink()
    assert grade(tree, "--vary", key, "--out", out) == 2 and not key.exists()


@pytest.mark.parametrize("how", [["--seed", 1], ["--vary", "lost"]])
def test_results_made_without_the_key_are_said_so(tree, tmp_path, capsys, monkeypatch, how):
    monkeypatch.chdir(tmp_path)
    assert grade(tree, "--out", "out", *how) == 0
    assert grade(tree, "--out", "out", "--vary", "new") == 2
    err = capsys.readouterr().err
    assert "the key that they were varied by" in err and "leave --vary away" in err


def test_a_key_needs_its_folder(tree, tmp_path, capsys):
    assert grade(tree, "--vary", tmp_path / "none" / "key") == 2
    assert "make its folder first" in capsys.readouterr().err


def test_a_key_that_others_may_read_is_warned_of(tree, tmp_path, capsys):
    key = tmp_path / "key"
    for mode, warned in ((0o600, False), (0o640, True)):
        key.write_text("0123456789abcdef")
        key.chmod(mode)
        assert grade(tree, "--vary", key, "--only", "hw08") == 0
        assert (f"chmod 600 {key}" in capsys.readouterr().err) == warned


def test_feedback_tells_no_seed(tree, tmp_path):
    out = tmp_path / "out"
    assert grade(tree, "--vary", tmp_path / "key", "--out", out) == 0
    pages = [page.read_text() for page in (out / "feedback").rglob("*.*")]
    assert len(pages) >= 4 and not any(str(seed) in page for page in pages for seed in seeds(out))


@pytest.mark.parametrize(("arguments", "says"), [(["--seed", "1"], "--seed and --vary"), ([], "is not a key")])
def test_what_is_no_key_is_refused(tree, tmp_path, capsys, arguments, says):
    key = tmp_path / "key"
    key.write_text("short")
    assert grade(tree, "--vary", key, *arguments) == 2
    assert says in capsys.readouterr().err


@pytest.mark.slow
def test_solutions_have_full_marks_for_a_thousand_students(slug, tmp_path, course, solution_text):
    from tam570_grader.grading.submissions import Submission
    from tam570_grader.sandbox.student import Source
    from tam570_grader.sandbox.zygote import ResourceLimits

    source = Source(solution_text(slug).encode())
    config = batch.RunConfig(course, [], 0, 2, ResourceLimits(), key=b"the key of the thousand students")
    everyone = [Submission(f"s{i:03}", slug, None, course) for i in range(1000)]
    class_ = (supervisor.GradeTask(course, one.student, slug, config.seed_of(one), source) for one in everyone)
    results = map(json.loads, batch.lines(config, class_, len(everyone)))
    lost = [result["student"] for result in results if result["score"] != 10]
    assert lost == []
