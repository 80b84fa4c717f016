"""Known mistakes are named by the student's own numbers, and a wrong one is not."""

import pytest
from parameters import first

HW08 = {
    "rotation_matrix": {
        "kept(axis, angle).T": "The result of rotation_matrix is transposed.",
        "kept(axis, np.radians(angle))": "In rotation_matrix, angle is read as degrees.",
        "2 * kept(axis, angle)": "The result of rotation_matrix is twice as large as the right one.",
        "-kept(axis, angle)": "The result of rotation_matrix has the opposite sign.",
    },
    "skew": {"kept(v).T": "The result of skew has the opposite sign."},
}
CASES = [(name, body, remedy) for name, bodies in HW08.items() for body, remedy in bodies.items()]


def changed(hw08, name, body):
    arguments = {"skew": "v", "rotation_matrix": "axis, angle"}[name]
    return hw08(f"kept = {name}\n\n\ndef {name}({arguments}):\n    return {body}\n")


@pytest.mark.parametrize(("name", "body", "remedy"), CASES)
def test_a_known_mistake_is_named(hw08, tam570, name, body, remedy):
    changed(hw08, name, body)
    code, said = tam570("check")
    assert code == 1 and f"Your numbers match this mistake: {remedy}" in " ".join(said.split())


ORDER = "The results of power_balance are exchanged."
OTHERS = {
    "hw13_rolling_cylinder": (
        "energy",
        "kept(*args, **how) / how['mass']",
        "The result of energy should be multiplied by mass.",
    ),
    "hw07_double_pendulum": (
        "gravity_terms",
        "-kept(*args, **how)",
        "The result of gravity_terms has the opposite sign.",
    ),
    "hw01_simple_pendulum": ("power_balance", "kept(*args, **how)[::-1]", ORDER),
}


@pytest.mark.parametrize("slug", first(3, OTHERS))
def test_factors_signs_and_orders_are_named(desk, tam570, solution_text, slug):
    name, body, remedy = OTHERS[slug]
    text = f"{solution_text(slug)}\n\nkept = {name}\n\n\ndef {name}(*args, **how):\n    return {body}\n"
    (desk / f"{slug}.py").write_text(text)
    assert f"Your numbers match this mistake: {remedy}" in " ".join(tam570("check", f"{slug}.py")[1].split())


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


@pytest.mark.parametrize("above", first(1, CALLS))
def test_loose_tolerances_are_named(desk, tam570, solution_text, above):
    text = f"{solution_text('hw01_simple_pendulum')}\n\n{above}\n{CARELESS.format(call=CALLS[above])}"
    (desk / "hw01.py").write_text(text)
    said = " ".join(tam570("check", "hw01.py")[1].split())
    assert "It would pass with the tolerances rtol=1e-9, atol=1e-9 in simulate." in said
