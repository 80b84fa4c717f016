"""Hidden inputs of hw03: positions, velocities and accelerations of P and C, random and plain ones."""

import numpy as np

from tam570_grader import Case

NAMES = "r_p", "v_p", "a_p", "r_c", "v_c", "a_c"
# vectors that are zero together: P or C at the origin, at rest, without acceleration, fixed
ZERO = "r_p", "v_p", "v_c a_c", "a_p", "r_c v_c a_c"
LETTERS_ALIKE = "B", "ab", ""  # no definitions, but with a letter of one, or a part of their list


def motions(rng):
    """Return (state, mass) of random sizes; with zeros; P at C, P moving with C, integers."""
    random = [(rng.normal(size=(6, 3)) * rng.uniform(0.3, 3, (6, 1)), 10 ** rng.uniform(-1, 1)) for _ in range(2)]
    zero = [(rng.normal(size=(6, 3)) * [[name not in names.split()] for name in NAMES], 1.0) for names in ZERO]
    state = rng.normal(size=(6, 3))
    at_c, along = state.copy(), state.copy()
    at_c[0], along[1] = state[3], state[4]
    return [*random, *zero, (at_c, 2.0), (along, 2.0), (np.round(3 * state), 1.0)]


def label(state, what):
    """Return the label of a state: which of its vectors are zero, or which two are the same."""
    zero = [name for name, vector in zip(NAMES, state, strict=True) if not np.any(vector)]
    same = [k for k in (0, 1) if np.array_equal(state[k], state[k + 3]) and np.any(state[k])]
    zero += [f"{NAMES[k]} - {NAMES[k + 3]}" for k in same]
    return what + (f", {' and '.join(zero)} zero" if zero else "")


def moments(rng):
    return [Case(s[0], s[2], s[3], mass=mass).labelled(label(s, "random vectors")) for s, mass in motions(rng)]


def rates(rng, definitions, vectors=slice(None)):
    """Return the arguments of `rate` by these definitions; with fewer vectors, of another function."""
    return [
        Case(definition, *s[vectors], mass=mass).labelled(label(s, f"definition {definition}"))
        for definition in definitions
        for s, mass in motions(rng)
    ]


def momenta(rng, definitions):
    return rates(rng, definitions, [0, 1, 3, 4])


def letters(rng, cases_of):
    """Return the first of these cases by definition b, and the same call with strings that name no definition."""
    case = cases_of(rng, "b")[0]
    return [case, *(case.replace(name).labelled(f'the definition "{name}"') for name in ("d", *LETTERS_ALIKE))]
