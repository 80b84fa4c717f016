"""The learning management systems: what each calls a file that a student handed in, and what its tables look like.

A system is one value of SYSTEMS; the options of the commands, the page of the documentation and the tests are made of
it. What a system does not have is None. Verified against the vendors' code where it is public:

- Canvas: `lib/content_zipper.rb` (`get_filename`, `add_upload_submission`, `sanitize_file_name`: the name in small
  letters and without signs, LATE, the user, the attachment; of a group its name and one member's number), and
  `lib/gradebook_exporter.rb` (`csv_data`: the headings, "    Points Possible", EX, N/A).
- Moodle: `mod/assign/classes/downloader.php` (`get_student_prefix`: name and participant, or a group's name and number;
  `load_submissionplugin_filelist`: folders or names) and `mod/assign/gradingtable.php` (the worksheet).
- Blackboard and Brightspace are closed. What public tools read of them: `kwurst/bb-file-cleanup` (README.md),
  `nbeaver/offline-grades-upload` (readme.rst), and `OrgDefinedId`, `Points Grade`, `End-of-Line Indicator` of imports.
- GitHub Classroom: folders `assignment-user`, as `gh classroom clone student-repos` makes them.
"""

import re
from collections.abc import Mapping
from dataclasses import dataclass, field

__all__ = ["SYSTEMS", "System", "Table"]

NUMBER = "[0-9]{1,20}"


@dataclass(frozen=True)
class Table:
    """A table of scores that a system imports."""

    keys: tuple[str, ...]  # headings that tell who a row is, kept as the system exported them
    login: tuple[str, ...]  # of these, the ones that hold a login, where no roster says more
    column: re.Pattern[str]  # of the heading of an assignment: its title, and an id or the points possible
    heading: str = "{slug}"  # of a new column
    must_match: bool = True  # the system makes a second assignment of a column that it does not know
    identities: Mapping[str, str] = field(default_factory=dict)  # --identity: the one heading that is a key
    possible: str | None = None  # how the row of the points possible begins
    end: tuple[str, str] | None = None  # heading and cell of a last column
    mark: str = ""  # before each key
    excused: str = ""  # in the place of a score


@dataclass(frozen=True)
class System:
    """What one system writes and reads."""

    title: str
    download: re.Pattern[str] | None  # the name of a file or folder of a student; None: a table or the folders tell
    ids: Mapping[str, tuple[str, ...]] = field(default_factory=dict)  # group of the name: kinds of ids on a roster
    must_agree: bool = False  # a number counts only if the name beside it is its owner's
    has_times: bool = False  # the download tells when a file came
    page: str | None = None  # the name of a page that is handed back
    table: Table | None = None


SYSTEMS = {
    "canvas": System(
        "Canvas",
        re.compile(
            rf"(?P<start>(?P<name>.{{1,400}}?)_(?P<late>LATE_)?(?P<user>{NUMBER})_(?P<order>{NUMBER})_)(?P<file>.+)"
            rf"|(?P<name2>.{{1,400}}?)_(?P<late2>LATE_)?(?P<user2>{NUMBER})_(?:text|link)\.html",
            re.IGNORECASE | re.DOTALL,
        ),
        ids={"user": ("id",)},
        must_agree=True,
        page="{start}{slug}.html",
        table=Table(
            keys=(
                "Student",
                "LastName",
                "FirstName",
                "ID",
                "SIS User ID",
                "SIS Login ID",
                "Integration ID",
                "Root Account",
                "Section",
            ),
            login=("Student", "SIS Login ID"),
            column=re.compile(r"(?P<title>.*) \((?P<id>\d+)\)", re.DOTALL),
            possible="Points Possible",
            excused="EX",
        ),
    ),
    "moodle": System(
        "Moodle",
        re.compile(
            rf"(?P<name>.{{1,400}}?)_(?P<user>{NUMBER})_assignsubmission_(?:file|onlinetext)_?(?P<file>.*)", re.DOTALL
        ),
        ids={"user": ("participant",)},
        must_agree=True,
        page="{name}_{user}_assignsubmission_file_{slug}.html",
        table=Table(
            keys=("Username",),
            login=("Username",),
            column=re.compile(r"(?P<title>.*)", re.DOTALL),
            must_match=False,
            identities={"username": "Username", "idnumber": "ID number", "email": "Email address"},
        ),
    ),
    "gradescope": System(
        "Gradescope", None, ids={"sid": ("number", "login"), "email": ("email", "login")}, has_times=True
    ),
    "blackboard": System(
        "Blackboard",
        re.compile(
            r"(?P<title>.{1,400}?)_(?P<user>[^_/]{1,100})_attempt_(?P<when>\d{4}(?:-\d\d){5})(?:_(?P<file>.+)|\.txt)",
            re.DOTALL,
        ),
        ids={"user": ("login",)},
        has_times=True,
        table=Table(
            keys=("Last Name", "First Name", "Username", "Student ID"),
            login=("Username",),
            column=re.compile(r"(?P<title>.*) \[Total Pts: (?:up to )?(?P<possible>[\d.,]+)[^\]]*\] ?\|(?P<id>\d+)"),
        ),
    ),
    "brightspace": System(
        "Brightspace",
        re.compile(
            rf"{NUMBER}-{NUMBER} - (?P<name>.{{1,400}}?) ?- "
            r"(?P<when>[A-Z][a-z]+ \d{1,2}, \d{4} \d{1,2}:?\d\d [AP]M)(?: ?- (?P<file>.+))?",
            re.DOTALL,
        ),
        has_times=True,
        table=Table(
            keys=("OrgDefinedId", "Username"),
            login=("Username",),
            column=re.compile(r"(?P<title>.*) Points Grade(?: <.*?MaxPoints:(?P<possible>[\d.]+).*>)?", re.DOTALL),
            heading="{slug} Points Grade",
            end=("End-of-Line Indicator", "#"),
            mark="#",
        ),
    ),
    "github": System("GitHub Classroom", None, ids={"user": ("github", "login")}),
}
