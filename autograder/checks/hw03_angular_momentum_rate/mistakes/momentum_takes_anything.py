"""Any letter but c is treated as a or b; it should be refused.

fails: momentum_refuses_other_definitions
names: does not raise ValueError for the definition
"""

def angular_momentum(definition, r_p, v_p, r_c, v_c, *, mass):
    return np.cross(r_p - r_c, mass * (v_p - v_c if definition == "c" else v_p))
