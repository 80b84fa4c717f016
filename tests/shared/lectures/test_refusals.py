"""Functions of the lectures refuse impossible arguments with a ValueError that names the argument."""

import inspect
import math

import numpy as np
import pytest

from tam570.lectures import collisions, load, planet

NAN, INF, UNIT, TRIAD = math.nan, math.inf, np.eye(2), np.eye(3)
SKEWED, LOPSIDED = TRIAD + np.diag([1e-3, 0], 1), [[1, 2], [0, 1]]
EARTH = dict(length=1.0, gravity=9.81, latitude=0.7, spin=0.1)
BARS = [((0, 9),), ((1, 1),), ((0, 1.5),), ((-1, 0),), (0, 1), ((0, 1, 2),)]
CAR = dict.fromkeys(("height", "front", "rear", "friction", "gravity"), [-1.0, NAN])
MEETING = dict(velocities=[[1, 0, 0], [-1, 0, 0]], normal=[1, 0], arms=np.zeros((2, 2)), restitution=0.5)
COLLIDING = dict(masses=(1.0, 1.0), inertias=(1.0, 1.0), **MEETING)
NO_SHOCK = dict(normal=[[0, 0]], masses=[(0, 1), (INF, INF)], inertias=[(1, NAN)], restitution=[1.1], arms=[[0, 0]])
ROD = dict(stiffnesses=(1.0, 1.0), mass=1.3, inertia=0.2, arms=(-0.5, 0.3), speed=0.8)
SPINNING = dict(axial=2.0, transverse=1.0, spin=3.0, wobble=1.0)
SWING = dict(duration=1.0, length=0.8, gravity=9.81)
TOP = dict(mass=0.8, distance=0.3, axial=0.02, transverse=0.09, gravity=9.81)
UNBOUND = [(1, 0, 0, x, y, 0) for x, y in ((0, 1.5), (0, math.sqrt(2.0)), (0.5, 0), (0, 0))]
VECTORS = [[1, 2], [INF, 0, 0], [[0] * 3]]
# (functions, arguments in addition to the lecture's example, {argument: values that are refused}).
REFUSALS = [
    ("rod.by_constraint rod.by_elimination", dict(forces=(3, -1), masses=(1, 1)), dict(forces=[(3,)])),
    ("rod.by_constraint rod.by_elimination", dict(forces=(3, -1)), dict(masses=[(0, 0), (-1, 2), (1, NAN), (1,)])),
    ("truss.rates", {}, dict(bars=BARS, lengths=[(1.0, 1.0)])),
    ("stopping_car.by_centre_of_mass", {}, dict(locked=["left"], **CAR)),
    ("stopping_car.by_three_points stopping_car.by_one_point", {}, dict(locked=["left"], **CAR)),
    ("swinging_bar.exact", dict(state=(0.5, 0.0)), dict(state=[(0.5, 0.1)])),
    ("quadratic_drag.terminal_speed", {}, dict(drag=[0.0])),
    ("quadratic_drag.hodograph", {}, dict(gravity=[0.0])),
    ("quadratic_drag.rates", {}, dict(drag=[-0.1])),
    ("planet.exact", {}, dict(state=UNBOUND)),
    ("planet.elements", {}, dict(state=[(0, 0, 0, 1, 0, 0)])),
    ("bodies.rates", dict(state=(0.0,) * 18, masses=(1, 1, 1)), dict(masses=[(1, 0, 1)])),
    ("frames.foucault", EARTH, dict(length=[0.0], gravity=[-1.0], latitude=[NAN], spin=[INF])),
    ("frames.to_space", {}, dict(state=[[1, 2, 3]], t=[[0.0, 1.0]])),
    ("rigid_kinematics.velocity", dict(v_a=[0] * 3, omega=[1, 2, 3], arm=[0] * 3), dict(omega=[[1, 2]])),
    ("many.kinetic", dict(state=np.zeros(12), masses=[1, 1]), dict(masses=[[1, 0], []], state=[np.zeros(13)])),
    ("many.balances", dict(state=np.zeros(6), forces=np.zeros((1, 1, 3)), masses=[1]), dict(forces=[[[[1, 1, 1]]]])),
    ("inertia.principal", dict(I=TRIAD), dict(I=[np.diag([1, 1, 3]), np.diag([-1, 1, 1]), SKEWED, UNIT])),
    ("inertia.inertia", dict(points=TRIAD[:2], masses=[1, 1]), dict(masses=[[1, 0]], points=[TRIAD])),
    ("inertia.of_box", dict(mass=1, size=[1, 1, 1]), dict(size=[[1, 0, 1]])),
    ("inertia.of_disk", dict(mass=1, radius=1), dict(radius=[-1])),
    ("gimbals.rings", dict(angles=[1, 2, 3], sequence="313"), dict(sequence=["123"], angles=[[1, 2], [1, 2, NAN]])),
    ("gimbals.angular_velocity", dict(angles=[1, 2, 3], rates=[1, 2, 3], sequence="313"), dict(rates=[[1, 2]])),
    ("gimbals.euler_rates", dict(angles=[1, 2, 3], omega=[1, 2, 3], sequence="313"), dict(omega=[[1, INF, 2]])),
    ("cones.body_cone", SPINNING, dict(axial=[0.0], transverse=[0.0])),
    ("cones.body_cone", dict(SPINNING, spin=0.0), dict(wobble=[0.0])),
    ("bearings.moment", dict(spin=1, spin_rate=1), dict(inertia=[UNIT, SKEWED, NAN * TRIAD], spin_rate=[INF])),
    ("drifting_matrix.rates wrong_coordinates.rates", {}, dict(inertia=[(1, 0, 2), (1, 2), (1, NAN, 1)])),
    ("rocket.rates rocket.wrong_rates rocket.exact", {}, dict(burn_rate=[0], empty_mass=[0], exhaust_speed=[-1])),
    ("rocket.exact", {}, dict(state=[[0, 1, 0]])),
    ("chains.lifted chains.poured", dict(height=1, fallen=1, speed=1, density=1), dict(supplied=[-0.1, 1.5, NAN])),
    ("chains.lifted", dict(height=1, speed=1), dict(density=[0])),
    ("chains.poured", dict(density=1, fallen=1), dict(fallen=[-1], gravity=[-9.81])),
    ("chains.folded", dict(fallen=0, speed=1, length=2), dict(fallen=[2.0, 2.5, -0.1, NAN], length=[0])),
    ("modes.modes", dict(mass=UNIT, stiffness=UNIT), dict(mass=[LOPSIDED, np.diag([1, -1]), 0 * UNIT])),
    ("modes.modes", dict(mass=UNIT, stiffness=UNIT), dict(stiffness=[LOPSIDED, TRIAD, NAN * UNIT])),
    ("modes.chain", dict(n=2, mass=1, stiffness=1), dict(n=[0, 2.5, -1])),
    ("collisions.collide", COLLIDING, dict(velocities=[[[1, 0, 0]]], **NO_SHOCK)),
    ("string.by_newton string.by_lagrange", {}, dict(state=[(0, 0, 1, 1), (-1, 0, 0, 1)])),
    ("string.by_newton string.by_lagrange", {}, dict(masses=[(1, 0), (1,), (1, INF)])),
    ("top.sleeps top.steady_precession", dict(tilt=1.0, spin=90.0, **TOP), dict.fromkeys(list(TOP)[:4], [0.0])),
    ("top.steady_precession", dict(tilt=math.pi / 2, **TOP, spin=90.0), dict(spin=[0.0])),
    ("top.classic_precession", dict(spin=90.0, **TOP), dict(spin=[0.0])),
    ("surface.rates", {}, dict(surface=["cone"])),
    ("convergence.errors", dict(method="Euler", steps=[0.01]), dict(method=["midpoint", "", None])),
    (
        "convergence.errors",
        dict(method="Euler", steps=[0.01]),
        dict(steps=[[0.0], [-0.1], [1e-9], [2.0], [[0.1]], [NAN]]),
    ),
    ("stiff_impact.rebound", dict(speed=1), dict(mass=[0], speed=[0], gravity=[-1], stiffness=[0])),
    ("stiff_impact.two_contacts", ROD, dict(inertia=[0], arms=[(1,)], speed=[NAN], stiffnesses=[(1, 0)])),
    ("dyads.rotation", dict(before=TRIAD, after=TRIAD), dict(before=[SKEWED], after=[-TRIAD])),
    ("dyads.nine", dict(R=TRIAD, triad=TRIAD), dict(triad=[SKEWED], R=[UNIT])),
    ("dyads.dyad", dict(a=[1, 0, 0], b=[1, 0, 0]), dict(b=[[1, 2], [1, 2, NAN], "abc"])),
    ("sphere.compose", dict(first=[0] * 3, second=[0] * 3), dict(first=VECTORS, second=VECTORS)),
    ("least_action.path", dict(a=0.1, b=0.2, points=11, **SWING), dict(points=[1, 2.5], length=[0], duration=[0])),
    ("least_action.action", dict(path=[0.1, 0.2], **SWING), dict(path=[[[0.1, 0.2]]])),
]


@pytest.mark.parametrize(("functions", "arguments", "refused"), REFUSALS, ids=[functions for functions, *_ in REFUSALS])
def test_what_cannot_be_is_refused_by_name(functions, arguments, refused):
    for module, name in (function.split(".") for function in functions.split()):
        lecture, function = load(module), getattr(load(module), name)
        example = {"t": [0.0, 1.0] if name == "exact" else 0.0, "state": getattr(lecture, "START", None)}
        offered = {**example, **lecture.EXAMPLE, **arguments}
        accepted = {each: offered[each] for each in inspect.signature(function).parameters if each in offered}
        function(**accepted)
        for argument, value in ((argument, value) for argument, values in refused.items() for value in values):
            with pytest.raises(ValueError, match=rf"\b{argument}\b"):
                function(**{**accepted, argument: value})


def test_bodies_that_separate_do_not_collide():
    with pytest.raises(ValueError, match="separate"):
        collisions.collide(**{**COLLIDING, "velocities": [[-1, 0, 0], [1, 0, 0]]})
    same, impulse = collisions.collide(**{**COLLIDING, "velocities": [[1, 2, 0], [1, -3, 0]]})
    assert impulse == 0.0 and same.tolist() == [[1, 2, 0], [1, -3, 0]]


def test_at_the_sun_there_is_no_acceleration():
    assert math.isnan(planet.rates(0.0, (0.0, 0.0, 0.0, 1.0, 0.0, 0.0), gm=1.0)[3])
