"""Puts hidden inputs into the names and texts of exceptions, into dictionaries and into printed output.

Published against graders that show tracebacks (sotoblanco/BaseLayer issue 106; ucbds-infra/otter-grader issue
419).

deserves: 0
"""

def skew(v):
    raise type("LEAK" + "_".join(map(str, v)), (Exception,), {})("LEAK", v)


def rotate(r, axis, angle):
    print("LEAK", r)
    return type("LEAK", (), {})()


def rotation_matrix(axis, angle):
    return {"LEAK": axis}
