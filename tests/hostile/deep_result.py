"""Returns a list that contains itself, and a list that is nested a million levels deep.

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
