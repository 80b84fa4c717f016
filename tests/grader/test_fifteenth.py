"""A fifteenth assignment, hw08 under another name, is added to a copy of the course and graded."""

import json
import shutil

from classes import hand_in

from tam570_grader import cli
from tam570_grader.checks import assignments
from tam570_grader.diagnosis.mistakes import mistakes

MODEL, SLUG = "hw08_axis_angle", "hw15_turning"
PARTS = ("solutions/{}.py", "assignments/{}", "autograder/checks/{}", "shared/tam570/show/scenes/{:.4}.py")


def renamed(text):
    return text.replace(MODEL, SLUG).replace(MODEL[:4], SLUG[:4])


def test_it_is_found_graded_audited_and_released(course, tmp_path, capsys):
    """The commands work with a copy of hw08's files in which the slug is replaced in file names and texts."""
    copy = tmp_path / "fifteen"
    for part in ("assignments", "solutions", "autograder", "shared"):
        shutil.copytree(course / part, copy / part, ignore=shutil.ignore_patterns("__pycache__"))
    shutil.copy(course / "pyproject.toml", copy)
    for part in PARTS:
        old = copy / part.format(MODEL)
        for path in [old] if old.is_file() else [path for path in old.rglob("*") if path.is_file()]:
            hand_in(copy, {"": renamed(path.read_text())}, file=renamed(path.relative_to(copy).as_posix()))
    (copy / "assignments" / SLUG / f"{SLUG}.py").unlink()
    root = ["--root", str(copy)]
    assert cli.main([*root, "stubs"]) == 0 and SLUG in assignments.slugs(copy)
    solution = (copy / "solutions" / f"{SLUG}.py").read_text()
    mistake = mistakes(copy / "autograder" / "checks" / SLUG)[0]
    hand_in(tmp_path / "submitted", {"ada": solution, "ben": f"{solution}\n\n{mistake.text}"}, SLUG)
    capsys.readouterr()
    assert cli.main([*root, "grade", str(tmp_path / "submitted"), "--json", "--jobs", "1", "--seed", "2"]) == 0
    ada, ben = sorted(map(json.loads, capsys.readouterr().out.splitlines()), key=lambda line: line["student"])
    assert ada["score"] == 10.0 and mistake.message in [check["suspect"] for check in ben["checks"]]
    assert cli.main([*root, "audit", SLUG, "--function", "skew", "--jobs", "1"]) == 0
    assert cli.main([*root, "course", str(tmp_path / "course"), SLUG]) == 0
    assert list((tmp_path / "course" / "source" / SLUG).glob("*.ipynb"))
