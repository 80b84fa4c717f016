"""The command `tam570-grader`, also by `python -m tam570_grader`."""

from tam570.signals import end_at_once

end_at_once()  # the imports take time

from tam570_grader.cli import run  # noqa: E402

if __name__ == "__main__":
    run()
