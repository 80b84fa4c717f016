"""A mistake in one function is named once; a check that fails only because of it keeps two thirds of its points."""

import pytest
from parameters import first

from tam570_grader.checks import assignments
from tam570_grader.grading.consequences import FOLLOWING_SHARE

OWN_EQUATIONS = """terms = [mass_matrix(theta, masses=masses, lengths=lengths)]
    terms += [velocity_terms(theta, omega, masses=masses, lengths=lengths)]
    terms += [gravity_terms(theta, masses=masses, lengths=lengths, gravity=gravity)]
    return np.linalg.solve(terms[0], -terms[1] - terms[2])"""
UP = "-k * z - gravity", "-k * z + gravity"


@pytest.fixture
def checked(grade, solution_text):
    """`checked(slug, (line, wrong), more=text)` -> {check: result} of the solution with a wrong line and more text."""

    def checked(slug, *lines, more=""):
        text = solution_text(slug) + more
        for correct, wrong in lines:
            assert correct in text
            text = text.replace(correct, wrong)
        return {check.name: check for check in grade(slug, text).checks}

    return checked


def following(checks):
    """Return {(function, function that it follows from)}; assert that each such check keeps its share of the points."""
    failed = [check for check in checks.values() if check.outcome == "failed" and check.failure.follows_from]
    pairs = {(check.failure.function, check.failure.follows_from) for check in failed}
    for check in failed:
        assert check.points == pytest.approx(FOLLOWING_SHARE * check.max_points, abs=1e-6) and not check.suspect
    return pairs


def by_name(checks):
    return [name for name, check in checks.items() if check.suspect]


def test_a_wrong_load_is_told_once_and_costs_a_third_of_what_it_carries(checked):
    correct = "return mass * gravity * abs(free / arm)"
    actual = checked("hw06_braking", (correct, "return mass * gravity * front / (front + rear)"))
    assert by_name(actual) == ["axle_load_balances_the_weight"]
    functions = "friction_force", "state_derivative", "simulate", "yaw_growth_rate", "small_yaw_rate", "axle_load"
    assert following(actual) == {(name, "axle_load") for name in functions}
    full = [name for name, check in actual.items() if check.points == check.max_points]
    assert "simulate_glides_without_friction" in full  # runs although the check before it failed
    assert sum(check.points for check in actual.values()) > 6.5


@pytest.mark.parametrize("wrong", first(1, ["m1 / 2", "m1 / 12"]))
def test_the_energy_follows_from_the_mass_matrix(checked, wrong):
    actual = checked("hw07_double_pendulum", ("[[(m1 / 3 + m2)", f"[[({wrong} + m2)"))
    assert by_name(actual) == ["mass_matrix_makes_the_kinetic_energy"]
    assert following(actual) == {("energy", "mass_matrix"), ("angular_momentum", "mass_matrix")}


HW13 = assignments.checks_folder(assignments.find(), "hw13_rolling_cylinder")
OF_CYLINDER = {(name, "acceleration") for name in ("contact_force", "simulate")}
UNNAMED = [
    ("hw12_bead_on_wire", "v**2 / 2 - mass", "0.7 * v**2 - mass", {("lagrange_equation", "lagrangian")}),
    ("hw13_rolling_cylinder", "turned = inertia + mass", "turned = 1.2 * inertia + 0.7 * mass", OF_CYLINDER),
    ("hw01_simple_pendulum", "return -slope / inertia, k", "return -slope / inertia * (omega != 0), k", set()),
]


@pytest.mark.parametrize(("slug", "correct", "wrong", "pairs"), first(1, UNNAMED))
def test_what_follows_from_a_mistake_without_a_name_keeps_its_share_too(checked, slug, correct, wrong, pairs):
    actual = checked(slug, (correct, wrong))
    assert not by_name(actual) and following(actual) == pairs


@pytest.mark.slow
def test_one_wrong_argument_in_all_functions_is_told_once(checked):
    moment = "    return _weight_moment(phi, mass, radius, {}offset,"
    actual = checked(
        "hw13_rolling_cylinder",
        ("turned = inertia", "offset = -offset\n    turned = inertia"),
        ("return inertia + mass *", "offset = -offset\n    return inertia + mass *"),
        (moment.format(""), moment.format("-")),
        ("    return mass * radius * offset * math", "    return -mass * radius * offset * math"),
        ("c, s = math.cos(phi)", "offset = -offset\n    c, s = math.cos(phi)"),
        ("- offset * math.cos(phi + slope)\n    return kin", "+ offset * math.cos(phi + slope)\n    return kin"),
    )
    assert by_name(actual) == ["acceleration_balances_momentum_about_G"]
    pairs = following(actual)
    assert {cause for _, cause in pairs} == {"acceleration"} and len(dict(pairs).keys() - {"acceleration"}) == 6


@pytest.mark.parametrize(("wrong", "outcome"), [("- np.sin(angle) * skew(n)", "passed"), ("+ no_name", "not_run")])
def test_what_is_refused_is_judged_after_wrong_numbers(checked, wrong, outcome):
    actual = checked("hw08_axis_angle", ("+ np.sin(angle) * skew(n)", wrong))
    assert actual["matrix_turns_by_the_right_hand_rule"].outcome == "failed"
    assert actual["matrix_refuses_what_is_no_axis"].outcome == outcome


def test_a_wrong_entry_of_a_matrix_is_one_mistake(checked):
    wrapper = "\n\nright = rotation_matrix\n\n\ndef rotation_matrix(axis, angle):\n    return right(axis, angle) * {}\n"
    actual = checked("hw08_axis_angle", more=wrapper.format("[[1, 1, 1], [1, 1.1, 1], [1, 1, 1]]"))
    assert by_name(actual) == ["matrix_turns_by_the_right_hand_rule"]
    assert following(actual) == {("rotation_matrix", "rotation_matrix")}


def test_a_function_that_is_always_zero_makes_nothing_else_right(checked):
    actual = checked("hw06_braking", ("return mass * gravity * abs(free / arm)", "return 0.0"))
    assert not {"axle_load", "friction_force"} & {source for _, source in following(actual)}


METHOD = "_Rod().alpha({})", "class _Rod:\n    def alpha(self, {}):\n        return {}\n\n\n"
OF_SEVERAL = "_rod({})['alpha']", "def _rod({}):\n    return {{'alpha': {}}}\n\n\n"


@pytest.mark.parametrize(("sign", "form"), [("-", METHOD), ("+", METHOD), ("+", OF_SEVERAL)])
def test_a_mistake_in_a_helper_is_told_once(checked, sign, form):
    alpha = form[0].format(arguments := "theta, length, gravity")
    helper = form[1].format(arguments, f"{sign}gravity / length * math.sin(theta)")
    actual = checked(
        "hw01_simple_pendulum",
        ("def linear_momentum_balance", f"{helper}def linear_momentum_balance"),
        ("return tangential / (mass * length)", f"return {alpha}"),
        ("return power_per_omega / (mass * length**2)", f"return {alpha}"),
        ("return generalized_force / (mass * length**2)", f"return {alpha}"),
    )
    functions = {"power_balance", "virtual_work"} if sign == "+" else set()
    assert following(actual) == {(name, "linear_momentum_balance") for name in functions}


@pytest.mark.parametrize(("drag", "weight"), [("-", "mass * gravity"), ("-0.7 * ", "1.2 * gravity")])  # named, unnamed
def test_a_flight_follows_from_its_own_rates(checked, drag, weight):
    integrated = 'solve(_rates, t, start, parameters={"rate": drag / mass, "gravity": gravity}'
    own_call = 'solve(state_derivative, t, start, parameters={"mass": mass, "drag": drag, "gravity": gravity}'
    correct = "_rates(t, (0.0, 0.0, vx, vy), rate=drag / mass, gravity=gravity)"
    own_rates = f"[vx, vy, {drag}drag / mass * vx, -drag / mass * vy - {weight}]"
    actual = checked("hw02_ballistics", (integrated, own_call), (correct, own_rates))
    assert ("simulate", "state_derivative") in following(actual)


def test_a_mistake_that_is_made_twice_is_charged_twice(checked):
    actual = checked(
        "hw01_simple_pendulum",
        ("return tangential / (mass * length)", "return -tangential / (mass * length)"),
        ("return generalized_force / (mass * length**2)", "return -generalized_force / (mass * length**2)"),
    )
    assert not following(actual) and len(by_name(actual)) == 2


@pytest.mark.parametrize("sign", ["", "-"])
def test_accelerations_follow_from_the_students_own_equations(checked, sign):
    alpha = "return np.array(_rates(0.0, state, **_parameters(masses, lengths, gravity))[2:])"
    last = "gravity_terms(theta, masses=masses, lengths=lengths, gravity=gravity)]"
    equations = OWN_EQUATIONS.replace(last, last.replace("gravity_terms", f"{sign}gravity_terms"))
    actual = checked("hw07_double_pendulum", (alpha, equations), ("gravity * np.array([", "-gravity * np.array(["))
    assert (("angular_acceleration", "gravity_terms") in following(actual)) == (sign == "")


def test_a_plot_of_a_wrong_motion_or_by_a_wrong_picture_keeps_its_share(checked):
    assert ("plot_projection", "simulate") in following(checked("hw04_hanging_spring", UP))
    mirrored = "ax.plot(*project(", "ax.plot(*-project("
    assert "plot_projection" not in dict(following(checked("hw04_hanging_spring", UP, mirrored)))
    picture = checked("hw04_hanging_spring", ("[-sa, ca, 0.0]", "[sa, -ca, 0.0]"))
    assert following(picture) == {("plot_projection", "project")}


@pytest.mark.parametrize("sign", ["", "-"])
def test_an_ellipse_follows_from_the_students_own_motion(checked, sign):
    lines = ("0.0, -gravity])", f"0.0, {sign}gravity])"), ("-mass * gravity / stiffness", "mass * gravity / stiffness")
    actual = checked("hw04_hanging_spring", *lines)
    assert (("orbit", "solution") in following(actual)) == (sign == "")


TWICE, SMALL = ("2.0 * speed * math.sin", "speed * math.sin"), "small_oscillation_frequencies"
HEAVY = "+ m2 * second @", "+ 2.5 * m2 * second @"
NO_C, SLOPE = ("(A - B) / C * p * q", "(A - B) * p * q"), ("return 2 * curvature * x\n", "return curvature * x\n")
CENTRIFUGAL = "+ mass * x * phi_dot**2", "- mass * x * phi_dot**2"
ABOVE = "-offset * math.sin(phi), radius - offset", "-offset * math.sin(phi), radius + offset"
NO_WEIGHT, FORCE = ("+ mass * gravity * Z  #", "  #"), ("* spin, mass", "* spin, math.cos(lean) * mass")
BY_VECTORS = "matrix_state_derivative", "euler_state_derivative"
BY_OTHERS = [
    ("hw02_ballistics", TWICE, ("best_angle", "flight_time"), "vy + m", "vy - m"),
    ("hw06_braking", ("sideways / car", "forward / car"), ("yaw_growth_rate", "state_derivative"), "(8 * s", "(9 * s"),
    ("hw02_ballistics", ("[vx * t", "[2 * vx * t"), ("horizontal_range", "trajectory"), "[0, 0]", "[0, 2]"),
    ("hw07_double_pendulum", HEAVY, ("on_the_fly", "mass_matrix"), "return alpha, np", "return 1.1 * alpha, np"),
    ("hw07_double_pendulum", HEAVY, (SMALL, "mass_matrix"), "squares.real", "squares.real / 2"),
    ("hw12_bead_on_wire", SLOPE, ("energy", "acceleration_newton"), "speed**2 / 2", "speed**2"),
    ("hw10_free_rigid_body", NO_C, ("growth_rate_squared", "euler_equations"), "slope(j, k) *", "2 * slope(j, k) *"),
    ("hw11_disk_steady", ("cos + A", "cos - A"), ("sliding_spin", "moment_residual"), "residual(0", "2 * residual(0"),
    ("hw11_disk_steady", FORCE, ("rolling_spin", "contact_force"), "residual(1", "residual(2"),
    ("hw13_rolling_cylinder", CENTRIFUGAL, ("contact_force", "acceleration"), "cylinder)[1:])", "cylinder)[:0:-1])"),
    ("hw13_rolling_cylinder", ABOVE, ("naive_contact_acceleration", "acceleration"), "x * math.cos(s", "math.cos(s"),
    ("hw14_rolling_disk", NO_WEIGHT, BY_VECTORS, "+ turning", "- turning"),  # a call of its rates takes 1 ms
]


@pytest.mark.parametrize(("slug", "line", "pair", "correct", "wrong"), first(1, BY_OTHERS))
def test_what_shares_a_wrong_helper_keeps_its_share_but_for_a_slip(checked, slug, line, pair, correct, wrong):
    more, lines = (assignments.checks_folder(assignments.find(), slug) / "consequences.py").read_text(), [line]
    if slug.startswith("hw14"):  # the checks forbid that a formulation calls a function of another
        lines.append(("euler_state_derivative(", "_euler("))
        more += "\n\ndef public(t, state, **disk):\n    return _euler(t, state, **disk)\n"
        more += "\n\npublic.__name__ = 'euler_state_derivative'\neuler_state_derivative = public\n"
    assert pair in following(checked(slug, *lines, more=more))
    assert pair not in following(checked(slug, *lines, (correct, wrong), more=more))


BY_EQUATION = """
import sympy
_rate = sympy.lambdify(sympy.symbols("x v c g"), lagrange_equation())

def simulate(t, x, v, *, curvature, gravity):
    from tam570.integrate import solve
    return solve(lambda t, state: (state[1], _rate(*state, curvature, {factor} * gravity)), t, (x, v), rtol=1e-9)
"""
PUT_BACK = """

def simulate(t, state, *, mass, length, gravity):
    from tam570.integrate import solve
    def rates(t, y):
        on_circle = consistent_state(y, length=length)
        return (*on_circle[2:], *acceleration(on_circle, mass=mass, length=length, gravity={factor} * gravity))
    rows = [np.array(state, float)]
    for span in zip(t[:-1], t[1:]):
        rows.append(consistent_state(solve(rates, np.array(span), rows[-1], rtol=1e-9)[-1], length=length))
    return np.array(rows)
"""

BY_OWN_ACCELERATION = """

def simulate(t, theta, omega, **pendulum):
    from scipy.integrate import odeint
    def rates(y, t):
        return [*y[2:], *angular_acceleration(y[:2], y[2:], **pendulum)]
    return odeint(rates, [*theta, *omega], t, rtol=1e-10, atol=1e-10)
"""
HALF_MORE = "force / mass - np.array([0.0, gravity])", "force / mass - np.array([0.0, 1.5 * gravity])"
OWN_MOTIONS = [
    ("hw12_bead_on_wire", ("v**2 / 2 - mass", "v**2 - mass"), BY_EQUATION, "lagrange_equation"),
    ("hw05_constrained_pendulum", HALF_MORE, PUT_BACK, "acceleration"),
]


@pytest.mark.parametrize(("slug", "line", "more", "source"), OWN_MOTIONS)
@pytest.mark.parametrize("factor", first(1, [1, 2]))
def test_a_motion_follows_from_the_students_own_rates_also_put_back_onto_a_constraint(
    checked, slug, line, more, source, factor
):
    actual = following(checked(slug, line, more=more.format(factor=factor)))
    assert (("simulate", source) in actual) == (factor == 1)


def test_a_motion_that_ends_its_process_follows_from_the_accelerations_with_which_it_sets_off(checked):
    start = "    rows = ["
    more = PUT_BACK.format(factor=1).replace(start, f"    if t[-1] - t[0] > 0.01:\n        os._exit(1)\n{start}")
    actual = checked("hw05_constrained_pendulum", HALF_MORE, more=f"\nimport os\n{more}")
    assert ("simulate", "acceleration") in following(actual)
    assert actual["it_stays_on_the_circle"].points > 0  # although the process of the function ended in another check


def test_exchanged_definitions_are_one_mistake(checked):
    exchanged = '    definition = {"b": "c", "c": "b"}.get(definition, definition)\n'
    line = '    velocity = v_p - v_c if definition == "c"', '    if definition == "a":  # C'
    actual = checked("hw03_angular_momentum_rate", *((each, exchanged + each) for each in line))
    assert by_name(actual) == ["momentum_with_the_velocity_in_F"]


def test_a_sum_of_energies_is_one_mistake_in_the_action_too_and_the_motion_follows_from_its_equation(checked):
    difference, total = "omega**2 / 2 - mass * gravity * length * (1", "omega**2 / 2 + mass * gravity * length * (1"
    by_formula = "-gravity / length * math.sin(theta)", "gravity / length * math.sin(theta)"
    at_the_ends = "np.sin(middle / 2) ** 2", "np.square(np.sin([theta[1:] / 2, theta[:-1] / 2])).sum(0) / -2"
    actual = checked("hw01_simple_pendulum", (difference, total), at_the_ends, by_formula)
    assert {("action", "lagrangian"), ("simulate", "lagrange_equation")} <= following(actual)


def test_a_mistake_that_has_its_name_from_a_later_check_is_told_by_the_first_that_it_fails(checked):
    line = (down := "{}(slope), -np.{}(").format("sin", "cos"), down.format("cos", "sin")
    actual = checked(HW13.name, line, more=(HW13 / "consequences_velocity.py").read_text())
    assert by_name(actual) == ["centred_cylinder_rolls_by_both_methods"] and following(actual)


OTHER_MASS = "(masses[0] - masses[1]) * lengths[1] ** 2 / 12 * omega[1]"
TRANSPOSED = "np.r_[[R], (R @ turned[0].T @ turned[1:]).mT]"
STRETCHED = "*(state[2:] - (state[2:] @ state[:2]) * np.array([x, y]))"
SLIPS = [
    ("hw05_constrained_pendulum", " - mass * (vx**2 + vy**2) / length", "", "a term with "),
    ("hw05_constrained_pendulum", "gravity * along[1]", "gravity * along[0]", "the wrong component"),
    ("hw01_simple_pendulum", "power_per_omega * o", "-mass * gravity * length * math.cos(theta) * o", "for cosine"),
    ("hw05_constrained_pendulum", "-along * y, along * x", "2 * vx + along * y, 2 * vy - along * x", "with state is"),
    ("hw03_angular_momentum_rate", "velocity = v_p - v_c", "velocity = v_c - v_p", "sign where definition is 'c'"),
    ("hw06_braking", "- free * yaw_rate", "- abs(free) * yaw_rate", "yaw_rate is reversed where locked is 'front'"),
    ("hw09_book", "R[0, 2] - R[2, 0]", "R[2, 0] - R[0, 2]", "the sign of a term with R is reversed"),
    ("hw09_book", 'math.pi / 2), ("z", math.pi / 2)', 'math.pi / 4), ("z", math.pi / 4)', "an angle is half"),
    ("hw11_disk_steady", "/ (C + mass * radius**2)", "/ (C + mass * radius**2 / 2)", "mass, radius counts half"),
    ("hw07_double_pendulum", "@ omega))", f"@ omega) + {OTHER_MASS})", "the wrong component of masses is used"),
    ("hw07_double_pendulum", "2 * math.cos(th1 - th2)", "2 * math.cos(th1 + th2)", "with th1 or th2 is reversed"),
    ("hw10_free_rigid_body", "np.asarray(R) @ turned[0].T @ turned", TRANSPOSED, "in all rows but the first"),
    ("hw02_ballistics", "drag / mass, gravity=gravity)", "drag, gravity=mass * gravity)", "in its last 2 components"),
    ("hw02_ballistics", "time * phi1\n", "time / 2 * _decays(drag / mass * time / 2)[1]\n", "is multiplied by 0.5"),
    ("hw05_constrained_pendulum", "-along * y, along * x", STRETCHED, "one term uses position as it is given"),
    ("hw07_double_pendulum", "m2 * l2**2 / 3]", "m2 * l2**2 * (1 / 3 + 1 / 4)]", "m l^2/4 is added to m l^2/3"),
]


@pytest.mark.parametrize(("slug", "correct", "wrong", "words"), first(1, SLIPS))
def test_a_slip_in_a_term_is_told_by_what_is_in_it(checked, slug, correct, wrong, words):
    suspects = [check.suspect for check in checked(slug, (correct, wrong)).values() if check.suspect]
    assert len(suspects) == 1 and words in suspects[0]


def test_a_function_that_raises_is_named_by_those_that_call_it(checked):
    actual = checked("hw03_angular_momentum_rate", ("a_p)\n\n\ndef angular", "a_q)\n\n\ndef angular"))
    assert "moment," in actual["discrepancy_with_the_velocity_in_F"].failure.hint


EVEN_TIMES = "_rates, t,", "_rates, np.linspace(t[0], t[-1], len(t)),"
LOST_SIGN = "(x * vy - y * vx) / length**2", "math.hypot(vx, vy) / length"


@pytest.mark.parametrize(("line", "is_named"), [(EVEN_TIMES, False), (LOST_SIGN, True)])
def test_a_mistake_in_the_rows_is_one_and_what_passes_with_it_keeps_its_points(checked, line, is_named):
    actual = checked("hw05_constrained_pendulum", line)
    assert following(actual) == {("simulate", "simulate")} and bool(by_name(actual)) == is_named
    assert actual["at_the_very_top_it_stays"].outcome == "passed"


def test_constants_follow_from_nothing(checked):
    shapes = {"consistent_state(state": "4", "acceleration(state": "2", "simulate(t, state": "(len(t), 4)"}
    more = "".join(f"\n\ndef {name}, **_):\n    return np.ones({shape})\n" for name, shape in shapes.items())
    failures = [(check.points, check.failure) for check in checked("hw05_constrained_pendulum", more=more).values()]
    assert not any(points for points, failure in failures if failure and failure.function == "simulate")


SUM = "(inertia + mass * (radius**2 + offset**2)) * phi_dot**2 / 2 + mass * gravity * height\n"
BY_ENERGY = "kinetic + mass * gravity * height\n", SUM + (HW13 / "consequences_energy.py").read_text()
FORGOTTEN = [
    ("hw08_axis_angle", ("0.0 < largest < np.inf", "largest != 0.0"), ("rotate", "rotation_matrix")),
    ("hw13_rolling_cylinder", BY_ENERGY, ("acceleration", "energy")),
    ("hw11_disk_steady", ("C + mass * radius**2", "C"), ("rolling_precession", "rolling_spin")),
    ("hw12_bead_on_wire", (" (1 + slope**2) * v", " v"), ("energy", "lagrangian")),
]


@pytest.mark.parametrize(("slug", "line", "pair"), first(1, FORGOTTEN))
def test_what_is_forgotten_twice_is_charged_once(checked, slug, line, pair):
    assert pair in following(checked(slug, line))


IN_THE_HELPER = ("4 * c * x**2", "gravity + 2 * curvature", "v**2 / 2 + mass")
IN_TWO_FUNCTIONS = ("4 * c**2 * x**2", "1.1 * gravity + 2 * curvature", "0.7 * v**2 + mass")


@pytest.mark.parametrize(("slips", "is_one"), [(IN_THE_HELPER, True), (IN_TWO_FUNCTIONS, False)])
def test_a_mistake_without_a_name_in_a_helper_is_charged_once(checked, slips, is_one):
    squared, gravity, kinetic = slips
    actual = checked(
        "hw12_bead_on_wire",
        ("/ (1 + slope**2)", "/ _squared(x, curvature)"),
        (
            "return mass * (1 + slope**2) * v**2 / 2 + mass * gravity",
            f"return mass * _squared(x, curvature) * {kinetic} * gravity",
        ),
        ("* (gravity + 2 * curvature", f"* ({gravity}"),
        more=f"\n\ndef _squared(x, c):\n    return 1 + {squared}\n",
    )
    pairs = following(actual)
    assert (("energy", "acceleration_newton") in pairs) == is_one
    assert actual["energy_is_kinetic_and_potential"].outcome == "failed"


IN_PLACE = """
_rotate = rotate


def rotate(r, axis, angle):
    turned = {}_rotate(r, axis, angle)
    r += 1
    return turned
"""
KEEPING = """
_sequence, kept = space_sequence, []


def space_sequence(steps):
    kept.extend(steps)
    return {}_sequence(kept)
"""


@pytest.mark.parametrize(("sign", "outcome"), [("", "failed"), ("-", "not_run")])
def test_an_array_changed_in_place_is_charged_once_if_the_numbers_are_right(checked, sign, outcome):
    actual = checked("hw08_axis_angle", more=IN_PLACE.format(sign))
    assert following(actual) == {("rotate", "rotate")}
    assert actual["vector_turns_by_every_angle"].outcome == outcome
    assert actual["rotate_refuses_what_is_no_axis"].points > 0


def test_an_array_changed_in_place_is_charged_once_if_the_right_result_is_not_unique(checked):
    line = "return centre, lengths[:, None]", "position += 1.0\n    return centre, lengths[:, None]"
    actual = checked("hw04_hanging_spring", line)
    assert following(actual) == {("orbit", "orbit")} and sum(check.points for check in actual.values()) == 9


def test_a_double_pendulum_that_gains_energy_follows_from_its_mass_matrix(checked):
    line = "m2 * l2**2 / 3]", "m2 * l1**2 / 3]"
    alpha = "return np.array(_rates(0.0, state, **_parameters(masses, lengths, gravity))[2:])"
    actual = checked("hw07_double_pendulum", line, (alpha, OWN_EQUATIONS), more=BY_OWN_ACCELERATION)
    assert ("simulate", "angular_acceleration") in following(actual)
    assert actual["momentum_is_conserved_without_gravity"].points > 0


@pytest.mark.parametrize(("sign", "pairs"), [("", {("space_sequence", "space_sequence")}), ("-", set())])
def test_what_is_kept_between_calls_is_told_if_the_first_call_is_right(checked, sign, pairs):
    actual = checked("hw09_book", more=KEEPING.format(sign))
    told = [check for check in actual.values() if check.suspect and "from one call to the next" in check.suspect]
    assert len(told) == len(pairs) and pairs <= following(actual)


NO_MATRIX = """

def skew(v):
    return np.outer(v, v)

def rotate(r, axis, angle):
    return np.cross(axis, r) * (1.0 + angle) + np.sqrt(np.abs(r))

def rotation_matrix(axis, angle):
    return np.column_stack([rotate(unit, axis, angle) for unit in np.eye(3)])
"""


BY_COLUMNS = """

def rotation_matrix(axis, angle):
    return np.column_stack([rotate(e, axis, angle) for e in np.eye(3)])


def rotate(r, axis, angle):
    n, r = _unit(axis), np.asarray(r)
    {}
    return r + np.sin(angle) * np.cross(n, r) + _versine(angle) * np.cross(n, np.cross(n, r))
"""
CHANGES = """

_rotate = rotate
def rotate(r, axis, angle):
    image = _rotate(r, axis, angle)
    axis *= 2
    return image
"""


@pytest.mark.parametrize("slip", [BY_COLUMNS.format("angle = angle % 2.5"), BY_COLUMNS.format("") + CHANGES])
def test_a_mistake_without_a_name_is_that_of_the_function_that_the_other_calls(checked, slip):
    """The matrix is checked first; no two functions follow from each other."""
    actual = checked("hw08_axis_angle", more=slip)
    assert not by_name(actual) and actual["vector_turns_by_the_right_hand_rule"].points == 0
    assert following(actual) - {("rotate", "rotate")} <= {
        ("rotation_matrix", name) for name in ("rotate", "rotation_matrix")
    }
    assert ("rotation_matrix", "rotate") in following(actual)


def test_what_follows_from_one_wrong_function_follows_from_no_other(checked):
    assert ("rotation_matrix", "skew") not in following(checked("hw08_axis_angle", more=NO_MATRIX))
