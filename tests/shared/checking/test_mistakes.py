"""`check` names a known mistake if the student's numbers match it, and only then."""

import pytest
from parameters import first

HW08, HW10, HW13 = "hw08_axis_angle", "hw10_free_rigid_body", "hw13_rolling_cylinder"
NAMED = [  # (slug, function, expression that it returns instead, words that `check` prints)
    (HW08, "rotation_matrix", "kept(axis, angle).T", "Your result of rotation_matrix is transposed."),
    (HW08, "rotation_matrix", "kept(axis, np.radians(angle))", "In rotation_matrix, angle is read as degrees."),
    (HW13, "energy", "kept(*args, **how) / how['mass']", "should be multiplied by mass."),
    (HW13, "contact_inertia", "kept(phi, **{**how, 'offset': -how['offset']})", "sign, or offset has it"),
    ("hw01_simple_pendulum", "power_balance", "kept(*args, **how)[::-1]", "results of power_balance are exchanged."),
    ("hw07_double_pendulum", "gravity_terms", "-kept(*args, **how)", "gravity_terms has the opposite sign."),
    (HW08, "rotation_matrix", "2 * kept(axis, angle)", "rotation_matrix is twice as large as the right one."),
]
CARELESS = """

def simulate(t, theta0, omega0, *, length, gravity):
    def rates(t, y):
        return y[1], -gravity / length * np.sin(y[0])

    return {call}
"""
CALLS = {
    "from scipy.integrate import solve_ivp": "solve_ivp(rates, t[[0, -1]], [theta0, omega0], t_eval=t).y.T",
    "import scipy.integrate as si": "si.solve_ivp(rates, t[[0, -1]], [theta0, omega0], t_eval=t, rtol=1e-4).y.T",
    "from scipy import integrate": "integrate.odeint(rates, [theta0, omega0], t, tfirst=True, rtol=1e-4, atol=1e-4)",
}


def test_what_follows_from_a_mistake_in_another_function_is_no_mistake(desk, tam570, in_process, solution_text):
    slug = "hw03_angular_momentum_rate"
    arm_and_force = "np.cross(r_p - r_c, mass * a_p)"
    text = solution_text(slug).replace(arm_and_force, "moment(r_p, a_p, r_c, mass=mass)")
    text = text.replace("return moment(", f"return -{arm_and_force} #", 1)
    (desk / f"{slug}.py").write_text(text)
    said = " ".join(tam570("check", f"{slug}.py")[1].split())
    assert "moment has the opposite sign" in said and "rate uses or repeats the mistake in moment" in said
    assert "In rate, " not in said


@pytest.mark.parametrize(("slug", "name", "body", "remedy"), first(5, NAMED))
def test_a_known_mistake_is_named(desk, tam570, in_process, solution_text, slug, name, body, remedy):
    arguments = {"rotation_matrix": "axis, angle", "contact_inertia": "phi, **how"}.get(name, "*args, **how")
    changed = f"\n\nkept = {name}\n\n\ndef {name}({arguments}):\n    return {body}\n"
    (desk / f"{slug}.py").write_text(solution_text(slug) + changed)
    code, said = tam570("check", f"{slug}.py")
    assert code == 1 and "Your numbers match this mistake: " in said and remedy in " ".join(said.split())


HALVES = {
    "hw04_hanging_spring": ("velocity * np.sqrt(mass / stiffness)", "velocity"),
    HW08: ("* skew(n) @ r", "/ 2 * skew(n) @ r"),
}


@pytest.mark.parametrize("slug", HALVES)
def test_a_factor_two_that_other_numbers_refute_has_no_name(desk, tam570, in_process, solution_text, slug):
    (desk / f"{slug}.py").write_text(solution_text(slug).replace(*HALVES[slug]))
    code, said = tam570("check", f"{slug}.py")
    assert code == 1 and "twice" not in said and "half" not in said


@pytest.mark.parametrize("above", first(1, CALLS))
def test_loose_tolerances_are_named(desk, tam570, in_process, solution_text, above):
    text = f"{solution_text('hw01_simple_pendulum')}\n\n{above}\n{CARELESS.format(call=CALLS[above])}"
    (desk / "hw01.py").write_text(text)
    said = " ".join(tam570("check", "hw01.py")[1].split())
    assert "It would pass with the tolerances rtol=1e-9, atol=1e-9 in simulate." in said


def test_what_leaves_nothing_but_zeros_is_no_mistake(desk, tam570, in_process, solution_text):
    """Reversing omega changes only the wrong result, into a correct zero; that does not show that omega is wrong."""
    wrong = "\n\nkept = euler_equations\n\n\ndef euler_equations(omega, *, inertia):\n"
    wrong += "    return kept(omega, inertia=inertia) + (np.count_nonzero(omega) == 1 and omega[0] > 0)\n"
    (desk / f"{HW10}.py").write_text(solution_text(HW10) + wrong)
    test = "assert not hw.euler_equations(np.array([2.0, 0.0, 0.0]), inertia=np.array([1.0, 2.0, 3.0])).any()"
    mine = f"import numpy as np\nimport {HW10} as hw\n\n\ndef test_mine():\n    {test}\n"
    (desk / f"test_{HW10}.py").write_text(mine)
    code, said = tam570("check", f"{HW10}.py", "euler_equations")
    assert code == 1 and "match this mistake" not in said
