"""The vertical motion lacks drag, which acts on both components.

fails: rates_are_newtons, simulation_follows_the_motion, trajectory_is_the_motion, flight_ends_at_launch_height, range_is_where_it_lands
also: The flight time lacks drag; with drag it is shorter
"""


def state_derivative(t, state, *, mass, drag, gravity):
    return np.array([state[2], state[3], -drag / mass * state[2], -gravity])


def trajectory(t, speed, angle, *, mass, drag, gravity):
    decay, phi1, _ = np.vectorize(_decays, otypes=[float] * 3)(drag / mass * t)
    vx, vy = speed * math.cos(angle), speed * math.sin(angle)
    return np.column_stack([vx * t * phi1, vy * t - gravity * t**2 / 2, vx * decay, vy - gravity * t])


def simulate(t, *launch, **known):
    return trajectory(t - t[0], *launch, **known)


def flight_time(speed, angle, *, mass, drag, gravity):
    return 2 * speed * math.sin(angle) / gravity


def plot_comparison(ax, t, speed, angle, *, mass, drag, gravity):
    t = t - t[0]
    s = drag / mass * t
    phi1, phi2 = -np.expm1(-s[1:]) / s[1:], (s[1:] + np.expm1(-s[1:])) / s[1:] ** 2
    x = np.append(0, speed * math.cos(angle) * t[1:] * phi1)
    y = np.append(0, speed * math.sin(angle) * t[1:] * phi1 - gravity * t[1:] ** 2 * phi2)
    ax.plot(x, y)
    ax.plot(x, y)
    ax.set(xlabel="x (m)", ylabel="y (m)", aspect="equal")
