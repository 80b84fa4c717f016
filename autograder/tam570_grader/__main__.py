"""`python -m tam570_grader` is the command `tam570-grader`."""

import sys

from tam570_grader.cli import main

sys.exit(main())
