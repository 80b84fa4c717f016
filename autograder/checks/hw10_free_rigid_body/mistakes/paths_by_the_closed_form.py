"""The paths show the wobble of a body with A = B, whatever B is.

fails: rim_paths_are_drawn
unnamed: the curves of another motion are compared with those of the right one alone
"""


def plot_rim_paths(ax, t, R, omega, *, inertia, radius):
    from scipy.spatial.transform import Rotation

    (A, _, C), H = inertia, R @ np.multiply(inertia, omega)
    since = np.subtract(t, t[0])[:, None]
    wobble, slip = (Rotation.from_rotvec(since * v).as_matrix() for v in (H / A, [0, 0, (1 - C / A) * omega[2]]))
    rotations = wobble @ R @ slip
    for axis in (0, 1):
        ax.plot(*radius * rotations[:, 1:, axis].T)
    ax.set(xlabel="y (m)", ylabel="z (m)", aspect="equal")
