"""euler_rates_313 uses tam570.rotations.

fails: euler_rates_make_omega
names: what is off limits in it: tam570.rotations
"""

from tam570 import rotations


def euler_rates_313(angles, omega):
    return rotations.euler_rates("313", angles, omega)
