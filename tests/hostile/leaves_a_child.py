"""Leaves a detached child behind, by every way there is.

deserves: 10
"""

import os
import subprocess
import threading
import time

def linger():
    while True:
        time.sleep(1)


for start in (
    lambda: os.fork() or (os.setsid(), os.fork() or linger()),
    lambda: subprocess.Popen(["sleep", "1000"], start_new_session=True),
    lambda: subprocess.Popen("sleep 1000 &", shell=True),
    lambda: os.posix_spawn("/bin/sleep", ["sleep", "1000"], {}),
    lambda: threading.Thread(target=linger, daemon=False).start(),
):
    try:
        start()
    except Exception:
        pass
