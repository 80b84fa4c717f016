"""`python -m tam570` is the command `tam570`."""

import sys

from tam570.cli import main

sys.exit(main())
