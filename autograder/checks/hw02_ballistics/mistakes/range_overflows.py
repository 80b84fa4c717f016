"""The range has e^s/e^s in it, which is infinity over infinity with great drag.

fails: range_with_hardly_any_drag
names: NaN or infinity for great drag
"""

def horizontal_range(speed, angle, *, mass, drag, gravity):
    time = flight_time(speed, angle, mass=mass, drag=drag, gravity=gravity)
    s = drag * time / mass
    with np.errstate(all="ignore"):
        return speed * math.cos(angle) * time * (np.expm1(s) / (s * np.exp(s)) if s else 1.0)
