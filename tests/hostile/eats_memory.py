"""Takes 8 GiB in one function.

deserves: 9
"""

def skew(v):
    hoard = [bytearray(2**28) for _ in range(32)]
    return [[len(hoard)] * 3] * 3
