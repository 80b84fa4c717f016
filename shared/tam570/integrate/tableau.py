"""DOP853: the coefficients, and the interpolant that we build on its own one.

Hairer, Norsett, Wanner, Solving Ordinary Differential Equations I, 2nd ed., II.5 and II.10 (code dop853.f).
"""

from functools import cache
from math import sqrt

import numpy as np
from numpy.typing import NDArray

__all__ = ["FIFTH", "LESS", "NODES", "ROWS", "THIRD", "Row", "interpolant"]

Row = dict[int, float]  # coefficient of each earlier stage's derivative

# Row 12 holds the weights of the step itself; 13 to 15 serve the interpolant only.
_STAGES = """
1: 0 0.05260015195876773
2: 0 0.0197250569845379 1 0.0591751709536137
3: 0 0.02958758547680685 2 0.08876275643042054
4: 0 0.2413651341592667 2 -0.8845494793282861 3 0.924834003261792
5: 0 0.037037037037037035 3 0.17082860872947386 4 0.12546768756682242
6: 0 0.037109375 3 0.17025221101954405 4 0.06021653898045596 5 -0.017578125
7: 0 0.03709200011850479 3 0.17038392571223998 4 0.10726203044637328 5 -0.015319437748624402
   6 0.008273789163814023
8: 0 0.6241109587160757 3 -3.3608926294469414 4 -0.868219346841726 5 27.59209969944671
   6 20.154067550477894 7 -43.48988418106996
9: 0 0.47766253643826434 3 -2.4881146199716677 4 -0.590290826836843 5 21.230051448181193
   6 15.279233632882423 7 -33.28821096898486 8 -0.020331201708508627
10: 0 -0.9371424300859873 3 5.186372428844064 4 1.0914373489967295 5 -8.149787010746927
   6 -18.52006565999696 7 22.739487099350505 8 2.4936055526796523 9 -3.0467644718982196
11: 0 2.273310147516538 3 -10.53449546673725 4 -2.0008720582248625 5 -17.9589318631188 6 27.94888452941996
   7 -2.8589982771350235 8 -8.87285693353063 9 12.360567175794303 10 0.6433927460157636
12: 0 0.054293734116568765 5 4.450312892752409 6 1.8915178993145003 7 -5.801203960010585
   8 0.3111643669578199 9 -0.1521609496625161 10 0.20136540080403034 11 0.04471061572777259
13: 0 0.056167502283047954 6 0.25350021021662483 7 -0.2462390374708025 8 -0.12419142326381637
   9 0.15329179827876568 10 0.00820105229563469 11 0.007567897660545699 12 -0.008298
14: 0 0.03183464816350214 5 0.028300909672366776 6 0.053541988307438566 7 -0.05492374857139099
   10 -0.00010834732869724932 11 0.0003825710908356584 12 -0.00034046500868740456 13 0.1413124436746325
15: 0 -0.42889630158379194 5 -4.697621415361164 6 7.683421196062599 7 4.06898981839711
   8 0.3567271874552811 12 -0.0013990241651590145 13 2.9475147891527724 14 -9.15095847217987
"""

# theta^3 and up of Hairer's interpolant of order 7.
_DENSE = """
0: 0 -8.428938276109013 5 0.5667149535193777 6 -3.0689499459498917 7 2.38466765651207 8 2.117034582445028
   9 -0.871391583777973 10 2.2404374302607883 11 0.6315787787694688 12 -0.08899033645133331
   13 18.148505520854727 14 -9.194632392478356 15 -4.436036387594894
1: 0 10.427508642579134 5 242.28349177525817 6 165.20045171727028 7 -374.5467547226902
   8 -22.113666853125306 9 7.733432668472264 10 -30.674084731089398 11 -9.332130526430229
   12 15.697238121770845 13 -31.139403219565178 14 -9.35292435884448 15 35.81684148639408
2: 0 19.985053242002433 5 -387.0373087493518 6 -189.17813819516758 7 527.8081592054236
   8 -11.57390253995963 9 6.8812326946963 10 -1.0006050966910838 11 0.7777137798053443
   12 -2.778205752353508 13 -60.19669523126412 14 84.32040550667716 15 11.99229113618279
3: 0 -25.69393346270375 5 -154.18974869023643 6 -231.5293791760455 7 357.6391179106141 8 93.40532418362432
   9 -37.45832313645163 10 104.0996495089623 11 29.8402934266605 12 -43.53345659001114
   13 96.32455395918828 14 -39.17726167561544 15 -149.72683625798564
"""

# The error estimates of order 5 and of order 3; the latter is the weights of the step less three of its own.
_ESTIMATES = """
E5: 0 0.01312004499419488 5 -1.2251564463762044 6 -0.4957589496572502 7 1.6643771824549864
   8 -0.35032884874997366 9 0.3341791187130175 10 0.08192320648511571 11 -0.022355307863886294
E3: 0 -0.2440944881889764 8 -0.7338466882816118 11 -0.022058823529411766
"""


def _rows(text: str) -> list[Row]:
    rows: list[Row] = []
    words = iter(text.replace("\n", " ").split())
    for word in words:
        if word.endswith(":"):
            rows.append({})
        else:
            rows[-1][int(word)] = float(next(words))
    return rows


ROWS: list[Row] = [{}, *_rows(_STAGES)]
FIFTH, LESS = _rows(_ESTIMATES)
THIRD: Row = {j: ROWS[12].get(j, 0.0) + LESS.get(j, 0.0) for j in ROWS[12]}

# Sums of the rows, to the last bit: the rows' own numbers are rounded.
_EARLY, _LATE = (6 - sqrt(6)) / 30, (6 + sqrt(6)) / 30
NODES = [0.0, 4 / 9 * _EARLY, 2 / 3 * _EARLY, _EARLY, _LATE, 1 / 3, 1 / 4, 4 / 13, 127 / 195, 3 / 5, 6 / 7, 1.0, 1.0]
NODES += [1 / 10, 1 / 5, 7 / 9]


def _dense_weights() -> NDArray[np.float64]:
    """(7, 16): Hairer's interpolant by stage; term i goes with theta^(i // 2 + 1) (1 - theta)^((i + 1) // 2)."""
    weights = np.zeros((7, 16))
    for j, b in ROWS[12].items():
        weights[:3, j] = b, -b, 2 * b
    weights[1, 0] += 1
    weights[2, [0, 12]] -= 1
    for power, row in enumerate(_rows(_DENSE), start=3):
        weights[power, list(row)] = list(row.values())
    return weights


@cache
def interpolant() -> tuple[list[Row], list[float], NDArray[np.float64]]:
    """Rows and nodes of four further stages, and (4, 6) the last terms of the polynomial by datum.

    DOP853's own interpolant has errors up to a hundred times those of the steps. So it only supplies the
    states for four more derivatives; the polynomial of degree 7 takes these, both ends and their derivatives,
    and its error is that of the step. The data, each less what h f at the start makes of it: the change over the
    step, h f at its end, and at the four nodes. The terms are as in `_dense_weights`: by powers of theta alone the
    weights would be five times as large, and so would what rounding makes of them.
    """
    legendre = np.polynomial.legendre.Legendre.basis(6)
    nodes = np.sort((1 + np.real(legendre.deriv(2).roots())) / 2)  # with both ends double: the least remainder
    p, q = np.array([1, 1, 2, 2, 3, 3, 4]), np.array([0, 1, 1, 2, 2, 3, 3])  # theta^p (1 - theta)^q
    basis = nodes[:, None] ** p * (1 - nodes[:, None]) ** q
    rows = [{j: float(a) for j, a in enumerate(row) if a} for row in basis @ _dense_weights()]
    x = np.concatenate([[0.0, 1.0], nodes])[:, None]
    slopes = p * x ** (p - 1) * (1 - x) ** q - q * x**p * (1 - x) ** np.maximum(q - 1, 0)
    weights = np.linalg.inv(np.vstack([q == 0, slopes]))
    return rows, [float(node) for node in nodes], np.delete(weights[3:], 1, axis=1)
