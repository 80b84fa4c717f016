"""The given state is taken at t = 0; it is the state at t[0].

fails: simulate_moves_as_it_must, the_path_is_drawn
names: at t = 0
"""

def simulate(t, position, velocity, **parameters):
    return solution(t, position, velocity, **parameters)
