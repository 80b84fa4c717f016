"""hw07 takes [M], {f} and {g} of any two independent equations of motion, and fails the one that is wrong."""

import pytest

SLUG = "hw07_double_pendulum"
CHECKS = {
    "M": "mass_matrix_makes_the_kinetic_energy",
    "f": "velocity_terms_are_centripetal",
    "g": "gravity_terms_are_moments_of_the_weights",
}
COMBINED = """
lagranges = mass_matrix, velocity_terms, gravity_terms

def W(theta):
    return np.array({W})

def mass_matrix(theta, **known):
    return ({M}) @ lagranges[0](theta, **known)

def velocity_terms(theta, omega, **known):
    return ({f}) @ lagranges[1](theta, omega, **known)

def gravity_terms(theta, **known):
    return ({g}) @ lagranges[2](theta, **known)
"""
EQUATIONS = {
    "about the ceiling and the elbow": "[[1, 1], [0, 1]]",
    "about the elbow and the ceiling": "[[0, 1], [1, 1]]",
    "their sum and a scaled row of the other side": "[[1, 2], [0, -1e-3]]",
    "combined by the angles": "[[2 + math.sin(theta[0]), 1], [math.cos(theta[1]), -3]]",
    "Lagrange's": "[[1, 0], [0, 1]]",
}


@pytest.fixture
def failed(grade, solution_text):
    def failed(W, **changed):
        factors = dict.fromkeys("Mfg", "W(theta)") | changed
        result = grade(SLUG, solution_text(SLUG) + COMBINED.format(W=W, **factors), naming=False)
        lost = {check.name for check in result.checks if check.outcome == "failed"}
        return {term for term, name in CHECKS.items() if name in lost}

    return failed


@pytest.mark.parametrize("W", EQUATIONS.values(), ids=EQUATIONS)
def test_any_two_independent_equations_are_right_and_the_wrong_term_alone_fails(W, failed):
    assert failed(W) == set()
    for term in CHECKS:
        assert failed(W, **{term: "W(theta) @ [[1, 0], [0.01, 1]]"}) == {term}


def test_one_equation_twice_is_wrong(failed):
    assert failed("[[1, 1], [2, 2]]") == set(CHECKS)


def test_lagranges_mass_matrix_does_not_belong_to_terms_of_the_other_side(failed):
    assert failed("np.eye(2)", f="-W(theta)", g="-W(theta)") == {"f", "g"}


def test_lagranges_term_is_right_and_those_of_other_equations_contradict_it(failed):
    assert failed("[[1, 1], [0, 1]]", M="np.eye(2)") == {"f", "g"}
