"""Laws of the lectures on bodies whose mass changes."""

import math

import numpy as np
import pytest

from tam570.integrate import solve
from tam570.lectures import chains, rocket

DRAW = np.random.default_rng(574)
BURN = {"burn_rate": 3.0, "exhaust_speed": 900.0, "empty_mass": 40.0, "gravity": 9.81}
START = [10.0, 20.0, 100.0]  # it burns for 20 s


def test_the_rocket_equation_holds_while_it_burns():
    _, v, m = rocket.exact(np.linspace(0.0, 20.0, 50), START, **BURN).T
    constant = v + 900.0 * np.log(m) - 9.81 * m / 3.0
    assert constant == pytest.approx(np.full(50, constant[0]), rel=1e-13)


def test_momentum_of_rocket_and_exhaust_together():
    """Without gravity; what left when the mass was m flies at v - u for ever."""
    _, v, m = solve(rocket.rates, np.linspace(0.0, 15.0, 4001), START, parameters={**BURN, "gravity": 0.0}).T
    thrown = np.concatenate([[0.0], np.cumsum(-np.diff(m) * ((v[1:] + v[:-1]) / 2 - 900.0))])
    together = m * v + thrown
    assert together == pytest.approx(np.full(4001, together[0]), abs=1e-6 * 900.0 * 60.0)  # the sum's steps squared


@pytest.mark.parametrize("begin", [0.0, 7.0])
def test_an_empty_tank_stops_the_burning(begin):
    times = begin + np.array([0.0, 5.0, 19.999, 20.0, 20.001, 30.0])
    exact, solved = rocket.exact(times, START, **BURN), solve(rocket.rates, times, START, parameters=BURN)
    assert exact[3:, 2].tolist() == [40.0, 40.0, 40.0]
    assert exact == pytest.approx(solved, rel=1e-8)
    assert exact[5, 1] == pytest.approx(exact[3, 1] - 9.81 * 10)
    after = rocket.exact([0.0, 10.0], exact[3], **BURN)[-1]
    assert after == pytest.approx(exact[5], rel=1e-13)  # a tank that is empty from the beginning
    assert rocket.rates(0.0, exact[3].tolist(), **BURN)[1:] == (-9.81, 0.0)


def test_an_empty_tank_has_no_rounding():
    for full, empty in zip(DRAW.uniform(2, 3, 50), DRAW.uniform(0.1, 2, 50), strict=True):
        left = rocket.exact([0.0, 100.0], [0.0, 0.0, full], **{**BURN, "empty_mass": empty})[-1, 2]
        assert left == empty


def test_its_energy_at_the_end_of_burning_is_known_all_the_time():
    states = rocket.exact(np.linspace(0.0, 40.0, 9), START, **BURN)
    energies = [rocket.coasting_energy(state, **BURN) for state in states]
    assert energies == pytest.approx([energies[0]] * 9, rel=1e-12)
    _, (height, speed, _) = rocket.exact([0.0, 20.0], START, **BURN)
    assert energies[0] == pytest.approx(speed**2 / 2 + 9.81 * height)


def test_the_wrong_rocket_conserves_its_own_momentum_and_differs():
    free = {**BURN, "gravity": 0.0}
    _, v, m = solve(rocket.wrong_rates, np.linspace(0.0, 15.0, 30), START, parameters=free).T
    assert m * v == pytest.approx(np.full(30, 100.0 * 20.0), rel=1e-9)
    assert abs(rocket.wrong_rates(0, START, **BURN)[1] - rocket.rates(0, START, **BURN)[1]) > 20
    assert rocket.wrong_rates(0, [0, 0, 100], **free)[1] == 0.0  # from rest it never starts


def test_the_rocket_refuses_by_name():
    for name, value in {"burn_rate": 0.0, "empty_mass": 0.0, "exhaust_speed": -1.0, "gravity": math.nan}.items():
        for function in (rocket.rates, rocket.wrong_rates):
            with pytest.raises(ValueError, match=name):
                function(0.0, START, **{**BURN, name: value})
        with pytest.raises(ValueError, match=name):
            rocket.exact([0.0, 1.0], START, **{**BURN, name: value})
    with pytest.raises(ValueError, match="mass"):
        rocket.exact([0.0, 1.0], [0.0, 1.0, 0.0], **BURN)
    assert rocket.rates(0.0, [0.0, 1.0, -5.0], **BURN) == (1.0, -9.81, 0.0)  # a trial step beyond the empty tank


def folded_energy(x, v, length, gravity):
    """J for a density of 1 kg/m, of each half by itself: its length, and where its middle hangs."""
    falling, hanging = (length - x) / 2, (length + x) / 2
    return falling * v**2 / 2 - gravity * (falling * (x + falling / 2) + hanging**2 / 2)


def test_the_folded_chain_keeps_energy_or_falls_freely():
    for _ in range(5):
        length, x, v, g = DRAW.uniform(1, 3), DRAW.uniform(0, 0.9), DRAW.uniform(0, 5), 9.81
        by_energy, inelastic = chains.folded(x, v, length=length, gravity=g)
        step = 1e-6
        rise = (folded_energy(x + step * v, v + step * by_energy, length, g) - folded_energy(x, v, length, g)) / step
        assert rise == pytest.approx(0.0, abs=1e-3) and inelastic == g
        assert by_energy == pytest.approx(g + v**2 / (2 * (length - x)))


def test_half_of_the_work_above_the_weight_is_lost_in_the_heap():
    """Lifted at a steady speed from 0 to y: the work, less what the chain has then."""
    y, v, density, g = 2.0, 3.0, 0.5, 9.81
    heights = np.linspace(0.0, y, 101)
    force = [chains.lifted(h, v, density=density, gravity=g) for h in heights]
    work = np.mean(force[:-1] + np.diff(force) / 2) * y  # the force is linear in the height
    gained = density * y * v**2 / 2 + density * g * y**2 / 2
    assert work - gained == pytest.approx(density * y * v**2 / 2)
    assert work - density * g * y**2 / 2 == pytest.approx(2 * (work - gained))


def test_the_scale_shows_the_weight_and_the_impact():
    x, density, g = 0.7, 0.4, 9.81
    impact = density * (2 * g * x)  # density v^2, links that stop at once
    assert chains.poured(x, density=density, gravity=g) == pytest.approx(density * g * x + impact)


@pytest.mark.parametrize("supplied", [0.0, 0.3, 0.5])
def test_what_the_heap_supplies_is_not_lost(supplied):
    """The power that lifts, less the rates of kinetic energy and of the weight's, is (1/2 - supplied) density v^3."""
    v, density, g = 3.0, 0.5, 9.81
    power = v * chains.lifted(1.2, v, density=density, gravity=g, supplied=supplied)
    assert power - density * v**3 / 2 - density * g * 1.2 * v == pytest.approx((0.5 - supplied) * density * v**3)


@pytest.mark.parametrize("supplied", [0.0, 0.3, 0.5])
def test_the_scale_bears_what_momentum_balance_of_the_whole_chain_leaves(supplied):
    """The part above falls by (length - x) v' = (length - x) g + supplied v^2; the reading is the weight less p'."""
    length, density, g = 2.0, 0.4, 9.81

    def fall(t, state):
        x, v = state
        return v, g + supplied * v * v / (length - x)

    times = np.linspace(0.0, 0.45, 901)
    x, v = solve(fall, times, [0.0, 0.0], rtol=1e-12).T
    momentum = density * (length - x) * v
    rate = (momentum[2:] - momentum[:-2]) / (times[2:] - times[:-2])
    known = {"density": density, "gravity": g, "supplied": supplied, "length": length}
    readings = [chains.poured(one, **known) for one in x[1:-1]]
    assert readings == pytest.approx(density * length * g - rate, abs=1e-4)
    long = chains.poured(0.3, density=density, gravity=g, supplied=supplied)
    assert long == pytest.approx((3 - 2 * supplied) * density * g * 0.3)
    assert chains.poured(0.3, **{**known, "length": 1e6}) == pytest.approx(long, rel=1e-5)


def test_chains_refuse_by_name():
    for wrong in (-0.1, 1.5, math.nan):
        with pytest.raises(ValueError, match="supplied"):
            chains.lifted(1.0, 1.0, density=1.0, gravity=9.81, supplied=wrong)
        with pytest.raises(ValueError, match="supplied"):
            chains.poured(1.0, density=1.0, gravity=9.81, supplied=wrong)
    for wrong in (2.0, 2.5, -0.1, math.nan):
        with pytest.raises(ValueError, match="fallen"):
            chains.folded(wrong, 1.0, length=2.0, gravity=9.81)
    with pytest.raises(ValueError, match="length"):
        chains.folded(0.0, 1.0, length=0.0, gravity=9.81)
    with pytest.raises(ValueError, match="density"):
        chains.lifted(1.0, 1.0, density=0.0, gravity=9.81)
    with pytest.raises(ValueError, match="fallen"):
        chains.poured(-1.0, density=1.0, gravity=9.81)
