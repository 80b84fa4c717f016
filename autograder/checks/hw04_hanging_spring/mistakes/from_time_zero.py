"""The given state taken for that at t = 0, where it is that at t[0].

fails: simulate_moves_as_it_must
also: the given state taken for that at t = 0, where it is that at t[0], and no times before 0
"""

def simulate(t, position, velocity, **parameters):
    return solution(t, position, velocity, **parameters)
