"""Time and speed are scaled by m/c and m g/c, which are infinite without drag.

fails: simulation_without_drag_or_gravity
names: ZeroDivisionError for zero drag
"""


def simulate(t, speed, angle, *, mass, drag, gravity):
    time, terminal = mass / drag, mass * gravity / drag
    start = (0.0, 0.0, speed / terminal * math.cos(angle), speed / terminal * math.sin(angle))
    scaled = solve(_rates, t / time, start, parameters={"rate": 1.0, "gravity": 1.0}, rtol=1e-12)
    return scaled * [terminal * time, terminal * time, terminal, terminal]
