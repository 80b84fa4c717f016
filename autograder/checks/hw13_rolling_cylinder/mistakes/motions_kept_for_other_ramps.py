"""A motion is kept by its start and times, whatever the cylinder and the ramp.

fails: simulate_needs_no_dense_times
"""

_simulate, _kept = simulate, {}


def simulate(t, phi, phi_dot, **cylinder):
    if (key := (phi, phi_dot, *t)) not in _kept:
        _kept[key] = _simulate(t, phi, phi_dot, **cylinder)
    return _kept[key]
