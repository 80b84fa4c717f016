"""nbgrader's gradebook in a PostgreSQL database; the server is lost in the middle of each command."""

import os
import pwd
import shutil
import socket
import subprocess
import tempfile
from pathlib import Path

import pytest
from classes import HW08 as SLUG
from classes import hand_in, rows

pytestmark = pytest.mark.slow  # half a minute of nbgrader
STUDENTS = ("ann", "ben", "cas")
SERVER = "postgres"  # the user: PostgreSQL refuses to run as root
# nbgrader's configuration of a test: at the statement whose number stands in the file `lost` the server stops
STOPPING = """
import os, subprocess
from sqlalchemy import event
from sqlalchemy.engine import Engine

@event.listens_for(Engine, "before_cursor_execute")
def _count(*_):
    if os.path.exists("lost"):
        left = int(open("lost").read()) - 1
        open("lost", "w").write(str(left))
        if left == 0:
            os.remove("lost")
            subprocess.run({stop!r}, check=True, cwd="/", stdout=subprocess.DEVNULL)
"""


@pytest.fixture
def server():
    """The port of a PostgreSQL server, the command that stops it as a crash would, and a function that starts it."""
    pytest.importorskip("psycopg", reason="no psycopg: pip install 'tam570[postgres]'")
    actual = [*Path("/usr/lib/postgresql").glob("*/bin/initdb"), *filter(None, [shutil.which("initdb")])]
    if not actual:
        pytest.skip("there is no PostgreSQL here: apt-get install postgresql")
    with tempfile.TemporaryDirectory() as name, socket.socket() as free:  # pytest's folders are for root alone
        if os.geteuid() == 0:
            Path(name).chmod(0o755)
            os.chown(name, pwd.getpwnam(SERVER).pw_uid, -1)
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
        free.close()
        user = ["runuser", "-u", SERVER, "--"] if os.geteuid() == 0 else []

        def command(program, *arguments):
            return [*user, str(Path(actual[0]).parent / program), "-D", f"{name}/data", *arguments]

        def run(*words):
            subprocess.run(command(*words), check=True, stdout=subprocess.DEVNULL, cwd="/")

        def start():
            options = f"-p {port} -k {name} -c listen_addresses=127.0.0.1"
            run("pg_ctl", "-w", "-o", options, "-l", f"{name}/log", "start")

        run("initdb", "--auth=trust", f"--username={SERVER}")
        start()
        stop = "pg_ctl", "-w", "-m", "immediate", "stop"
        yield port, command(*stop), start
        run(*stop)


def test_a_command_whose_server_is_lost_says_so_and_finishes_when_given_again(
    server, tmp_path, made_course, nbgrader, solution_text
):
    port, stop, start = server
    course, _ = made_course(tmp_path, [SLUG])
    config = course / "nbgrader_config.py"
    text = config.read_text().replace("# c.CourseDirectory.db_url = ", "c.CourseDirectory.db_url = ", 1)
    url = f"postgresql://{SERVER}@127.0.0.1:{port}/postgres"
    config.write_text(text.replace("postgresql://teacher@localhost/gradebook", url) + STOPPING.format(stop=stop))

    def lost(number, *command):
        (course / "lost").write_text(str(number))
        log = nbgrader(course, *command, fails=True)
        assert not (course / "lost").exists()  # else it was not lost in the command
        assert "does not answer" in log.splitlines()[-1] and "Traceback" not in log
        start()

    lost(40, "generate_assignment", SLUG)
    nbgrader(course, "generate_assignment", SLUG)
    for student in STUDENTS:
        shutil.copytree(course / "release" / SLUG, course / "submitted" / student / SLUG)
    hand_in(course / "submitted", dict.fromkeys(STUDENTS, solution_text(SLUG)))
    for statement in (60, 200):  # of the first student, and after the first
        lost(statement, "autograde", SLUG)
        assert not (course / "autograded" / STUDENTS[-1] / SLUG).exists()
    nbgrader(course, "autograde", SLUG)
    (course / "grades.csv").write_text("of the last time")
    lost(20, "export")
    assert (course / "grades.csv").read_text() == "of the last time"
    nbgrader(course, "export")
    scores = {row["student_id"]: float(row["score"]) for row in rows(course / "grades.csv")}
    assert scores == dict.fromkeys(STUDENTS, 10.0)
