"""Euler angles: one set of formulas for the twelve sequences.

Let i, j be the first two axes, k the third one of the frame and s = e_k . (e_i x e_j) = +-1. The sequence
ijk is iji with a quarter turn about j before and after the last rotation,
R_k(c) = R_j(pi/2) R_i(-s c) R_j(-pi/2), so that

    R_i(a) R_j(b) R_k(c) = R_i(a) R_j(b + pi/2) R_i(-s c) R_j(-pi/2),

and R_j(-pi/2) only exchanges two columns: e_i -> s e_k, e_k -> -s e_i. So the formulas for iji serve both.
"""

from dataclasses import dataclass

from tam570.rotations._evaluate import Component, Formula, Functions
from tam570.rotations._formulas import defect, nothing

Numbers = tuple[Component, ...]


@dataclass(frozen=True)
class Sequence:
    """Axes i, j, k (0, 1, 2) of the frame, the handedness s of i, j, k, and whether the last turn is about i."""

    i: int
    j: int
    k: int
    s: int
    proper: bool


def sequences() -> dict[str, Sequence]:
    """Return the twelve sequences by name, such as "313"."""
    return {
        f"{i + 1}{j + 1}{last + 1}": Sequence(i, j, 3 - i - j, 1 if (j - i) % 3 == 1 else -1, last == i)
        for i in range(3)
        for j in range(3)
        for last in range(3)
        if i != j != last
    }


def matrix_of_angles(order: Sequence) -> Formula:
    """Return the formula of the rotation matrix of three angles."""

    def formula(f: Functions, a: Component, b: Component, c: Component) -> Numbers:
        i, j, k, s = order.i, order.j, order.k, order.s
        ca, sa, cc = f.cos(a), f.sin(a), f.cos(c)
        cb, sb, sc = (f.cos(b), f.sin(b), f.sin(c)) if order.proper else (-f.sin(b), f.cos(b), -s * f.sin(c))
        of_i = {i: cb, j: sa * sb, k: -s * ca * sb}  # the axis turned by R_i(a) R_j(b) R_i(c)
        of_j = {i: sc * sb, j: cc * ca - sc * cb * sa, k: s * (cc * sa + sc * cb * ca)}
        of_k = {i: s * cc * sb, j: -s * (cc * cb * sa + sc * ca), k: cc * cb * ca - sc * sa}
        columns = {i: of_i, j: of_j, k: of_k}
        if not order.proper:
            columns = {i: _times(s, of_k), j: of_j, k: _times(-s, of_i)}
        return nothing(a, b, c), *(columns[column][row] for row in range(3) for column in range(3))

    return formula


def _times(s: int, vector: dict[int, Component]) -> dict[int, Component]:
    return {axis: s * component for axis, component in vector.items()}


def angles_of_matrix(order: Sequence) -> Formula:
    """Return the formula of the three angles of a rotation matrix.

    The formula computes the first angle, undoes its rotation, and computes the last angle from what remains: near
    gimbal lock each of the two is ill-conditioned, but together they still give R.
    """

    def formula(f: Functions, *R: Component) -> Numbers:
        j, k, s = order.j, order.k, order.s
        rows = [R[0:3], R[3:6], R[6:9]]
        of_i = [row[order.i] if order.proper else -s * row[k] for row in rows]
        of_k = [row[k] if order.proper else s * row[order.i] for row in rows]
        sa, ca, cb = of_i[j], 0.0 - s * of_i[k], of_i[order.i]  # sin b times the sine and cosine of a
        sb = f.hypot(sa, ca)
        a = f.atan2(sa, ca)  # 0 for 0 and 0: ca is never -0
        sa, ca = f.sin(a), f.cos(a)  # of the rounded angle, so that c corrects its error
        sc = -s * (ca * of_k[j] + s * sa * of_k[k])  # from e_j turned by c, in the frame before that turn
        cc = ca * rows[j][j] + s * sa * rows[k][j]
        if order.proper:
            return defect(*R), a, f.atan2(sb, cb), f.atan2(sc, cc)
        return defect(*R), a, f.atan2(-cb, sb), f.atan2(-s * sc, cc)

    return formula


def rates(order: Sequence) -> Formula:
    """Return the formula of the three rates, omega in body axes, and of a number that is 0 in gimbal lock."""

    def formula(f: Functions, a: Component, b: Component, c: Component, *omega: Component) -> Numbers:
        s = order.s
        cb, sb, cc, sc = f.cos(b), f.sin(b), f.cos(c), f.sin(c)
        if not order.proper:
            cb, sb, sc = -sb, cb, -s * sc
        about_i = omega[order.i] if order.proper else -s * omega[order.k]
        about_k = omega[order.k] if order.proper else s * omega[order.i]
        across = cc * omega[order.j] - s * sc * about_k  # along j and k of the frame before the last rotation
        along = cc * about_k + s * sc * omega[order.j]
        first = s * along / f.where(sb == 0, 1.0, sb)
        last = about_i - cb * first
        return nothing(a, b, c, *omega), first, across, last if order.proper else -s * last, sb

    return formula
