"""A mistake in one function is told once, and what is right but for it keeps two thirds of its points."""

import pytest
from parameters import first

from tam570_grader.grading.one import FOLLOWING_SHARE


@pytest.fixture
def marks(grade, solution_text):
    """`marks(slug, line, wrong)` -> the results of the checks of the solution with a wrong line, by name."""

    def marks(slug, *lines):
        text = solution_text(slug)
        for right, wrong in lines:
            assert right in text
            text = text.replace(right, wrong)
        return {mark.name: mark for mark in grade(slug, text).checks}

    return marks


def following(marks):
    """What follows from what, by the names of functions; each has its share of the points."""
    failed = [mark for mark in marks.values() if mark.outcome == "failed" and mark.failure.follows_from]
    pairs = {(mark.failure.function, mark.failure.follows_from) for mark in failed}
    for mark in failed:
        share = 0 if mark.failure.function == mark.failure.follows_from else FOLLOWING_SHARE
        assert mark.points == pytest.approx(share * mark.max_points, abs=1e-6) and not mark.suspect
    return pairs


def named(marks):
    return [name for name, mark in marks.items() if mark.suspect]


def test_a_wrong_load_is_told_once_and_costs_a_third_of_what_it_carries(marks):
    right = "return mass * gravity * abs(free / arm)"
    found = marks("hw06_braking", (right, "return mass * gravity * front / (front + rear)"))
    assert named(found) == ["axle_load_balances_the_weight"]
    functions = "friction_force", "state_derivative", "simulate", "yaw_growth_rate", "small_yaw_rate", "axle_load"
    assert following(found) == {(name, "axle_load") for name in functions}
    whole = [name for name, mark in found.items() if mark.points == mark.max_points]
    assert "simulate_glides_without_friction" in whole  # judged though the one before it failed
    assert sum(mark.points for mark in found.values()) > 6.5


@pytest.mark.parametrize("wrong", first(1, ["m1 / 2", "m1 / 12"]))
def test_the_energy_follows_from_the_mass_matrix(marks, wrong):
    found = marks("hw07_double_pendulum", ("[[(m1 / 3 + m2)", f"[[({wrong} + m2)"))
    assert named(found) == ["mass_matrix_makes_the_kinetic_energy"]
    assert following(found) == {("energy", "mass_matrix"), ("angular_momentum", "mass_matrix")}


@pytest.mark.slow
def test_one_wrong_argument_in_all_functions_is_told_once(marks):
    found = marks(
        "hw13_rolling_cylinder",
        ("turned = inertia", "offset = -offset\n    turned = inertia"),
        ("return inertia + mass *", "offset = -offset\n    return inertia + mass *"),
        (
            "    return _weight_moment(phi, mass, radius, offset,",
            "    return _weight_moment(phi, mass, radius, -offset,",
        ),
        ("    return mass * radius * offset * math", "    return -mass * radius * offset * math"),
        ("c, s = math.cos(phi)", "offset = -offset\n    c, s = math.cos(phi)"),
        ("- offset * math.cos(phi + slope)\n    return kin", "+ offset * math.cos(phi + slope)\n    return kin"),
    )
    assert named(found) == ["acceleration_balances_momentum_about_G"]
    pairs = following(found)
    assert {cause for _, cause in pairs} == {"acceleration"} and len(pairs) == 6


def test_a_function_that_is_always_zero_makes_nothing_else_right(marks):
    found = marks("hw06_braking", ("return mass * gravity * abs(free / arm)", "return 0.0"))
    assert not following(found)
