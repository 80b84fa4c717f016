"""Downloads as they are: how Canvas, Moodle and Gradescope name submissions, and hostile zip files."""

import csv
import errno
import io
import json
import os
import re
import stat
import tracemalloc
import zipfile

import pytest

from tam570.notebooks import LARGEST
from tam570_grader import cli

SLUG = "hw08_axis_angle"
ROSTER = """Student,ID,SIS User ID,SIS Login ID,Section
"Adams, Ann",17,A1,aadams,570
"Brown, Bo",18,A2,bbrown,570
"Chen, Cy",19,A3,cchen,570
"""
PARTICIPANTS = """"First name",Surname,Username,Identifier
Ann,Adams,aadams,"Participant 17"
Bo,Brown,bbrown,"Participant 18"
Cy,Chen,cchen,"Participant 19"
"""
METADATA = """submission_1:
  :submitters:
  - :name: &1 Ann Adams
    :nickname: *1
    :sid: 'A1'
    :email: ann@x.edu
  - :name: Bo Brown
    :sid: A2
  :created_at: 2026-02-03 10:00:00 -0600
submission_2:
  :submitters:
  - :name: Cy Chen
    :sid: A3
  :created_at: 2026-02-03 11:00:00 -0600
"""


def packed(files):
    """The bytes of a zip file."""
    data = io.BytesIO()
    with zipfile.ZipFile(data, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, text in files.items():
            archive.writestr(name, text)
    return data.getvalue()


@pytest.fixture
def collect(course, tmp_path, capsys):
    """`collect(system, files, roster)` -> exit code, texts of the files collected, rows of the table, what was said."""

    def collect(system, files, roster=ROSTER, *options):
        (tmp_path / "roster.csv").write_text(roster)
        (tmp_path / "download.zip").write_bytes(packed(files))
        where = ["--roster", str(tmp_path / "roster.csv"), "--to", str(tmp_path / "course" / "submitted")]
        command = ["collect", str(tmp_path / "download.zip"), "--from", system, *where, *options]
        code = cli.main(["--root", str(course), *command])
        out, err = capsys.readouterr()
        folder = tmp_path / "course" / "submitted"
        found = {p.relative_to(folder).as_posix(): p.read_text() for p in sorted(folder.rglob("*")) if p.is_file()}
        with open(tmp_path / "course" / "collected.csv", newline="") as file:
            return code, found, list(csv.DictReader(file)), out + err

    return collect


def module(student):
    return f"{student}/{SLUG}/{SLUG}.py"


def test_canvas_the_newest_late_and_by_login(collect):
    files = {
        "adamsann_17_500_hw08_axis_angle.py": "old",
        "adamsann_17_600_hw08_axis_angle-2.py": "new",
        "brownbo_LATE_18_550_axis_angle.py": "late",
        "chency_19_560_hw08.zip": packed({"mine/hw08.py": "packed", "__MACOSX/._hw08.py": "no"}),
    }
    code, found, rows, said = collect("canvas", files)
    assert code == 0 and found == {module("aadams"): "new", module("bbrown"): "late", module("cchen"): "packed"}
    told = {(row["student"], row["late"], row["note"]) for row in rows}
    assert told == {("aadams", "", "older"), ("aadams", "", ""), ("bbrown", "LATE", ""), ("cchen", "", "")}
    assert "3 students, 1 late" in said


@pytest.mark.parametrize("form", ["{0}_{1}_assignsubmission_file_/hw08.py", "{0}_{1}_assignsubmission_file_hw08.py"])
def test_moodle_in_folders_and_flat(collect, form):
    files = {form.format("Ann Adams", 17): "a", form.format("Bo Brown", 18): "b"}
    code, found, _, said = collect("moodle", files, PARTICIPANTS)
    assert code == 0 and found == {module("aadams"): "a", module("bbrown"): "b"}
    assert "late" not in said  # Moodle does not tell
    assert "1 on the roster handed in nothing: cchen" in said


def test_gradescope_by_its_metadata_groups_too(collect):
    files = {
        "export/submission_metadata.yml": METADATA,
        "export/submission_1/work.py": "ab",
        "export/submission_2/hw08.py": "c",
    }
    code, found, rows, _ = collect("gradescope", files, ROSTER, "--assignment", "hw08")
    assert code == 0 and found == {module("aadams"): "ab", module("bbrown"): "ab", module("cchen"): "c"}
    assert rows[0]["when"].startswith("2026-02-03")


@pytest.mark.parametrize(
    ("name", "data", "says"),
    [
        ("chency_19_9_work.py", "x", "--assignment"),
        ("chency_19_9_hw08.docx", "x", "neither a module"),
        ("chency_19_text.html", "x", "of cchen is not collected: neither a module"),
        ("chency_LATE_19_link.html", "x", "of cchen is not collected: neither a module"),
        ("what is this.py", "x", "is not named as canvas names submissions"),
        ("drop_77_9_hw08.py", "x", "77 (drop) is on no row of the roster"),
        ("chency_19_9_hw08.py", "x" * (LARGEST + 1), "larger than 10 MiB"),
        ("chency_19_9_hw08.zip", b"no zip", "cannot be unpacked"),
        ("chency_19_9_hw08.zip", packed({"../../hw08.py": "x"}), "leads out"),
    ],
)
def test_what_cannot_be_placed_is_named_and_the_code_is_1(collect, name, data, says):
    code, found, _, said = collect("canvas", {"adamsann_17_5_hw08.py": "a", name: data})
    assert code == 1 and says in said and found[module("aadams")] == "a"
    assert not any("cchen" in path for path in found)


def spoilt(method=zipfile.ZIP_DEFLATED, central=None, stream=None):
    """A zip file of hw08.py with bytes of its directory's entry, or of the packed stream, replaced at an offset."""
    data = io.BytesIO()
    with zipfile.ZipFile(data, "w", method) as archive:
        archive.writestr("hw08.py", "x = 1\n" * 100)
    text = bytearray(data.getvalue())
    for start, change in ((text.index(b"PK\1\2"), central), (30 + len("hw08.py"), stream)):
        if change:
            offset, new = change
            text[start + offset : start + offset + len(new)] = new
    return bytes(text)


@pytest.mark.parametrize(
    "data",
    [
        spoilt(stream=(0, b"\xff" * 8)),
        spoilt(zipfile.ZIP_LZMA, stream=(4, b"\xff" * 9)),
        spoilt(zipfile.ZIP_BZIP2),
        spoilt(central=(6, b"\x63\0")),
        spoilt(central=(8, b"\0\x08")).replace(b"hw08.py", b"\xffw08.py"),
        spoilt(central=(42, b"\xf0\xff\xff\x7f")),
        spoilt(central=(24, b"\x05\0\0\0")),
    ],
    ids=["deflate", "lzma", "bzip2", "version", "name", "offset", "size"],
)
def test_a_malformed_zip_file_is_named_and_the_rest_is_collected(collect, data):
    code, found, _, said = collect("canvas", {"adamsann_17_5_hw08.py": "a", "chency_19_9_hw08.zip": data})
    assert code == 1 and found == {module("aadams"): "a"}
    assert re.search(r"warning: chency_19_9_hw08.zip(/.w08.py)? of cchen is not collected: it cannot be unpacked", said)
    assert "handed in nothing: bbrown" in said, "it is not true of cchen"


def test_a_date_that_does_not_exist_is_no_date(collect):
    code, found, _, _ = collect("canvas", {"chency_19_9_hw08.zip": spoilt(central=(14, b"\xe1\x29"))})
    assert code == 0 and list(found) == [module("cchen")]


@pytest.mark.parametrize(("name", "says"), [("hw08_{}.py", "more than 20 MiB"), ("{}.dat", "neither a module")])
def test_a_zip_file_that_unpacks_to_much_takes_no_memory(collect, name, says):
    bomb = packed({name.format(k): bytes(LARGEST) for k in range(10)})
    tracemalloc.start()
    code, found, _, said = collect("canvas", {"adamsann_17_5_hw08.py": "a", "chency_19_9_hw08.zip": bomb})
    most = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert code == 1 and list(found) == [module("aadams")] and says in said
    assert most < 3 * LARGEST


def test_a_name_in_a_zip_file_moves_no_cursor(collect):
    _, _, _, said = collect("canvas", {"chency_19_9_hw08.zip": packed({"\x1b[2Jwork.py": "x"})})
    assert r"\x1b[2Jwork.py" in said and all(line.isprintable() for line in said.splitlines())


def test_a_disk_that_is_full_cuts_no_module_short(collect, course, tmp_path, monkeypatch):
    def full(file):
        raise OSError(errno.ENOSPC, "No space left on device")

    collect("canvas", {"adamsann_17_5_hw08.py": "first"})
    (tmp_path / "download.zip").write_bytes(packed({"adamsann_17_6_hw08.py": "second"}))
    monkeypatch.setattr(os, "fsync", full)
    where = ["--roster", str(tmp_path / "roster.csv"), "--to", str(tmp_path / "course" / "submitted")]
    assert cli.main(["--root", str(course), "collect", str(tmp_path / "download.zip"), "--from", "canvas", *where]) == 2
    files = [path for path in (tmp_path / "course" / "submitted").rglob("*") if path.is_file()]
    assert [path.read_text() for path in files] == ["first"]


# What a student names a file is nobody's name


@pytest.mark.parametrize(
    ("system", "path", "student"),
    [
        ("moodle", "Ann Adams_17_assignsubmission_file_Bo Brown_18_assignsubmission_file_hw08.py", "aadams"),
        ("moodle", "Ann Adams_17_assignsubmission_file_/Bo Brown_18_assignsubmission_file_hw08.py", "aadams"),
        ("moodle", "all/Ann Adams_17_assignsubmission_file/Bo Brown_18_assignsubmission_file_/hw08.py", "aadams"),
        ("canvas", "adamsann_17_500_brownbo_18_600_hw08.py", "aadams"),
        ("canvas", "submissions_2026_09_14/adamsann_17_500_hw08.py", "aadams"),
    ],
)
def test_the_first_name_is_the_students(collect, system, path, student):
    roster = PARTICIPANTS if system == "moodle" else ROSTER
    code, found, _, said = collect(system, {path: "mine"}, roster, "--assignment", "hw08")
    assert code == 0, said
    assert found == {module(student): "mine"}


def test_who_takes_the_name_of_another_takes_nothing_else(collect):
    """A roster without numbers joins by name."""
    files = {f"Bo Brown_{n}_assignsubmission_file_/hw08.py": f"of {n}" for n in (17, 18)}
    files["Cy Chen_19_assignsubmission_file_/hw08.py"] = "c"
    code, found, rows, said = collect("moodle", files, "First name,Surname,Username\nBo,Brown,bbrown\nCy,Chen,cchen\n")
    assert code == 1 and found == {module("cchen"): "c"}
    assert said.count("of bbrown is not collected: another in the download goes to the same student") == 2
    assert "handed in nothing" not in said


HW08 = "--assignment", "hw08"


@pytest.mark.parametrize("around", ["", "submissions_2026_09_14/"])
@pytest.mark.parametrize("name", ["hw08", "2026"])
def test_what_was_unpacked_is_still_its_students(collect, around, name):
    """A zip file that the instructor has unpacked is a folder."""
    unpacked = f"{around}adamsann_17_500_{name}/brownbo_18_600_hw08.py"
    code, found, _, _ = collect("canvas", {unpacked: "a", f"{around}chency_19_501_hw08.py": "c"}, ROSTER, *HW08)
    assert code == 0 and found == {module("aadams"): "a", module("cchen"): "c"}


OF_BO = """submission_1:
  :submitters:
  - :name: Bo Brown
    :sid: A2
"""


def test_a_table_that_a_student_hands_in_is_not_the_classs(collect):
    files = {
        "export/submission_1/submission_metadata.yml": OF_BO,
        "export/submission_1/submission_2/hw08.py": "of Ann and Bo",
        "export/submission_metadata.yml": METADATA,
        "export/submission_2/hw08.py": "of Cy",
    }
    code, found, _, said = collect("gradescope", files)
    assert found == {module("aadams"): "of Ann and Bo", module("bbrown"): "of Ann and Bo", module("cchen"): "of Cy"}
    assert code == 1 and "submission_1/submission_metadata.yml of aadams is not collected" in said


NOT_TABLES = {
    "in a submission": (METADATA, "holds no submission_metadata.yml beside its submissions"),
    "aliases": ("a: &a [x, x]\nb: &b [*a, *a]\nsubmission_1:\n  :submitters: *b\n", "it has aliases"),
    "deep": ("[" * 100_000, "too deep"),
    "no table": ("- submission_1\n", "lists no submissions"),
    "a submission is text": ("submission_1: Ann\n", "submission_1: this is not what Gradescope writes"),
    "submitters are text": ("submission_1:\n  :submitters: Ann\n", "submission_1: this is not what"),
    "a submitter is text": ("submission_1:\n  :submitters: [Ann]\n", "submission_1: a submitter has neither"),
    "an id is a list": ("submission_1:\n  :submitters:\n  - :sid: [A1]\n", "submission_1: a submitter has neither"),
    "a time is a list": ("submission_1:\n  :created_at: [now]\n", "submission_1: this is not what"),
    "no YAML": ("submission_1: [\n", "while parsing a flow node expected the node content"),
    "no text": (b"\xff\xfe\x00", "cannot be read"),
    "large": (b"#" * (LARGEST + 1), "larger than 10 MiB"),
}


@pytest.mark.parametrize("what", NOT_TABLES)
def test_a_table_that_gradescope_did_not_write_is_refused(course, tmp_path, capsys, what):
    text, says = NOT_TABLES[what]
    place = "export/submission_1/" if what == "in a submission" else "export/"
    files = {f"{place}submission_metadata.yml": text, "export/submission_1/hw08.py": "x"}
    (tmp_path / "a.zip").write_bytes(packed(files))
    command = ["collect", str(tmp_path / "a.zip"), "--from", "gradescope", "--to", str(tmp_path / "submitted")]
    assert cli.main(["--root", str(course), *command]) == 2
    _, line = capsys.readouterr().err.splitlines()
    assert says in line and "submission_metadata.yml" in line and "Gradescope" in line
    assert not (tmp_path / "submitted").exists()


def test_a_submission_of_nobody_is_named(collect):
    table = METADATA + "submission_3:\n  :created_at: 2026-02-03 10:00:00 -0600\n"
    files = {"submission_metadata.yml": table, "submission_1/hw08.py": "x", "submission_3/hw08.py": "y"}
    code, _, _, said = collect("gradescope", files)
    assert code == 1 and "submission_3/hw08.py is nobody's by submission_metadata.yml" in said


# Names with anything in them


def test_names_that_are_no_text_are_told_as_text_and_kept_whole(course, tmp_path, capsysbinary):
    clear, bytes_ = "\x1b[2J", os.fsdecode(b"\xe9")  # what clears the screen, and a letter in Latin-1
    path = f"Ann{clear} {bytes_}_17_assignsubmission_file_/{clear}work{bytes_}.py"
    (tmp_path / "down" / path).parent.mkdir(parents=True)
    (tmp_path / "down" / path).write_text("x")
    (tmp_path / "down" / f"stray{clear}{bytes_}").write_text("x")
    command = ["collect", str(tmp_path / "down"), "--from", "moodle", "--to", str(tmp_path / "submitted")]
    for _ in range(2):  # the second reads what the first wrote
        assert cli.main(["--root", str(course), *command]) == 1
        out, err = capsysbinary.readouterr()
        assert b"\x1b" not in out + err and err.count(rb"\x1b[2J") >= 2
    assert os.fsencode(path) in (tmp_path / "collected.csv").read_bytes()


@pytest.mark.parametrize(
    "login", ["../../up", "a\0b", "\x1b[2J", "x" * 300, "__main", ".ssh", "-rf", "*", "a/b", "o'brien"]
)
def test_a_login_is_one_folder_and_the_same_student_on_the_roster(collect, course, tmp_path, capsys, login):
    roster = f'Student,ID,SIS Login ID,Section\n"Adams, Ann",17,"{login}",570\n'
    _, found, _, _ = collect("canvas", {"adamsann_17_5_hw08.py": "def skew(v): return v"}, roster)
    (path,) = found
    name = path.split("/")[0]
    assert not (tmp_path / "up").exists() and len(name.encode()) <= 255 and name.isprintable()
    assert (name == login) == (login == "o'brien")
    where = ["--roster", str(tmp_path / "roster.csv"), "--seed", "1", "--json"]
    assert cli.main(["--root", str(course), "grade", str(tmp_path / "course" / "submitted"), *where]) == 0
    (line,) = capsys.readouterr().out.splitlines()
    assert json.loads(line)["student"] == name


def test_two_logins_are_two_folders(collect):
    roster = 'Student,ID,SIS Login ID,Section\n"Adams, Ann",17,a/b,570\n"Brown, Bo",18,a:b,570\n'
    _, found, _, _ = collect("canvas", {"adamsann_17_5_hw08.py": "a", "brownbo_18_6_hw08.py": "b"}, roster)
    assert sorted(found.values()) == ["a", "b"]


def test_a_link_in_a_zip_file_is_refused(collect):
    link = zipfile.ZipInfo("chency_19_9_hw08.py")
    link.create_system, link.external_attr = 3, (stat.S_IFLNK | 0o777) << 16
    code, found, _, said = collect("canvas", {"adamsann_17_5_hw08.py": "a", link: "/etc/passwd"})
    assert code == 1 and "it is a link" in said and list(found) == [module("aadams")]


def test_no_id_leads_out_of_the_folder(collect, tmp_path):
    roster = 'Student,ID,SIS Login ID,Section\n"Adams, Ann",17,../../up,570\n'
    _, found, _, _ = collect("canvas", {"adamsann_17_5_hw08.py": "a"}, roster)
    assert len(found) == 1 and not (tmp_path / "up").exists()


def test_a_download_of_another_system_is_said(course, tmp_path, capsys):
    (tmp_path / "a.zip").write_bytes(packed({"hw08.py": "x"}))
    for system, says in (("canvas", "is --from right?"), ("gradescope", "submission_metadata.yml")):
        assert cli.main(["--root", str(course), "collect", str(tmp_path / "a.zip"), "--from", system]) == 2
        assert says in capsys.readouterr().err


def test_a_long_table_is_read_without_its_outputs(collect):
    """Gradescope writes every output into it; none of that is held as a tree."""
    long = "  :results:\n    output: '" + "x" * 100 + "'\n"
    table = "".join(
        line if not line.startswith("  :created_at") else line + long * 80_000 for line in METADATA.splitlines(True)
    )
    assert len(table) > LARGEST
    files = {"submission_metadata.yml": table, "submission_1/hw08.py": "ab", "submission_2/hw08.py": "c"}
    code, found, _, said = collect("gradescope", files)
    assert (code, found) == (0, {module("aadams"): "ab", module("bbrown"): "ab", module("cchen"): "c"}), said
