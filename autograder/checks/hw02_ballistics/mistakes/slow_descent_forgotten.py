"""The search for the flight time ends at two hundred times m/c.

fails: flight_time_with_great_drag_and_straight_up
"""

sought_everywhere = flight_time


def flight_time(speed, angle, *, mass, drag, gravity):
    time = sought_everywhere(speed, angle, mass=mass, drag=drag, gravity=gravity)
    return min(time, 200 * mass / drag) if drag else time
