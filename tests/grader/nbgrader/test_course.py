"""The students' notebook: its cells, the claims to grade by hand, and its output with the stub and the solution."""

import json
import os
import re
import socket
import sqlite3
import subprocess
import sys
from pathlib import Path
from types import SimpleNamespace

import pytest
from parameters import SLUGS, first

from tam570_grader import cli
from tam570_grader.checks import assignments
from tam570_grader.checks.rubric import load_rubric, rubric_table
from tam570_grader.release.notebook import functions_by_part, part_points, problem, visible_by_part, write_notebook
from tam570_grader.release.stubs import stub

ONE = "hw08_axis_angle"
MISSING = ("is not written", "comes from a cell above that shows nothing yet")


@pytest.fixture
def released(course, slug):
    return course / "assignments" / slug


@pytest.fixture
def cells(course, slug, tmp_path):
    """Return {id: cell} of the notebook of an assignment."""
    write_notebook(course, slug, tmp_path)
    cells = json.loads((tmp_path / f"{slug}.ipynb").read_text())["cells"]
    assert len({cell["id"] for cell in cells}) == len(cells)
    return {cell["id"]: cell for cell in cells}


def test_every_part_has_its_text_and_its_points(course, slug, released, cells):
    assignment, (_, parts, _) = assignments.assignment(course, slug), problem((released / "README.md").read_text())
    of_nbgrader = [item["metadata"]["nbgrader"] for item in cells.values() if item["metadata"]]
    graded = {item["grade_id"]: item["points"] for item in of_nbgrader}
    assert parts and {*part_points(assignment), *assignment.rubric} <= set(parts)
    assert {f"part-{part}": points for part, points in part_points(assignment).items()}.items() <= graded.items()
    assert {f"manual-{letter}": part.points for letter, part in assignment.rubric.items()}.items() <= graded.items()
    assert sum(graded.values()) == assignment.max_score + sum(part.points for part in assignment.rubric.values())


def test_every_visible_test_belongs_to_one_part_and_every_function_to_its_check(course, slug, released):
    assignment = assignments.assignment(course, slug)
    text = (released / f"test_{slug}.py").read_text()
    placed = [name for names in visible_by_part(assignment, text).values() for name in names]
    assert sorted(placed) == sorted(re.findall(r"^def (test_\w+)", text, re.MULTILINE))
    assert set(functions_by_part(assignment).values()) <= set(part_points(assignment))


@pytest.mark.parametrize("slug", first(1, SLUGS))
def test_everything_that_a_student_gets_is_no_secret(course, tmp_path, made_course, slug):
    built, _ = made_course(tmp_path, [slug])
    names = {f"{slug}.py", f"{slug}.ipynb", f"test_{slug}.py", "README.md", "figure.svg", "lab.py"}
    assert {path.name for path in (built / "source" / slug).iterdir()} == names
    solution = (course / "solutions" / f"{slug}.py").read_text()
    assert (built / "source" / slug / f"{slug}.py").read_text() == stub(solution)


def test_what_the_teacher_wrote_into_a_source_stays_and_is_named(course, tmp_path, made_course, capsys):
    source = made_course(tmp_path, [ONE])[0] / "source" / ONE
    notebook, module = source / f"{ONE}.ipynb", source / f"{ONE}.py"
    ours = module.read_text()
    notebook.write_text(notebook.read_text().replace("hw08", "hw08, in our course", 1))
    mine = notebook.read_text()
    module.unlink()
    capsys.readouterr()
    assert cli.main(["--root", str(course), "course", str(tmp_path / "course"), ONE]) == 0
    assert notebook.read_text() == mine and module.read_text() == ours
    said = capsys.readouterr().err
    assert f"{notebook} left as you have it" in said and "lab.py" not in said


@pytest.fixture
def work(course, tmp_path, made_course):
    """`work(slug, module)` -> a student's folder with this module in it."""

    def work(slug, module):
        folder = tmp_path / str(len(list(tmp_path.iterdir())))
        folder.mkdir()
        built, _ = made_course(folder, [slug])
        (built / "source" / slug / f"{slug}.py").write_text(module)
        return built / "source" / slug

    return work


def run_top_to_bottom(folder, slug):
    """Run the notebook in this folder and return its cells; fail if it has an error or a warning."""
    command = ["-m", "jupyter", "nbconvert", "--to", "notebook", "--execute", "--inplace", f"{slug}.ipynb"]
    done = subprocess.run([sys.executable, *command], cwd=folder, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr[-2000:]
    cells = json.loads((folder / f"{slug}.ipynb").read_text())["cells"]
    outputs = [item for cell in cells for item in cell.get("outputs", [])]
    assert not [item for item in outputs if item["output_type"] == "error" or item.get("name") == "stderr"]
    return cells


def said(cells):
    """Return the text that the cells printed and the text of their results."""
    outputs = [item for cell in cells for item in cell.get("outputs", [])]
    return "".join("".join(item.get("text", item.get("data", {}).get("text/plain", []))) for item in outputs)


@pytest.mark.slow
def test_every_notebook_runs_with_the_stub_and_with_the_solution(work, slug, solution_text):
    """With the stub each part says what is missing; with the solution it shows the pictures and the animation."""
    for cell in run_top_to_bottom(work(slug, stub(solution_text(slug))), slug):
        if cell["id"].startswith(("part-", "picture-", "scene")):
            assert any(word in said([cell]) for word in MISSING), cell
    cells = run_top_to_bottom(work(slug, solution_text(slug)), slug)
    assert not [word for word in ("Nothing to see", "This stopped", "\n- ") if word in said(cells)]
    for cell in cells:
        assert not cell["id"].startswith("picture-") or cell["outputs"]
    (moving,) = next(cell for cell in cells if cell["id"] == "scene")["outputs"]
    assert "<iframe" in "".join(moving["data"]["text/html"])


@pytest.mark.slow
def test_a_module_that_is_saved_is_read_again(course, work):
    import nbformat
    from nbclient import NotebookClient

    solution = (course / "solutions" / f"{ONE}.py").read_text()
    folder = work(ONE, stub(solution))
    book = nbformat.read(folder / f"{ONE}.ipynb", as_version=4)
    client = NotebookClient(book, resources={"metadata": {"path": str(folder)}})
    setup, picture = map([cell["id"] for cell in book.cells].index, ("setup", "picture-a"))
    with client.setup_kernel():
        client.execute_cell(book.cells[setup], setup)
        before = said([client.execute_cell(book.cells[picture], picture)])
        (folder / f"{ONE}.py").write_text(solution)
        after = said([client.execute_cell(book.cells[picture], picture)])
    assert "Nothing to see yet" in before and "Nothing to see yet" not in after


@pytest.fixture
def ending(monkeypatch):
    """Return the module `ending` with a short wait for locks, and remove its listeners after the test."""
    ending = pytest.importorskip("tam570_grader.nbgrader.ending")
    monkeypatch.setattr(ending, "WAIT", 0.05)
    yield ending
    for name, listener in (("connect", ending._wait), ("handle_error", ending._tell)):
        if ending.event.contains(ending.Engine, name, listener):
            ending.event.remove(ending.Engine, name, listener)


def listened(url, ending):
    """Return an engine of SQLAlchemy with the listeners that commands use."""
    from sqlalchemy import create_engine, event

    engine = create_engine(url)
    event.listen(engine, "connect", ending._wait)
    event.listen(engine, "handle_error", ending._tell)
    return engine


def test_a_locked_gradebook_is_waited_for_and_then_told_in_one_line(ending, tmp_path):
    from sqlalchemy import text

    holder = sqlite3.connect(tmp_path / "gradebook.db")
    holder.execute("BEGIN EXCLUSIVE")
    engine = listened(f"sqlite:///{tmp_path / 'gradebook.db'}", ending)
    with pytest.raises(ending.Lost, match="is locked by another command"), engine.connect() as here:
        assert here.execute(text("PRAGMA busy_timeout")).scalar() == 50
        here.execute(text("CREATE TABLE x (y INTEGER)"))
    holder.close()


def test_a_server_that_is_lost_ends_the_command_in_one_line(ending, capsys):
    """Lost is a KeyboardInterrupt, so that nbgrader removes unfinished files and does not go on to other students."""
    pytest.importorskip("psycopg", reason="no psycopg: pip install 'tam570[postgres]'")
    with socket.socket() as closed:
        closed.bind(("127.0.0.1", 0))  # bound, but not listening
        engine = listened(f"postgresql+psycopg://me:secret@127.0.0.1:{closed.getsockname()[1]}/grades", ending)
        with pytest.raises(SystemExit) as end:
            ending._ending(lambda app: engine.connect())(None)
    said = capsys.readouterr().err
    assert end.value.code == 1 and issubclass(ending.Lost, KeyboardInterrupt)
    assert len(said.splitlines()) == 1 and "does not answer" in said and "secret" not in said
    gone = SimpleNamespace(engine=engine, connection=engine, is_disconnect=True, original_exception=OSError("gone"))
    with pytest.raises(ending.Lost, match="gone"):
        ending._tell(gone)


def test_a_table_that_is_not_finished_leaves_the_last_one(ending, tmp_path, monkeypatch):
    def half(plugin, gradebook):
        Path(plugin.to).write_text("half")
        raise ending.Lost

    (tmp_path / "grades.csv").write_text("of the last time")
    monkeypatch.setattr(ending.CsvExportPlugin, "export", half)
    with pytest.raises(ending.Lost):
        ending.WholeTable(to=str(tmp_path / "grades.csv")).export(None)
    assert [path.read_text() for path in tmp_path.iterdir()] == ["of the last time"]


def test_a_pipe_in_place_of_a_notebook_is_told(tmp_path):
    bridge = pytest.importorskip("tam570_grader.nbgrader.bridge")
    os.mkfifo(tmp_path / "hw08.ipynb")
    assert "not a regular file" in bridge._students(tmp_path / "hw08.ipynb")
    (tmp_path / "large.ipynb").touch()
    os.truncate(tmp_path / "large.ipynb", bridge.LARGEST_WITH_OUTPUTS + 1)
    assert "larger" in bridge._students(tmp_path / "large.ipynb")
    (tmp_path / "notes.txt").touch()
    assert bridge._own_files(str(tmp_path), str(tmp_path)) == [str(tmp_path / "notes.txt")]


def test_every_claim_has_points_and_every_part_is_one_of_the_problem(released):
    rubric = load_rubric(released)
    assert {*rubric} <= {*problem((released / "README.md").read_text())[1]} | {"a"}
    for part in rubric.values():
        assert len({text for _, text in part.claims}) == len(part.claims) >= 2
        assert all(points > 0 for points, _ in part.claims)


def test_a_notebook_asks_for_the_prediction_above_the_picture_and_shows_the_claims(released, cells):
    order = list(cells)
    for letter, part in load_rubric(released).items():
        assert rubric_table(part) in cells[f"task-{letter}"]["source"]
        assert cells[f"manual-{letter}"]["metadata"]["nbgrader"]["points"] == part.points
        if part.before:
            assert order.index(f"guess-{letter}") < order.index(f"picture-{letter}") < order.index(f"manual-{letter}")
