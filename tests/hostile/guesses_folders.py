"""Opens other students' folders by names that can be guessed, without listing the folder above.

Published against nbgrader (issue 978: submissions have names of a known form and are open to everyone; jeflem/ananke
issue 27: an exchange with mode 777).

deserves: 10
"""

import os

SLUG = "hw08_axis_angle"
for top in (
    "/srv/nbgrader/exchange",
    "/usr/local/share/nbgrader/exchange",
    "/tmp/exchange",
    "submitted",
    "..",
):
    for student in ("ada", "ben", "inbound", "dyn", "course101"):
        for name in (SLUG, f"{SLUG}.py", f"{student}+{SLUG}+2026-11-21 00:00:00.000000 UTC", "inbound"):
            if os.path.exists(os.path.join(top, student, name)):
                raise SystemExit("found")
