"""Run the command `tam570-grader` for `python -m tam570_grader`."""

import sys

from tam570_grader.cli import main

sys.exit(main())
