"""The search names mistakes that are in no list by trying changes; it names none if two causes are possible."""

import math
from dataclasses import replace

import numpy as np
import pytest

from tam570_grader.checks.case import Call, Case
from tam570_grader.diagnosis.cause import Cause
from tam570_grader.diagnosis.diagnose import diagnose
from tam570_grader.diagnosis.mistakes import Mistake, NoValue, explains, named_mistake, solution_with
from tam570_grader.diagnosis.search import general

FORMULAS = {
    "weight(mass, height, *, gravity, length)": "mass * gravity * height + mass * length**2 / 2",
    "polar(x, y)": "np.hypot(x, y), np.arctan2(y, x)",
    "cross(a, b)": "np.array([_part(a, b, 1, 2), _part(a, b, 2, 0), _part(a, b, 0, 1)])",
    "_part(a, b, i, j)": "a[i] * b[j] - a[j] * b[i]",
    "lift(length, mass, *, gravity)": "mass * length**2 - mass * gravity * length",
    "swing(angle, *, mass)": "2 * mass * np.sin(angle / 2) ** 2",
    "rod(x, y)": "np.array([[[0.0, 1.0], [x, y]]])",
    "forces(x, y)": "np.array([[x, y], [y**2, x + y]])",
    "tumble(rate, *, mass, radius, inertia)": "inertia[0] * rate**2 + inertia[1] * rate + mass * radius",
    "squares(om1, om2, *, mass)": "mass * om1**2, -mass * om2**2",
    "stretch(side, slope)": "np.hypot(1.0, 2 * slope * side)",
    "rates(angles, omega)": "np.array([omega * angles[1], angles[1] + 2 * angles[2], angles[2] ** 2])",
    "bars(a, b)": "np.array([a**2 / 3, a / 2, b / 2])",
    "sizes(a, b)": "a**2 + b**2 + a",
    "waves(angle, speed, *, inertia)": "np.asarray(inertia) * (np.sin(angle) + speed)",
    "inside(a, b)": "a * b * (a**2 + b) / 2",
    "grid(x, y)": "np.array([[x, y, 1.0], [x * y, 2.0, y**2], [3.0, x**2, 4.0]])",
}
SOLUTION = """import numpy as np


def turned(v, *, angle):
    x, y = v
    return x * np.cos(angle) - y * np.sin(angle), x * np.sin(angle) + y * np.cos(angle)


def fall(t, height, speed, *, gravity, drag):
    fallen = np.asarray(t) - t[0]
    return np.column_stack([height + speed * fallen - gravity * fallen**2 / 2, speed - gravity * fallen])


def balance(angle, *, mass):
    moment = mass * np.sin(angle)
    return moment / 2, moment


def disk(lean, speed, *, inertia):
    A, C = inertia
    axis = np.array([np.sin(lean), speed, 1.0])
    length = np.sqrt(axis @ axis)
    return (C - A) * speed**2 / (A + C * lean), A * length - lean


def rolls(speed, *, mass, radius):
    rolling = mass * radius**2
    return speed / (2 + rolling) + rolling * speed**2 + mass * speed + radius


def powers(a, b):
    K = np.array([[a, b], [b, 2.0]])
    return K + K @ K


def stairs(n, m):
    total = 0.0
    while n > 0:
        total, n = total + n, n - 1
    return total + m**2


""" + "\n\n".join(f"def {signature}:\n    return {formula}\n" for signature, formula in FORMULAS.items())
DRAW = np.random.default_rng(2)


def rotated(v, angle):
    c, s = math.cos(angle), math.sin(angle)
    return np.array([[c, -s], [s, c]]) @ v


def cases():
    """Return {function: [(input, {name in a wrong formula: value})]}."""
    pairs, positive = DRAW.uniform(1, 3, (4, 2)), DRAW.uniform(0.5, 3, (4, 4))
    disks, quadrants = positive * [1, 1, 1, 2], DRAW.uniform(1, 2, (4, 2)) * [[1, 1], [1, -1], [-1, 1], [-1, -1]]
    turns = list(zip(DRAW.normal(size=(4, 2)), DRAW.uniform(0.3, 1.2, 4), strict=True))
    t, fields = np.linspace(1, 3, 9) ** 2, {"gravity": 2.0, "drag": 0.7}
    bodies = [(rate, {"mass": m, "radius": r, "inertia": (a, 2.0)}) for rate, m, r, a in positive]
    return {
        "weight": [(Case(m, h, gravity=g, length=b), {"m": m, "h": h, "g": g, "l": b}) for m, h, g, b in positive],
        "turned": [(Case(v, angle=a), {"v": v, "a": a}) for v, a in turns],
        "polar": [(Case(*at), {"r": math.hypot(*at), "a": math.atan2(*at[::-1])}) for at in quadrants.tolist()],
        "cross": [(Case(a, b), {"a": a, "b": b}) for a, b in DRAW.normal(size=(4, 2, 3))],
        "lift": [(Case(x, m, gravity=9.0), {"l": x, "m": m, "g": 9.0}) for x, m in pairs],
        "swing": [(Case(a, mass=2.0), {"a": a, "m": 2.0}) for a in DRAW.uniform(0.3, 1.2, 4)],
        "rod": [(Case(x, y), {"x": x, "y": y}) for x, y in pairs],
        "forces": [(Case(x, y), {"F": np.array([[x, y], [y**2, x + y]])}) for x, y in pairs],
        "fall": [(Case(t, 1.5, 0.8, **fields), {"t": t - t[0], "h": 1.5, "v": 0.8})],
        "tumble": [(Case(rate, **body), {"w": rate, **body}) for rate, body in bodies],
        "squares": [(Case(p, q, mass=2.0), {"p": p, "q": q}) for p, q in pairs],
        "stretch": [(Case(x, y), {"x": x, "y": y}) for x, y in pairs],
        "rates": [(Case(a, 0.7), {"a": a}) for a in DRAW.normal(size=(4, 3))],
        "disk": [
            (Case(b, v, inertia=(a, c)), dict(A=a, C=c, b=b, v=v, s=math.sin(b), c=math.cos(b))) for a, b, v, c in disks
        ],
        "rolls": [(Case(w, mass=m, radius=r), {"w": w, "m": m, "r": r}) for m, r, w, _ in positive],
        "powers": [(Case(*pair), {"K": np.array([pair, [pair[1], 2.0]])}) for pair in pairs],
        "bars": [(Case(*pair), {"a": pair[0], "b": pair[1]}) for pair in pairs],
        "sizes": [(Case(*pair), {"a": pair[0], "b": pair[1]}) for pair in pairs],
        "inside": [(Case(*pair), {"a": pair[0], "b": pair[1]}) for pair in pairs],
        "waves": [
            (Case(side * a, v, inertia=(1.0, a, v)), {"s": math.sin(side * a), "v": v, "I": np.array([1.0, a, v])})
            for side, (a, v) in zip((1, -1, 1, -1), pairs, strict=True)
        ],
        "grid": [(Case(x, y), {"x": x, "y": y}) for x, y in pairs],
        "balance": [(Case(a, mass=2.0), {"a": a}) for a in DRAW.uniform(0.3, 1.2, 4)],
    }


def calls(function, wrong):
    """Return calls of a function whose results come from a wrong formula."""
    tools = {"np": np, "math": math, "rotated": rotated}
    return [Call(function, case, eval(wrong, {**tools, **names})) for case, names in cases()[function]]


@pytest.mark.parametrize(
    ("function", "wrong", "words"),
    [
        ("weight", "m*g*h", "length is ignored, as if it were zero"),
        ("weight", "g*h + l**2/2", "mass is ignored, as if it were 1"),
        ("weight", "m*9.81*h + m*l**2/2", "gravity is ignored, as if it were 9.81"),
        ("weight", "m*(g*h - l**2/2)", "the sign of a term with length, mass is reversed"),
        ("weight", "m*g*h + m*l/2", "an exponent with length is one too large or too small"),
        ("weight", "m*g*h + m*(l*m)**2/2", "length has a factor mass too many"),
        ("weight", "m*(g*h + l**2/2)/g**2", "Your result of weight should be multiplied by gravity squared"),
        ("weight", "g*h + m*l**2/2", "the factor mass is missing beside gravity, height"),
        ("weight", "m*g*h + m*l**2", "a term with length, mass counts twice"),
        ("weight", "0.0", "Your result of weight is zero"),
        ("weight", "3.7", "Your result of weight is the same for all inputs"),
        ("fall", "np.column_stack([h + v*t + t**2, v + 2*t])", "gravity has the opposite sign"),
        ("fall", "np.column_stack([h + v*t - 0.7*t**2, v - 1.400001*t])", "gravity has a factor drag too many"),
        ("fall", "np.column_stack([h + 1.6903085*v*t - t**2, 1.6903085*v - 2*t])", "divided by sqrt(gravity/drag)"),
        ("tumble", "(inertia[0]*w + 2)*w/3 + mass*radius/3", "0.3333 times the right one"),
        ("tumble", "(inertia[0]*w + 2)*w + mass*radius + 1.25", "off by 1.25"),
        ("tumble", "(inertia[0] + mass*radius**2)*w**2 + 2*w + mass*radius", "1 of inertia has mass radius^2"),
        ("forces", "F + [[0.0, 0.0], [0.3, 0.0]]*F**2", "wrong in row 2, column 1 alone"),
        ("forces", "F + [[0.3, 0.0], [0.3, 0.0]]*F**2", "wrong in column 1 alone"),
        ("forces", "F[::-1]", "has rows 1 and 2 exchanged"),
        ("forces", "F*[1, -1]", "has the opposite sign in column 2"),
        ("polar", "(r, math.atan(math.tan(a)))", "is the arctan of a ratio"),
        ("polar", "(r, abs(a))", "Your second result of polar lacks its sign"),
        ("polar", "(r, math.sqrt(max(a, 0.0)))", "is the square root of the right one, and zero"),
        ("rolls", "w/(2 + m*r**2)**2 + m*r**2*w**2 + m*w + r", "a divisor with mass, radius is squared"),
        ("polar", "(-r, -a)", "Your results of polar have the opposite sign"),
        ("forces", "F*[[1, 1], [-1, 1]]", "the sign of a term is reversed"),
        ("swing", "2*(1 + math.cos(a))", "a cosine with angle has the wrong sign"),
        ("lift", "m*l**2 + g*m*l", "the sign of a term with gravity, length, mass is reversed"),  # only one slip
        ("lift", "-m*l**2 - g*m*l", "the sign of a term with length, mass is reversed"),
        ("turned", "(v @ [1, -1]*math.cos(a), v @ [1, 1]*math.cos(a))", "the wrong function is used with angle"),
        ("turned", "rotated(v, a) + [0, v[0]*(math.sin(math.radians(a)) - math.sin(a))]", "radians is read as degrees"),
        ("turned", "rotated(v, math.radians(a))", "angle is read as degrees"),
        ("turned", "rotated(v, a)*[2, 1]", "is twice as large as the right one in component 1"),
        ("squares", "(2*p*q, -2*p*q)", "a square with om1, om2 is a product of two quantities"),
        ("stretch", "math.sqrt(1 + 2*y*x)", "a quantity with side, slope is not squared"),
        ("rates", "np.array([a[0]**2, a[1] + 2*a[0], 0.7*a[1]])", "the result have components 1 and 3 exchanged"),
        ("turned", "np.array([[1, -a], [a, 1]]) @ v", "a sine or cosine with angle is linearised"),
        ("balance", "(a, 2*math.sin(a))", "Your first result of balance is linear in angle"),
        ("tumble", "w**2 + 2*w + mass*radius", "inertia is that of a thin disk, A = C/2"),
        ("rod", "np.array([[[x, y], [0.0, 1.0]]])", "has ends 1 and 2 exchanged"),
        ("disk", "((C - A)*v**2/(A + A*b), A*math.hypot(s, v, 1) - b)", "the wrong component of inertia is used"),
        ("disk", "((C - A)*v**2/(A + C*b)**0.5, A*math.hypot(s, v, 1) - b)", "a divisor with inertia, lean is"),
        ("disk", "((C - A)*v**2/(A + C*b), A*(s + v + 1) - b)", "a length with lean, speed is the sum"),
        ("disk", "((C - A)*v**2/(A + C*b)*c, A*math.hypot(s, v, 1) - b)", "a factor cos(lean) too many"),
        ("disk", "((C - A)*v**2/(A + C*b), A*math.hypot(s, v, 1)/(2*math.pi) - b)", "is divided by 2 pi"),
        ("rolls", "w/2 + m*w + r", "mass * radius ** 2 is ignored, as if it were zero"),
        ("powers", "2*K", "a factor with a, b is missing"),
        ("cross", "np.array([a[1]*b[2] - a[2], a[2]*b[0] - a[0], a[0]*b[1] - a[1]])", "a factor with b is missing"),
        ("cross", "np.cross(a, b)*[1, 1.1, 1]", "wrong in component 2 alone"),
        ("cross", "np.cross(a, b)*[-1, 1, -1]", "the opposite sign in components 1 and 3"),
        ("rod", "np.array([[[0.0, 1.0], [x, y*y + 1]]])", "wrong in segment 1, end 2, component 2 alone"),
        ("weight", "m*g*h + m*m*l**2/2", "a term with length, mass has a factor mass too many"),
        ("fall", "np.column_stack([h + v*(t + 1) - (t + 1)**2, v - 2*(t + 1)])", "the term t[0] is missing"),
        ("bars", "np.array([a**2/12, a/2, b/2])", "m l^2/12 is used for m l^2/3 with a"),
        ("bars", "np.array([a**2/4, a/2, b/2])", "the bar's inertia m l^2/12 about its mass centre is missing"),
        ("bars", "np.array([a**2/3, a, b])", "every division by 2 is missing"),
        ("sizes", "(a + b)**2 + a", "a sum with a, b is squared as a whole"),
        ("waves", "I*(abs(s) + v)", "a sine or cosine with angle has lost its sign"),
        ("waves", "I*(s + v)**(1 if s > 0 else 1.1)", "wrong only where angle is negative"),
        ("inside", "a**2 + a*b*b/2", "the factors of a sum with a, b multiply only one of its terms"),
        ("waves", "s + v + 0*I", "should be multiplied by inertia, component by component"),
        ("grid", "np.array([[x, y, 3], [x*y, 2, y**2], [1, x**2, 4.0]])", "elements (1, 3) and (3, 1) exchanged"),
    ],
)
def test_it_is_named_by_what_it_does(function, wrong, words):
    cause = general(SOLUTION, calls(function, wrong))
    assert cause.function == function and words in cause.message


@pytest.mark.parametrize(
    "of",
    [
        lambda: calls("weight", "m*g*h + m*l**2/2"),  # correct
        lambda: calls("weight", "m*(g*h - l**2/2)")[:1],  # a single call
        lambda: calls("weight", "m + g"),
        lambda: calls("turned", "-rotated(v, a)") + calls("cross", "np.cross(b, a)"),  # two functions are wrong
        lambda: [*calls("turned", "rotated(v, a)"), Call("turned", Case(np.ones(2), angle=0.1), None)],
        lambda: calls("cross", "4*np.linalg.norm(a)*np.cross(a, b)"),
        lambda: calls("fall", "np.column_stack([h + v*t - 0.705*t**2, v - 1.41*t])"),  # 0.705 is not drag, 0.7
    ],
)
def test_what_is_no_one_thing_is_not_named(of):
    assert general(SOLUTION, of()) is None


@pytest.mark.parametrize(
    ("change", "words"),
    [
        (lambda angle: angle % math.pi, "In turned, angle is taken modulo pi"),
        (lambda angle: angle - math.pi * round(angle / math.pi), "modulo pi, from -pi/2 to pi/2"),
        (abs, "In turned, angle has lost its sign"),
    ],
)
def test_an_angle_that_loses_its_turns_or_its_sign_is_named(change, words):
    v = np.array([1.0, 2.0])
    wrong = [Call("turned", Case(v, angle=a), tuple(rotated(v, change(a)))) for a in (-2.0, 0.4, 2.5, 4.0, -1.0)]
    assert words in general(SOLUTION, wrong).message


@pytest.mark.parametrize(("right", "is_named"), [((2.0, 3.0, 5.0), True), ((2.0,), False)])
def test_a_single_result_without_its_sign_is_named_beside_right_ones(right, is_named):
    wrong = [Call("inside", Case(a, 1.0), abs(a) * (a**2 + 1.0) / 2) for a in (*right, -4.0)]
    cause = general(SOLUTION, wrong)
    assert (cause is not None and cause.message.startswith("Your result of inside lacks its sign")) == is_named


def test_a_result_that_cancels_beside_larger_ones_is_explained_too():
    bodies = (2.0, 3.0, 50.0, 1.7, 0.0), (3.0, 1.0, 70.0, 2.2, 0.0), (1.0, 2.0, 16.0, 8.0, 1e-12)
    wrong = [(Case(m, h, gravity=g, length=b), m * g * h - m * b**2 / 2 + off) for m, h, g, b, off in bodies]
    cause = general(SOLUTION, [Call("weight", case, result) for case, result in wrong])
    assert "the sign of a term with length, mass is reversed" in cause.message


def test_what_was_told_of_another_function_is_told_as_the_same(tmp_path):
    earlier = [Cause("lift", "Your result of lift has the opposite sign", "result")]
    cause = diagnose(SOLUTION, tmp_path, calls("cross", "np.cross(b, a)"), earlier)
    assert cause.message == "Your result of cross has the opposite sign, as in lift"


def test_a_variant_that_never_ends_is_passed_over():
    """The variant of `stairs` with another sign in its step never ends; the search skips it and names a later slip."""
    steps = [Call("stairs", Case(n, m), n * (n + 1) / 2 + m) for n, m in ((2, 3.0), (3, 5.0), (4, 7.0))]
    assert general(SOLUTION, steps).message == "In stairs, an exponent with m is one too large or too small"


LINEAR = "import math\n\nimport numpy as np\n\n\ndef f(x):\n    return 2.0 * x\n\n\ndef g(x):\n    return 3.0 * x\n"


def wrong(body, **fields):
    return Mistake("a_mistake", "A wrong formula.", "a_check", f"def f(x):\n    return {body}\n", **fields)


def is_named(mistake, *calls):
    """Return whether calls (function, input, student's result) agree with a mistake."""
    cause = named_mistake(LINEAR, [mistake], [Call(name, Case(x), result) for name, x, result in calls])
    return cause is not None and cause.message == mistake.message


AGREE = [  # (formula of a wrong f, calls, whether they agree with it); the correct f is 2 x, and g is 3 x
    *((body, [("f", 0.0, 1.0)], False) for body in ("1 / x", "math.sqrt(x - 1)", "np.linalg.inv([[x]])")),
    # a call that failed agrees with no value
    ("x", [("f", 1.0, 1.0), ("f", 0.0, None)], False),
    ("1 / x", [("f", 1.0, 1.0), ("f", 0.0, None)], True),
    ("1 / x if x else math.nan", [("f", 1.0, 1.0), ("f", 0.0, None)], True),
    ("x", [("f", 0.0, None)], False),
    # results of functions that the mistake does not change do not matter
    ("x", [("f", 1.0, 1.0), ("g", 1.0, math.pi)], True),
    ("x", [("g", 1.0, 1.0)], False),
    # a correct result is no mistake
    ("2.0 * x", [("f", 1.0, 2.0)], False),
    ("2.0 * abs(x)", [("f", 1.0, 2.0)], False),
    # every call must agree
    ("2.0 * abs(x)", [("f", 1.0, 2.0), ("f", -1.0, 2.0)], True),
    ("2.0 * abs(x)", [("f", -1.0, 2.0), ("f", -2.0, -4.0)], False),
    # a result that cancels differs from zero by the rounding of larger results
    *(("x", [("f", large, large), ("f", 0.0, -3e-14)], large > 1.0) for large in (1.0, 90.0)),
]


@pytest.mark.parametrize(("body", "calls", "agreeing"), AGREE)
def test_a_mistake_is_named_where_its_numbers_agree(body, calls, agreeing):
    assert is_named(wrong(body), *calls) == agreeing


@pytest.mark.parametrize(("result", "following"), [(0.0, True), (1.0, False)])
def test_where_a_mistake_has_no_value_the_right_one_follows_too(result, following):
    calls = [Call("f", Case(1.0), 1.0), Call("f", Case(0.0), result)]
    assert explains(LINEAR, lambda call: call.case.args[0] or NoValue, calls) == following


def test_how_closely_is_said_by_the_mistake():
    assert not is_named(wrong("x"), ("f", 1.0, 1.001))
    assert is_named(wrong("x", tolerance=1e-2), ("f", 1.0, 1.001))


def test_an_answer_is_computed_once_for_the_same_input():
    """A wrong function that counts its calls is called once for each input."""
    counted = wrong("(calls.append(1), x)[1]")
    text = counted.text.replace("def f", "calls = []\n\n\ndef f")
    counted = replace(counted, text=text)
    for x in (5.0, 5.0, 6.0, 5.0):
        named_mistake(LINEAR, [counted], [Call("f", Case(x), x)])
    assert len(solution_with(LINEAR, text).calls) == 2


def test_one_mistake_of_several_is_told_by_the_inputs_that_show_it_alone():
    thin, thick = Case(1.0).labelled("a thin disk"), Case(2.0).labelled("a hoop")
    calls = [Call("f", thin, 1.0), Call("f", thick, 7.0)]
    of_label, of_all = wrong("x", label="thin"), wrong("x")
    assert named_mistake(LINEAR, [of_all, of_label], calls).message == of_label.message
    assert named_mistake(LINEAR, [of_all], calls) is None
    assert named_mistake(LINEAR, [wrong("x", label="thick")], calls) is None
