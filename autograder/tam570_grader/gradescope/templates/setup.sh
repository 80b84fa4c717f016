#!/bin/sh
# Gradescope runs this once, as root, when it builds the image: Python 3.11 or newer, the grader, its sandbox.
set -eu
cd /autograder/source
apt-get update -qq
for version in 3.13 3.12 3.11; do
    if apt-get install -y -qq "python$$version" "python$$version-venv"; then break; fi
done
apt-get install -y -qq bubblewrap || true # without it submissions run as plain processes of another user
"python$$version" -m venv /autograder/venv
/autograder/venv/bin/pip install --quiet --disable-pip-version-check ./course
chmod -R go= /autograder/source # no submission reads solutions or checks, sandbox or not
