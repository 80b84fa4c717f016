"""Puts hidden inputs into the names and texts of exceptions, of types and of prints.

deserves: 0
"""

def skew(v):
    raise type("LEAK" + "_".join(map(str, v)), (Exception,), {})("LEAK", v)


def rotate(r, axis, angle):
    print("LEAK", r)
    return type("LEAK", (), {})()


def rotation_matrix(axis, angle):
    return {"LEAK": axis}
