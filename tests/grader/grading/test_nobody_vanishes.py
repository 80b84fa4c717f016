"""Each file that a student hands in, under any name, gets a row, or a warning that names the file and the remedy."""

import shutil
import sys
import unicodedata

import pytest
from classes import HW08, hand_in, packed
from parameters import first

from tam570_grader.grading.roster import Directory, people, students
from tam570_grader.grading.skipped_files import not_handed_in, skipped_files
from tam570_grader.grading.submissions import submissions
from tam570_grader.results.collected import COLUMNS, TABLE
from tam570_grader.results.tables import write_table

SLUGS = ["hw07_double_pendulum", HW08]
GRADED = f"ada/{HW08}/{HW08}.py ben/{HW08}/solution.py cho/HW8.py dan/axis_angle.py eve/homework8/hw08_final.py".split()
GRADED += ["fay/Axis_Angle-2.ipynb", "hal/hw08_axis_angle.py.txt", "ivy/HW08.PY"]
LOST = ["ida/work.py", "ida/hw080.py", "ida/final.zip", "ida/mine/a.py", "lone.zip", "ida/notes.pdf", "ada/scratch.py"]
OTHER = "hw03_angular_momentum_rate"
WRONG, STUB = "\n\ndef skew(v):\n    return v\n", "def skew(v):\r\n    raise NotImplementedError\r\n"
ODD = ["hw7", "HW08", "homework 3", "juan@pol.una.py", "hw07_double_pendulum", "notes.ipynb", "jos\u0065\u0301"]


@pytest.fixture
def class_of(tmp_path):
    """`class_of(files)` -> a tree with these files in it."""
    return lambda files: hand_in(tmp_path / "submitted", dict.fromkeys(files, "def skew(v): return None\n"), file="")


def test_files_are_known_by_number_by_title_and_alone(class_of):
    actual = {item.student: item for item in submissions([class_of(GRADED)], SLUGS)}
    assert sorted(actual) == sorted(name.split("/")[0] for name in GRADED)
    assert all(item.path and item.slug == HW08 for item in actual.values())


def test_what_cannot_be_told_is_one_row_that_says_why_and_holds_up_nobody(class_of, run):
    odd = {"dan": ("hw08.rar", "hw08.txt"), "gus": ("hw08.rar",), "joe": ("hw08.txt",)}
    files = [f"{student}/{name}" for student, names in odd.items() for name in names]
    _, lines, _ = run(class_of([GRADED[0], *files]), "--seed", "1", "--jobs", "1")
    said = {line["student"]: line.get("message", "") for line in lines if line["student"] in odd}
    assert len(lines) == 4 and set(said) == set(odd)
    assert "unpack it" in said["gus"] and "rename it" in said["joe"]
    assert all(name in said["dan"] for name in odd["dan"])


@pytest.mark.parametrize("name", LOST)
def test_what_tells_no_assignment_is_warned_of(class_of, name):
    tree = class_of([GRADED[0], "ada/test_mine.py", "ada/notes.md", name])
    (warning,) = skipped_files([tree], submissions([tree], SLUGS), SLUGS)
    assert all(part in warning for part in name.split("/")[:2]) and "--assignment" in warning


def test_what_was_not_collected_is_warned_of_for_who_has_nothing_else(class_of):
    tree = class_of([f"ada/{HW08}/{HW08}.py"])
    rows = [(who, "", HW08, "", "", "", f"{who}.zip", why) for who in ("ada", "bob") for why in ("older", "damaged")]
    write_table(tree.parent / TABLE, [COLUMNS, *rows])
    (warning,) = skipped_files([tree], submissions([tree], SLUGS), SLUGS)
    assert warning == "bob.zip of bob is not collected: damaged"


def test_who_may_have_handed_in_what_was_not_placed_gets_no_zero(class_of):
    tree = class_of([f"ada/{HW08}/{HW08}.py", f"99/{HW08}/{HW08}.py"])
    rows = [("bob", "Bo B", HW08, "", "", "", "x.zip", "damaged"), ("99", "Cy C", HW08, "hw08.py", "", "", "y.py", "")]
    write_table(tree.parent / TABLE, [COLUMNS, *rows])
    roster = tree.parent / "roster.csv"
    roster.write_text("login,name\nada,Ada A\nbob,Bo B\ncho,Cy C\ndan,Da D\n")
    assert [item.student for item in not_handed_in(roster, submissions([tree], SLUGS), [tree])] == ["dan"]


def test_of_many_stray_files_of_a_student_ten_are_named(class_of):
    tree = class_of([GRADED[0], *(f"ada/x{k}.py" for k in range(30))])
    *named, rest = skipped_files([tree], submissions([tree], SLUGS), SLUGS)
    assert len(named) == 10 and rest.startswith("20 more in submitted/ada")


def test_a_folder_called_like_a_module_and_a_hidden_student_are_told(class_of):
    tree = class_of([GRADED[0], f"ben/{HW08}/{HW08}.py/x", f".cho/{HW08}/{HW08}.py", ".git/hw08.py"])
    work = submissions([tree], SLUGS)
    reasons = [item.reason for item in work if item.student == "ben"]
    assert len(reasons) == 1 and f"it holds {HW08}.py (a folder)" in reasons[0]
    (warning,) = skipped_files([tree], work, SLUGS)
    assert warning == "submitted/.cho is not graded: its name begins with .; rename it"


@pytest.mark.skipif(sys.platform == "darwin", reason="there, both names are one folder")
@pytest.mark.parametrize("second", ["def skew(v): return v\n", STUB])
def test_two_folders_whose_names_look_alike_are_two_rows_and_hold_up_nobody(class_of, second):
    tree = class_of([GRADED[0], f"jos\u00e9/{HW08}/{HW08}.py"])
    hand_in(tree, {"jose\u0301": second})
    work = submissions([tree], SLUGS)
    names = [item.student for item in work if item.path]
    assert len(names) == len(set(names)) == 3 and sum(name.startswith("jos\u00e9-") for name in names) == 2
    (warning,) = skipped_files([tree], work, SLUGS)
    assert "2 folders in" in warning and "rename" in warning


def test_of_two_modules_the_written_one_counts_and_the_other_is_warned_of(class_of):
    tree = class_of([f"ada/{HW08}/{HW08}.py", f"ada/{HW08}/hw08 (1).py"])
    stub = tree / "ada" / HW08 / f"{HW08}.py"
    stub.write_text("def skew(v): return v\n")

    def chosen():
        work = submissions([tree], SLUGS)
        return work[0].path.name, *(warning.split(" is not")[0] for warning in skipped_files([tree], work, SLUGS))

    assert chosen() == (f"{HW08}.py", "hw08 (1).py of ada")
    stub.write_text("def skew(v):\n    raise NotImplementedError\n")
    assert chosen() == ("hw08 (1).py",)


@pytest.mark.parametrize(
    ("files", "others"),
    [
        ({"hw08.py": WRONG, "hw08 (1).py": ""}, ["hw08.py"]),
        ({"hw08.py": "", "hw08 (1).py": ""}, []),
        ({"hw08.py": "", "hw08_old.py": WRONG}, ["hw08_old.py"]),
        ({"hw08.py": "", "hw08 (1).py": None}, []),
        ({f"{HW08}/hw08-{n}.py": WRONG * (3 - n) for n in (1, 2, 3)}, ["hw08-2.py", "hw08-1.py"]),
        ({f"{HW08}/{HW08}.py": WRONG, f"{HW08}/{HW08} (1).py": ""}, [f"{HW08}.py"]),
        ({f"{HW08}/{HW08}.py": "", f"{HW08}/{HW08}_1.py": WRONG, f"{HW08}/hw08 (2).py": WRONG}, [f"{HW08}_1.py"]),
        ({"hw08/hw08.py": WRONG, "hw08 (1)/hw08.py": ""}, ["hw08/hw08.py"]),
        ({"hw08.zip": {"hw08.py": WRONG}, "hw08 (1).zip": {"hw08.py": ""}}, ["hw08.zip"]),
        ({"hw08.zip": {f"a/{HW08}.py": "", "a/hw08-2.py": WRONG}}, ["hw08.zip/a/hw08-2.py"]),
        ({"hw08.zip": {"hw08.py": "", "old/hw08.py": WRONG}}, ["hw08.zip/old/hw08.py"]),
        ({"hw08.zip": {"a\\hw08.py": "", "a\\._hw08.py": WRONG, "a\\.git\\hw08.py": WRONG}}, []),
        ({"hw08.py. ": ""}, []),
        ({f"{HW08}/{HW08}.py": None, f"{HW08}/work.py": ""}, []),
    ],
)
def test_of_equal_files_the_newest_counts_and_row_and_page_name_the_others(tmp_path, run, solution_text, files, others):
    """Each text follows the solution; None is the stub."""

    def content(end):
        return packed({name: content(more) for name, more in end.items()}) if isinstance(end, dict) else f"{text}{end}"

    text = solution_text(HW08)
    for name, end in files.items():
        hand_in(tmp_path / "submitted", {"ada": STUB if end is None else content(end)}, file=name)
    code, [line], _ = run(tmp_path / "submitted", "--seed", 1, "--out", tmp_path / "out")
    assert (code, line["score"], "message" in line) == (0, 10.0, bool(others))
    page = (tmp_path / "out" / "feedback" / "ada" / f"{HW08}.html").read_text()
    assert all(name in line["message"] and name in page for name in others)


@pytest.mark.parametrize(
    ("idle", "written"),
    [
        (f"ada/{HW08}/{HW08}.py", f"ada/{HW08}/{HW08}_handin.zip"),
        (f"ada/{HW08}/{HW08}.py", f"ada/{HW08}.zip"),
        (f"ada/{HW08}.py", f"ada/{HW08}/work.py"),
        ("hw08_ada.py", "hw08_ada.ipynb"),
        ("hw08_ada.py", "hw08_ada.zip"),
        (f"{HW08}.py", f"{HW08}_handin.zip"),
    ],
)
def test_work_counts_before_a_file_that_is_not_begun(tmp_path, idle, written):
    for name, text in ((idle, "import hw08"), (written, "def skew(v): return v\n")):
        path = tmp_path / "submitted" / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(packed({f"{HW08}.py": text}) if name.endswith("zip") else text.encode())
    (submission,) = submissions([tmp_path / "submitted"], SLUGS)
    assert submission.path == tmp_path / "submitted" / written


def test_a_named_assignment_takes_lone_files_and_leaves_those_of_others(class_of):
    tree = class_of(["ada/work.py", "ben/hw07.py", "cho/hw08.py"])
    actual = submissions([tree], SLUGS, HW08)
    assert {item.student for item in actual} == {"ada", "cho"} and all(item.path for item in actual)
    assert [item.slug for item in submissions([tree / "ada" / "work.py"], SLUGS, HW08)] == [HW08]


@pytest.mark.parametrize("login", first(2, ["zoe", "../../up", "\x1b[2J", "a\0b", "z" * 300]))
def test_the_roster_gives_everyone_a_row_and_no_login_leads_out_of_the_results(class_of, run, tmp_path, login):
    (tmp_path / "roster.csv").write_text(f"ada\n{login}\n")
    where = ["--seed", "1", "--roster", tmp_path / "roster.csv", "--out", tmp_path / "results"]
    code, lines, _ = run(class_of(["ada/hw08.py"]), *where)
    (name,) = {line["student"] for line in lines if line["status"] == "missing"}
    assert code == 0 and name.isprintable() and not (tmp_path / "up").exists() and (name == login) == (login == "zoe")
    assert {path.name for path in (tmp_path / "results" / "feedback").iterdir()} == {"ada", name}


@pytest.mark.parametrize("file", first(1, ["hw08.PY", "{0}/{0}.py", "{0}.py", "hw08/hw08.py.txt"]))
def test_an_odd_login_among_others(run, tmp_path, solution_text, scores, file):
    tree = hand_in(tmp_path / "submitted", dict.fromkeys(["ann", *ODD], solution_text(HW08)), file=file)
    code, lines, _ = run(tree, "--seed", 1, "--jobs", 1)
    assert code == 0 and scores(lines) == {unicodedata.normalize("NFC", item): 10.0 for item in ("ann", *ODD)}
    assert {line["assignment"] for line in lines} == {HW08}


@pytest.mark.parametrize("login", first(1, ODD))
def test_an_odd_login_alone_and_with_a_roster(run, tmp_path, solution_text, login):
    tree = hand_in(tmp_path / "submitted", {login: solution_text(HW08)}, file="{0}.py")
    (tmp_path / "roster.csv").write_text(f"Username,Name\n{login},A B\nann,Ann Lee\n")
    for path in (tree, tree / login):
        code, lines, _ = run(path, "--roster", tmp_path / "roster.csv", "--seed", 1)
        rows = {(line["student"], line["assignment"], line["score"]) for line in lines}
        assert code == 0 and rows == {(unicodedata.normalize("NFC", login), HW08, 10.0), ("ann", HW08, 0.0)}


def test_the_assignments_of_one_student_are_no_students(run, tmp_path, solution_text):
    for slug in (HW08, OTHER):
        tree = hand_in(tmp_path / "submitted", {"ann": solution_text(slug)}, slug)
    shutil.copytree(tree / "ann" / HW08, tree / "ann" / "old")
    _, lines, _ = run(tree / "ann", "--seed", 1)
    assert {("ann", HW08), ("ann", OTHER)} <= {(line["student"], line["assignment"]) for line in lines}


ROSTERS = {  # system: (heading, format of a student's row)
    "moodle": ('"First name",Surname,Username,"ID number"', "{first},{last},{login},A1"),
    "worksheet of moodle": ("Identifier;Full name;Email address;Status", '"Participant 1";"{first} {last}";{login};'),
    "gradescope": ("First Name,Last Name,SID,Email,Role", "{first},{last},{login},{first}@x.edu,Student"),
    "nbgrader": ("id,first_name,last_name,email", "{login},{first},{last},{first}@x"),
    "logins": ("student", "{login}"),
}


@pytest.mark.parametrize("system", ROSTERS)
def test_students_are_rows_and_nobody_else_is(tmp_path, system):
    heading, row = ROSTERS[system]
    rows = [row.format(login=login, first=login[0], last=login[1:]) for login in ("aadams", "bbrown")]
    (tmp_path / "roster.csv").write_text("\n".join(["\ufeff" + heading, *rows]), encoding="utf-8")
    assert students(tmp_path / "roster.csv") == ["aadams", "bbrown"]


def test_what_two_share_tells_neither(tmp_path):
    (tmp_path / "roster.csv").write_text("Username,First name,Surname\nli1,Li,Wu\nli2,Li,Wu\n")
    actual = Directory(people(tmp_path / "roster.csv"))
    assert actual.owner([("participant", "5")], "Li Wu", must_agree=True) == ""
    assert actual.owner([("login", "li2")], "Li Wu", must_agree=True).folder == "li2"
