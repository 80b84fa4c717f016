"""Plain Python as machine code: the same numbers, to the last bit; what is beyond is refused by name."""

import ctypes
import inspect
import textwrap
from math import exp, sin, sqrt

import numpy as np
import pytest

pytest.importorskip("llvmlite")

from tam570.integrate.compiled.ir import Array, Untranslatable, Value  # noqa: E402
from tam570.integrate.compiled.llvm import assembled, function  # noqa: E402
from tam570.integrate.compiled.translate import Translator, functions_of  # noqa: E402

TABLE = ((0.5, 2.0), (1.5, -3.0), (2.5, 0.25))


def sums(x, a):
    total, k = 0.0, 0
    while True:
        k += 1
        if k > 10:
            break
        if k == 4:
            continue
        total += a[k - 1] / (x * x + k)
    return total


def branches(x, a):
    if x > 2.0:
        return -x
    elif x < -2.0 or (x > 0.0 and a[1] > x):
        return x * x
    return 1.0 if not x > 0.0 else max(x, a[0], 0.25)


def tables(x, a):
    total = 0.0
    for weight, factor in TABLE:
        total = total * x + weight * factor
    for i in range(3):
        total -= a[i]
    return total


def swapped(x, a):
    p, q = x, (a[0], a[1])
    (p, r), q = q, p
    return helper(p, r) - q


def helper(p, q):
    """Inlined where it is called."""
    return math_of(p) if p > q else q // 1.0 if False else abs(q) ** 2.5


def math_of(p):
    return sqrt(abs(p)) + sin(p) * exp(-p * p)


def not_numbers(x, a):
    return min(1.0, x) + max(x, -1.0) if -3.0 <= x < 3.0 else 2.0 - x


def compiled(python):
    source = inspect.getsource(inspect.getmodule(python))
    writer = Translator(functions_of(textwrap.dedent(source)), {"TABLE": TABLE})
    result = writer.called(writer.globals[python.__name__], [Value("double", "%x"), Array("%a", None, 10)])
    writer.do(f"store double {writer.text(result, 'double')}, ptr %out")
    head = "define void @go(double %x, ptr %a, ptr %out) {\nentry:"
    text = assembled([*writer.constants(), head, *writer.allocations, *writer.lines, "  ret void", "}"])
    run = function(text, lambda: text, "go", (ctypes.c_double, ctypes.c_void_p, ctypes.c_void_p))

    def value(x, a):
        out = np.zeros(1)
        run(x, a.ctypes.data, out.ctypes.data)
        return out[0]

    return value


@pytest.mark.parametrize("python", [sums, branches, tables, swapped, not_numbers])
def test_the_same_bits(python):
    machine, draw = compiled(python), np.random.default_rng(1)
    for x in [0.0, -0.0, 1.0, 2.0, -2.0, *draw.uniform(-4, 4, 200)]:
        a = draw.uniform(-2, 2, 10)
        assert machine(float(x), a) == python(float(x), a.tolist())


def generator(x, a):
    return sum(b for b in a)


def text(x, a):
    return len("abc") + x.real


def into_whole(x, a):
    k = 0
    for _ in range(3):
        k = x
    return k


@pytest.mark.parametrize("python", [generator, text, into_whole])
def test_what_is_beyond_is_refused(python):
    with pytest.raises(Untranslatable):
        compiled(python)
