"""Sets its own limit of processor time, so that the kernel kills it as an operator would, and it is tried again.

deserves: 10
"""

import resource

try:
    resource.setrlimit(resource.RLIMIT_CPU, (1, 1))
except (OSError, ValueError):
    pass
else:
    raise SystemExit("limited")
assert resource.getrlimit(resource.RLIMIT_CPU)[1] > 1
