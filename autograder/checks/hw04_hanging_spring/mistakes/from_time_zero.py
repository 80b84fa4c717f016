"""The simulation starts at t = 0, whatever t[0] is.

fails: simulate_moves_as_it_must
suspect: taken for that at t = 0
"""

def simulate(t, position, velocity, **parameters):
    return solution(t, position, velocity, **parameters)
