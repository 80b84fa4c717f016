"""Returns a list that holds itself, and one that is a million levels deep.

deserves: 5
"""

def skew(v):
    ring = []
    ring.append(ring)
    return ring


def rotate(r, axis, angle):
    nest = []
    for _ in range(10**6):
        nest = [nest]
    return nest
