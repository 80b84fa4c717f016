"""Common libraries that submissions import, and that a zygote can import once for all of them."""

import re

COMMON = (
    *("matplotlib.pyplot", "scipy.integrate", "scipy.linalg", "scipy.optimize", "scipy.special", "sympy"),
    *("tam570.integrate", "tam570.rotations"),
)


def imported(text: bytes) -> frozenset[str]:
    """Return the common libraries that import statements anywhere in a submission name."""
    statements = b"\n".join(STATEMENT.findall(text))
    return frozenset(name for name, pattern in PATTERNS.items() if pattern.search(statements))


def _pattern(name: str) -> re.Pattern[bytes]:
    package, _, module = name.partition(".")
    name = re.escape(name)
    ways = rf"import +{name}\b|from +{name} |from +{package} +import .*\b{module or package}\b"
    return re.compile(rf"^[ \t]*(?:{ways})".encode(), re.MULTILINE)  # one line: linear time


STATEMENT = re.compile(rb"^[ \t]*(?:import|from) .*", re.MULTILINE)
PATTERNS = {name: _pattern(name) for name in COMMON}
