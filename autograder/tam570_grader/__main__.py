"""Run the command `tam570-grader` for `python -m tam570_grader`."""

from tam570_grader.cli import run

run()
