"""Capital letters are accepted; they should be refused.

fails: momentum_refuses_other_definitions, rate_refuses_other_definitions, discrepancy_refuses_other_definitions, special_motion_refuses_other_definitions
names: does not raise ValueError for the definition
"""

def _lenient(function):
    return lambda definition, *state, **mass: function(definition.lower(), *state, **mass)


angular_momentum, rate, discrepancy, special_motion = map(
    _lenient, (angular_momentum, rate, discrepancy, special_motion)
)
