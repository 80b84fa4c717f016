"""The learning management systems: their names for submitted files, and the layouts of their tables.

Options of commands, a page of the documentation and tests are generated from SYSTEMS. None: there is no such file.
"""

import re
from collections.abc import Mapping
from dataclasses import dataclass, field

NUMBER = "[0-9]{1,20}"


@dataclass(frozen=True)
class ScoreTable:
    """The layout of a table of scores that a system imports."""

    keys: tuple[str, ...]  # headings that identify a student, copied from the system's export
    login: tuple[str, ...]  # those of the keys that contain a login if there is no roster
    column: re.Pattern[str]  # heading of an assignment: title, and an id or the points possible
    heading: str = "{slug}"  # heading of a new column
    must_match: bool = True  # a column that the system does not know would create another assignment
    identities: Mapping[str, str] = field(default_factory=dict)  # by --identity: the heading of the only key
    possible: str | None = None  # first cell of the row of points possible
    end: tuple[str, ...] = ()  # heading and cell of an additional last column
    prefix: str = ""  # prefix of each key
    excused: str = ""  # score of an excused student


@dataclass(frozen=True)
class System:
    """The files that a system writes and reads."""

    title: str
    export: str  # what an instructor downloads
    verified: str  # the files with which the layouts were compared
    download: re.Pattern[str] | None  # name of a student's file or folder; None: a table or plain folders identify them
    ids: Mapping[str, tuple[str, ...]] = field(default_factory=dict)  # by group of `download`: kinds of ids on a roster
    must_agree: bool = False  # an id counts only if the name beside it is its owner's
    has_times: bool = False  # the download has the times of the files
    page: str | None = None  # name of a feedback page
    table: ScoreTable | None = None


SYSTEMS = {
    "canvas": System(
        "Canvas",
        "In SpeedGrader or on the assignment's page, Download Submissions; in the Gradebook, Export",
        "`instructure/canvas-lms`, `lib/content_zipper.rb` (`get_filename`, `add_upload_submission`, "
        "`sanitize_file_name`) and `lib/gradebook_exporter.rb` (`csv_data`). A group's file has its name and one "
        "member's number.",
        re.compile(
            rf"(?P<start>(?P<name>.{{1,400}}?)_(?P<late>LATE_)?(?P<user>{NUMBER})_(?P<order>{NUMBER})_)(?P<file>.+)"
            rf"|(?P<name2>.{{1,400}}?)_(?P<late2>LATE_)?(?P<user2>{NUMBER})_(?:text|link)\.html",
            re.IGNORECASE | re.DOTALL,
        ),
        ids={"user": ("id",)},
        must_agree=True,
        page="{start}{slug}.html",
        table=ScoreTable(
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
        "In the assignment, Download all submissions and Download grading worksheet, which has the times",
        "`moodle/moodle`, `mod/assign/classes/downloader.php` (`get_student_prefix`, "
        "`load_submissionplugin_filelist`) and `mod/assign/gradingtable.php` (the worksheet). A group's folder has its "
        "name and number.",
        re.compile(
            rf"(?P<name>.{{1,400}}?)_(?P<user>{NUMBER})_assignsubmission_(?:file|onlinetext)_?(?P<file>.*)", re.DOTALL
        ),
        ids={"user": ("participant",)},
        must_agree=True,
        page="{name}_{user}_assignsubmission_file_{slug}.html",
        table=ScoreTable(
            keys=("Username",),
            login=("Username",),
            column=re.compile(r"(?P<title>.*)", re.DOTALL),
            must_match=False,
            identities={"username": "Username", "idnumber": "ID number", "email": "Email address"},
        ),
    ),
    "gradescope": System(
        "Gradescope",
        "Export Submissions",
        "Its help pages, for it is closed. `submission_metadata.yml` tells the submitters of each, a group's too.",
        None,
        ids={"sid": ("number", "login"), "email": ("email", "login")},
        has_times=True,
    ),
    "blackboard": System(
        "Blackboard",
        "In the Grade Center, Assignment File Download; Work Offline, Download",
        "Public tools that read its files: `kwurst/bb-file-cleanup` (`README.md`) and `nbeaver/offline-grades-upload` "
        "(`readme.rst`). Blackboard is closed.",
        re.compile(
            r"(?P<title>.{1,400}?)_(?P<user>[^_/]{1,100})_attempt_(?P<when>\d{4}(?:-\d\d){5})(?:_(?P<file>.+)|\.txt)",
            re.DOTALL,
        ),
        ids={"user": ("login",)},
        has_times=True,
        table=ScoreTable(
            keys=("Last Name", "First Name", "Username", "Student ID"),
            login=("Username",),
            column=re.compile(r"(?P<title>.*) \[Total Pts: (?:up to )?(?P<possible>[\d.,]+)[^\]]*\] ?\|(?P<id>\d+)"),
        ),
    ),
    "brightspace": System(
        "Brightspace",
        "In the assignment, Download all submissions; in Grades, Export with Org Defined ID and Username",
        "Its help, [Importing grades](https://community.d2l.com/brightspace/kb/articles/3538-importing-grades), for "
        "`OrgDefinedId`, `Username` and `Points Grade`; public tools that read its files, for `#` and "
        "`End-of-Line Indicator`. It is closed, and its folders tell no id: students are joined by name.",
        re.compile(
            rf"{NUMBER}-{NUMBER} - (?P<name>.{{1,400}}?) ?- "
            r"(?P<when>[A-Z][a-z]+ \d{1,2}, \d{4} \d{1,2}:?\d\d [AP]M)(?: ?- (?P<file>.+))?",
            re.DOTALL,
        ),
        has_times=True,
        table=ScoreTable(
            keys=("OrgDefinedId", "Username"),
            login=("Username",),
            column=re.compile(r"(?P<title>.*) Points Grade(?: <.*?MaxPoints:(?P<possible>[\d.]+).*>)?", re.DOTALL),
            heading="{slug} Points Grade",
            end=("End-of-Line Indicator", "#"),
            prefix="#",
        ),
    ),
    "github": System(
        "GitHub Classroom",
        "`gh classroom clone student-repos`; on the classroom's page, Download roster",
        "Its help, [Using GitHub Classroom with GitHub CLI](https://docs.github.com/en/education/"
        "manage-coursework-with-github-classroom/teach-with-github-classroom/using-github-classroom-with-github-cli), "
        "for the folders; `identifier` and `github_username` as public tools read `classroom_roster.csv`. Git's times "
        "are students', so none is read.",
        None,
        ids={"user": ("github", "login")},
    ),
}
