"""`tam570-grader collect`: submissions as Canvas, Moodle and Gradescope name them, and hostile zip files."""

import errno
import io
import os
import stat
import tracemalloc
import zipfile

import pytest
from classes import packed
from parameters import first

from tam570.notebooks import LARGEST
from tam570_grader import cli

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
LINK = zipfile.ZipInfo("chency_19_9_hw08.py")
LINK.create_system, LINK.external_attr = 3, (stat.S_IFLNK | 0o777) << 16


def test_the_newest_counts_and_packed_ones_are_unpacked(download, desk):
    junk = dict.fromkeys(("__MACOSX/._hw08.py", "mine/._hw08.py", "mine\\.ipynb_checkpoints\\hw08.py"), "no")
    files = {
        "adamsann_17_500_hw08_axis_angle.py": "old",
        "adamsann_17_600_hw08_axis_angle-2.py": "new",
        "brownbo_LATE_18_550_axis_angle.py": "late",
        "chency_19_560_hw08.zip": packed({"in.zip": packed({"mine\\hw08.py": "packed", **junk})}),
    }
    code, said = download("canvas", files, ROSTER)
    assert code == 0 and desk.collected == {"aadams": "new", "bbrown": "late", "cchen": "packed"}
    reported = {(row[0], row[5], row[7]) for row in desk.read("collected.csv")[1:]}
    assert reported == {("aadams", "", "older"), ("aadams", "", ""), ("bbrown", "LATE", ""), ("cchen", "", "")}
    assert "3 students, 1 late" in said


@pytest.mark.parametrize(
    ("old", "new", "note"),
    [
        ("hw08.py", "hw08 (1).py", "another file counts"),
        ("hw08_old.py", "hw08.py", "another file counts"),
        ("hw08.py", "hw08.ipynb.json", ""),
        ("hw08.py", "hw08.py.", "same as the file that counts"),
    ],
)
def test_of_files_that_came_together_the_last_copy_counts(download, desk, old, new, note):
    folder, texts = "Ann Adams_17_assignsubmission_file", ("new" if note.startswith("same") else "old", "new")
    code, _ = download("moodle", {f"{folder}/{name}": text for name, text in zip((old, new), texts, strict=True)})
    rows = {row["from"].rpartition("/")[2]: row for row in desk.rows("collected.csv")}
    assert code == note.startswith("another") and rows[old]["note"].startswith(note) and rows[new]["file"]


def test_a_stub_beside_the_zip_file_of_the_work_does_not_count(download, desk):
    stub, work = "def skew(v):\n    raise NotImplementedError\n", "def skew(v):\n    return 0\n"
    files = {"adamsann_17_500_hw08.zip": packed({"hw08.py": work}), "adamsann_17_600_hw08_axis_angle.py": stub}
    assert download("canvas", files, ROSTER)[0] == 0 and desk.collected == {"aadams": work}


def test_a_note_of_blackboard_is_named_only_if_no_file_is_with_it(download, desk):
    file = "HW8_{}_attempt_2026-09-14-22-00-00{}"
    notes = {file.format(login, ".txt"): "Submission Field: x" for login in ("aadams", "bbrown")}
    code, said = download("blackboard", {**notes, file.format("aadams", "_hw08.py"): "a"}, ROSTER)
    assert code == 1 and desk.collected == {"aadams": "a"} and "handed in nothing: cchen" in said
    assert "of bbrown is not collected: the student typed this text" in said and "of aadams" not in said


@pytest.mark.parametrize("times", first(1, [1, 80_000]))
def test_gradescope_by_its_metadata_groups_too(desk, download, times):
    """Gradescope writes all outputs into the metadata; `collect` reads a large file without building a tree of it."""
    long = "  :results:\n    output: '" + "x" * 100 + "'\n"
    table = "".join(line + long * times * line.startswith("  :created_at") for line in METADATA.splitlines(True))
    works = {"submission_1/work.py": "ab", "submission_2/hw08_axis_angle.py": "c", "submission_2/hw08_b.py": "d"}
    files = {"export/submission_metadata.yml": table, **{f"export/{name}": work for name, work in works.items()}}
    code, _ = download("gradescope", files, ROSTER, "--assignment", "hw08")
    assert code == 1 and desk.collected == {"aadams": "ab", "bbrown": "ab", "cchen": "c"}
    assert (len(table) > LARGEST) == (times > 1)


def spoilt(method=zipfile.ZIP_DEFLATED, central=None, stream=None):
    """Return a zip file of hw08.py; each (offset, bytes) replaces bytes of its central directory or compressed data."""
    data = io.BytesIO()
    with zipfile.ZipFile(data, "w", method) as archive:
        archive.writestr("hw08.py", "x = 1\n" * 100)
    text = bytearray(data.getvalue())
    for start, change in ((text.index(b"PK\1\2"), central), (30 + len("hw08.py"), stream)):
        if change:
            offset, new = change
            text[start + offset : start + offset + len(new)] = new
    return bytes(text)


SPOILT = [
    spoilt(stream=(0, b"\xff" * 8)),
    spoilt(zipfile.ZIP_LZMA, stream=(4, b"\xff" * 9)),
    spoilt(zipfile.ZIP_BZIP2),
    spoilt(central=(6, b"\x63\0")),  # version needed to extract
    spoilt(central=(8, b"\0\x08")).replace(b"hw08.py", b"\xffw08.py"),
    spoilt(central=(42, b"\xf0\xff\xff\x7f")),  # offset of the local header
    spoilt(central=(24, b"\x05\0\0\0")),  # uncompressed size
]


# in zip64, a second end record gives the size of the directory, here 8 MiB
LARGE_DIRECTORY = b"PK\1\2" + bytes(8 * 2**20) + b"PK\6\6" + (44).to_bytes(8, "little") + bytes(28)
LARGE_DIRECTORY += (8 * 2**20 + 4).to_bytes(8, "little") + bytes(8)
LARGE_DIRECTORY += b"PK\6\7" + bytes(4) + (8 * 2**20 + 4).to_bytes(8, "little") + b"\1\0\0\0" + b"PK\5\6" + bytes(18)


@pytest.mark.parametrize(
    ("name", "data", "words"),
    [
        ("chency_19_9_work.py", "x", "--assignment"),
        ("chency_19_9_hw08.docx", "x", "neither a module"),
        ("chency_19_9_hw08.py", "", "it is empty"),
        ("chency_LATE_19_link.html", "x", "of cchen is not collected: neither a module"),
        ("chency_19_text.html", "<p>def skew</p>", "cchen is not collected: the student typed this text"),
        ("what is this.py", "x", "is not named as canvas names submissions"),
        ("drop_77_9_hw08.py", "x", "77 (drop) is on no row of the roster"),
        ("chency_19_9_hw08.py", "x" * (LARGEST + 1), "larger than 10 MiB"),
        *(("chency_19_9_hw08.zip", data, "it cannot be unpacked") for data in (b"no zip", *SPOILT)),
        ("chency_19_9_hw08.zip", packed({"a.zip": packed({"../hw08.py": "x"})}), "leads out"),
        ("chency_19_9_hw08.zip", packed({f"{n:06}": "" for n in range(1_001)}), "more than 1000 files"),
        ("chency_19_9_hw08.zip", LARGE_DIRECTORY, "more than 1000 files"),
        (LINK, "/etc/passwd", "it is a link"),
    ],
)
def test_what_cannot_be_placed_is_named_and_the_code_is_1(desk, download, name, data, words):
    code, said = download("canvas", {"adamsann_17_5_hw08.py": "a", name: data}, ROSTER)
    assert code == 1 and words in said and desk.collected["aadams"] == "a" and "cchen" not in desk.collected
    assert ("handed in nothing: bbrown" in said) == ("chency" in str(name)), "it is not true of cchen"


@pytest.mark.parametrize(
    ("name", "uploads", "words"),
    [("hw08_{}.py", 1, "more than 20 MiB"), ("{}.dat", 1, "neither a module"), ("{}/hw08.py", 60, "more than 20 MiB")],
)
def test_zip_files_that_unpack_to_much_take_no_memory(desk, download, name, uploads, words):
    bomb = packed({name.format(k): bytes(LARGEST) for k in range(10)})
    tracemalloc.start()
    files = {f"chency_19_{n}_hw08.zip": bomb for n in range(uploads)}
    code, said = download("canvas", {"adamsann_17_5_hw08.py": "a", **files}, ROSTER)
    most = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert code == 1 and [*desk.collected] == ["aadams"] and words in said and most < 3 * LARGEST
    assert said.count("warning") < 20


def test_a_disk_that_is_full_cuts_no_module_short(download, desk, monkeypatch):
    def full(file):
        raise OSError(errno.ENOSPC, "No space left on device")

    download("canvas", {"adamsann_17_5_hw08.py": "first"}, ROSTER)
    monkeypatch.setattr(os, "fsync", full)
    assert download("canvas", {"adamsann_17_6_hw08.py": "second"}, ROSTER)[0] == 2
    assert desk.collected == {"aadams": "first"}


@pytest.mark.parametrize(
    ("system", "path"),
    [
        ("moodle", "Ann Adams_17_assignsubmission_file_Bo Brown_18_assignsubmission_file_hw08.py"),
        ("moodle", "Ann Adams_17_assignsubmission_file_/Bo Brown_18_assignsubmission_file_hw08.py"),
        ("moodle", "all/Ann Adams_17_assignsubmission_file/Bo Brown_18_assignsubmission_file_/hw08.py"),
        ("canvas", "adamsann_17_500_brownbo_18_600_hw08.py"),
        ("canvas", "submissions_2026_09_14/adamsann_17_500_hw08.py"),
    ],
)
def test_the_first_name_is_the_students(desk, download, system, path):
    roster = PARTICIPANTS if system == "moodle" else ROSTER
    code, said = download(system, {path: "mine"}, roster, "--assignment", "hw08")
    assert (code, desk.collected) == (0, {"aadams": "mine"}), said


def test_a_table_that_a_student_hands_in_is_not_the_classs(desk, download):
    files = {
        "export/submission_1/submission_metadata.yml": "submission_1:\n  :submitters:\n  - :sid: A2\n",
        "export/submission_1/submission_2/hw08.py": "of Ann and Bo",
        "export/submission_metadata.yml": METADATA,
        "export/submission_2/hw08.py": "of Cy",
    }
    code, said = download("gradescope", files, ROSTER)
    assert desk.collected == {"aadams": "of Ann and Bo", "bbrown": "of Ann and Bo", "cchen": "of Cy"}
    assert code == 1 and "submission_1/submission_metadata.yml of aadams is not collected" in said


NOT_TABLES = {
    "in a submission": METADATA,
    "aliases": "a: &a [x, x]\nb: &b [*a, *a]\nsubmission_1:\n  :submitters: *b\n",
    "deep": "[" * 100_000,
    "no table": "- submission_1\n",
    "a submission is text": "submission_1: Ann\n",
    "submitters are text": "submission_1:\n  :submitters: Ann\n",
    "a submitter is text": "submission_1:\n  :submitters: [Ann]\n",
    "an id is a list": "submission_1:\n  :submitters:\n  - :sid: [A1]\n",
    "a time is a list": "submission_1:\n  :created_at: [now]\n",
    "no YAML": "submission_1: [\n",
    "no text": b"\xff\xfe\x00",
    "large": b"#" * (LARGEST + 1),
}


@pytest.mark.parametrize("what", first(len(NOT_TABLES) - 1, NOT_TABLES))
def test_a_table_that_gradescope_did_not_write_is_refused(desk, download, what):
    folder = "export/submission_1" if what == "in a submission" else "export"
    files = {f"{folder}/submission_metadata.yml": NOT_TABLES[what], "export/submission_1/hw08.py": "x"}
    code, said = download("gradescope", files)
    assert code == 2 and "submission_metadata.yml" in said and not (desk.folder / "submitted").exists()


def test_names_that_are_no_text_are_told_as_text_and_kept_whole(course, tmp_path, capsysbinary):
    clear, letter = "\x1b[2J", os.fsdecode(b"\xe9")  # text that clears a terminal, and a letter in Latin-1
    path = f"Ann{clear} {letter}_17_assignsubmission_file_/{clear}work{letter}.py"
    (tmp_path / "down" / path).parent.mkdir(parents=True)
    (tmp_path / "down" / path).write_text("x")
    (tmp_path / "down" / f"stray{clear}{letter}").write_text("x")
    command = ["collect", str(tmp_path / "down"), "--from", "moodle", "--to", str(tmp_path / "submitted")]
    for _ in range(2):  # the second run reads the table that the first wrote
        assert cli.main(["--root", str(course), *command]) == 1
        out, err = capsysbinary.readouterr()
        assert b"\x1b" not in out + err and err.count(rb"\x1b[2J") >= 2
    assert os.fsencode(path) in (tmp_path / "collected.csv").read_bytes()


@pytest.mark.parametrize(
    "login", first(3, ["../../up", "\x1b[2J", "o'brien", "a\0b", "x" * 300, "__main", ".ssh", "-rf", "*"])
)
def test_a_login_is_one_folder_and_the_same_student_on_the_roster(download, desk, login):
    roster = f'Student,ID,SIS Login ID,Section\n"Adams, Ann",17,"{login}",570\n'
    download("canvas", {"adamsann_17_5_hw08.py": "def skew(v:"}, roster)
    (name,) = desk.collected
    assert not (desk.folder.parent / "up").exists() and len(name.encode()) <= 255 and name.isprintable()
    assert (name == login) == (login == "o'brien")
    desk("grade", "submitted", "--roster", "roster.csv", "--seed", "1", "--out", "results")
    assert [*desk.scores()] == [name]


def test_two_logins_are_two_folders(desk, download):
    roster = 'Student,ID,SIS Login ID,Section\n"Adams, Ann",17,a/b,570\n"Brown, Bo",18,a:b,570\n'
    download("canvas", {"adamsann_17_5_hw08.py": "a", "brownbo_18_6_hw08.py": "b"}, roster)
    assert sorted(desk.collected.values()) == ["a", "b"]
