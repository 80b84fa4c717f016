"""Code that tests append to a correct module: functions return texts, NaN, objects, other shapes, or raise.

`ODD` = (seed, functions, share): the functions that return odd values, and in which share of their calls.
"""

import collections
import decimal
import fractions
import functools
import math
import random

import numpy as np

DRAW = random.Random(ODD[0])  # noqa: F821  the test defines ODD above this text


class Liar(float):
    def __float__(self):
        raise RuntimeError("no")

    __eq__ = __lt__ = __gt__ = lambda self, other: True
    __hash__ = None


class Vague:
    def __getattr__(self, name):
        return self

    def __array__(self, *args, **kwargs):
        return np.array([1.0, math.nan, 3.0])


class Rows(list):
    def __len__(self):
        return 7


class Marked(np.ndarray):
    def __array_finalize__(self, other):
        self.mark = "odd"


class Unprintable(Exception):
    def __str__(self):
        raise self


def self_holding():
    items = [1.0]
    items.append(items)
    return items


def nested(depth):
    items = [1.0]
    for _ in range(depth):
        items = [items, items] if depth < 9 else [items]
    return items


def raising(error):
    raise error


NUMBERS = [
    *(0, -0.0, 1, -1, 7, 0.1, math.pi, 1e300, -1e300, 1.7e308, 5e-324, -1e-320, 2**63, -(2**64), 10**400),
    *(math.nan, math.inf, -math.inf, True, False, 1j, complex(1, 1e-30), complex(math.nan, math.inf)),
    *(np.float32(1.1), np.float16(6e4), np.longdouble(1) / 3, np.int8(-128), np.uint64(2**64 - 1), np.bool_(True)),
    *(fractions.Fraction(1, 3), decimal.Decimal("NaN"), decimal.Decimal("1e500"), Liar(1.0), np.datetime64("NaT")),
]
THINGS = [
    *("", "0.1", "nan", "<script>alert(1)</script>", "\x1b[2J\u202e\ud800", "=1+1", "x" * 5000, b"", b"\xff\x00"),
    *(None, ..., NotImplemented, object, len, math, Vague(), Unprintable(), {}, {"x": 1.0}, {1: [2]}, {1.0, 2.0}),
    *((), [], [[]], [None], [[1.0], [2.0, 3.0]], [1.0, "2"], (1.0, [2.0]), Rows([1.0, 2.0]), range(3), slice(3)),
    *(collections.namedtuple("Pair", "a b")(1, 2), collections.deque([1.0]), frozenset(), bytearray(b"12")),
]
MADE = [
    *(lambda: (x for x in (1.0, 2.0, 3.0)), lambda: iter([1.0]), lambda: map(float, "123"), self_holding),
    *(lambda: nested(DRAW.choice([2, 6, 7, 12, 60, 900])), lambda: np.empty((0, 3)), lambda: np.empty((3, 0))),
    *(lambda: np.zeros((1,) * 9), lambda: np.zeros((1,) * 40), lambda: np.array([object(), None])),
    *(lambda: np.array([[1.0], [2.0, 3.0]], object), lambda: np.array(["a", "1"])),
    lambda: np.array([1.0, 2.0], [("x", float), ("y", float)] if DRAW.random() < 0.5 else object),
    lambda: np.ma.masked_array([1.0, 2.0, 3.0], [True, False, True]),
    *(lambda: np.matrix([[1.0, 2.0], [3.0, 4.0]]), lambda: np.zeros(2 ** DRAW.choice([12, 17, 21, 22]))),
    lambda: np.zeros((DRAW.choice([1, 3, 100]), DRAW.choice([1, 2, 3, 4, 6]))),
    lambda: np.broadcast_to(1.0, (10**6, 10**3)),
    lambda: np.random.default_rng(DRAW.randrange(9)).normal(size=DRAW.choice([(), 3, (3, 3), (5, 4)])),
    *(lambda: np.array(3.0), lambda: np.array(DRAW.choices(NUMBERS[:23], k=3))),
    lambda: list(DRAW.choices([*NUMBERS, *THINGS], k=DRAW.randrange(5))),
]
ERRORS = [
    *(ValueError("no"), ZeroDivisionError, StopIteration, GeneratorExit, SystemExit(0), KeyboardInterrupt),
    *(MemoryError, RecursionError, NotImplementedError, Unprintable, UnicodeDecodeError("x", b"", 0, 1, "y")),
    *(ValueError("\x1b]0;odd\x07" * 999), ExceptionGroup("odd", [ValueError(), TypeError()]), BaseException),
    *(AssertionError, Warning, OSError(28, "full"), SyntaxError("odd", ("f", -3, 1, "x"))),
]
CHANGES = [
    *(lambda a: a.T, lambda a: a[:-1], lambda a: a[..., :1], lambda a: a[..., None], lambda a: a[None]),
    *(lambda a: a[::-1], lambda a: np.concatenate([a, a]), lambda a: np.concatenate([a, a], -1)),
    lambda a: a * DRAW.choice([-1, 0, 1e300, 1e-300, 1e-320, math.nan, math.inf, 1j, 1 + 1e-9j, 1 + 1e-12, 2]),
    lambda a: a + DRAW.choice([1e-9, 1e-3, 1, 1e150, 1e308, -math.inf]),
    lambda a: a + np.exp(np.random.default_rng(DRAW.randrange(99)).uniform(-700, 700, a.shape)),
    *(lambda a: a.astype(DRAW.choice(["f4", "f2", "c16", "i8", "O", "U9", "S3", "?"])), lambda a: a.view(Marked)),
    *(lambda a: a.tolist(), lambda a: tuple(map(tuple, a)), lambda a: [str(x) for x in a]),
    lambda a: list(map(fractions.Fraction, a)),
    lambda a: np.where(np.arange(a.size).reshape(a.shape) % 3, a, DRAW.choice([math.nan, math.inf, 1e300, 0])),
    lambda a: np.sort(a, axis=None).reshape(a.shape),
    lambda a: np.full_like(a, DRAW.choice([0, 1, 1e300, -1e300, 5e-324, math.nan])),
    *(lambda a: np.asfortranarray(a)[..., ::-1], lambda a: {i: x for i, x in enumerate(a)}),
]


def changed(value):
    """Return the correct value with an odd change: in one member of a list, all of an array, or a term of a formula."""
    if isinstance(value, list | tuple) and value:
        items = list(value)
        if DRAW.random() < 0.3:
            items[DRAW.randrange(len(items))] = odd(items[0])
            return type(value)(items) if DRAW.random() < 0.8 else items
        for _ in range(DRAW.randrange(4)):
            DRAW.choice([items.pop, items.reverse, lambda: items.append(items[0]), lambda: items.extend(items)])()
            if not items:
                return []
        items[0] = changed(items[0])
        return items
    if hasattr(value, "free_symbols"):
        import sympy

        x = next(iter(sorted(value.free_symbols, key=str)), sympy.Symbol("x"))
        more = [sympy.nan, sympy.oo, sympy.zoo, sympy.I, sympy.Symbol("q"), sympy.Function("f")(x), 10**400]
        more += [sympy.log(x - x), sympy.Piecewise((x, x > 9)), sympy.Derivative(x**2, x), sympy.Integral(x, x)]
        more += [sympy.Float("1e99999"), x**x**3, sympy.Symbol("<b>"), sympy.sqrt(-1 - x**2), 1 / (x - x)]
        return DRAW.choice([value + DRAW.choice(more), value * DRAW.choice(more), str(value), sympy.Matrix([value])])
    try:
        array = np.asarray(value, float)
        return DRAW.choice(CHANGES)(array) if array.ndim else DRAW.choice(CHANGES[8:11])(array)
    except Exception:
        return DRAW.choice(THINGS)


def odd(value):
    """Return an odd answer in place of the correct value, or raise; call `value` only if the answer needs it."""
    way = DRAW.random()
    if way < 0.45:
        return changed(value() if callable(value) else value)
    if way < 0.6:
        return DRAW.choice(NUMBERS)
    if way < 0.75:
        return DRAW.choice(THINGS)
    return DRAW.choice(MADE)() if way < 0.92 else raising(DRAW.choice(ERRORS))


def scribble(axes):
    """Do something odd to the Axes that a plot function receives."""
    many = np.geomspace(5e-324, 1e308, 50)
    ways = [
        *(axes.clear, axes.remove, axes.invert_yaxis, axes.figure.clear),
        *(lambda: axes.plot(many, -many, label="\x1b[1m"), lambda: axes.plot([math.nan, math.inf], [1, 2])),
        *(lambda: axes.plot([], []), lambda: axes.plot(["a", "b"], [1, 2]), lambda: axes.twinx().plot([1, 2])),
        *(lambda: axes.plot(np.zeros(9), np.zeros(9), lw=0), lambda: axes.scatter(many, many, s=1e9)),
        *(lambda: axes.imshow([[1, 2]]), lambda: axes.pie([1, 2]), lambda: axes.hist([1.0, 2.0])),
        *(lambda: axes.text(1e300, 1e300, "$\\frac{$"), lambda: axes.set_xlabel("$x^{$" * 99)),
        *(lambda: axes.set_xscale("log"), lambda: axes.set_xlim(1e300, -1e300), lambda: axes.set_xlim(1, 1)),
        *(lambda: axes.set_aspect(1e-300), lambda: axes.set_position([0, 0, 1e-9, 1e-9])),
        *(lambda: [axes.plot([0, k]) for k in range(600)], lambda: axes.lines[0].set_data([], [])),
        lambda: axes.figure.set_size_inches(1e-9, 1e-9),
    ]
    for _ in range(DRAW.randrange(1, 4)):
        DRAW.choice(ways)()


def made_odd(function):
    @functools.wraps(function)
    def answer(*args, **kwargs):
        if DRAW.random() >= ODD[2]:  # noqa: F821
            return function(*args, **kwargs)
        if args and hasattr(args[0], "get_xlim"):
            function(*args, **kwargs)
            scribble(args[0])
        return odd(functools.partial(function, *args, **kwargs))

    return answer


for name in ODD[1]:  # noqa: F821
    globals()[name] = made_odd(globals()[name])
