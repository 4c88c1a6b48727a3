"""Chrono: one step of ChSystemNSC, at the contacts of whole shapes on a floor; pushes are added to velocities before it. Not asked
where the answers were recorded: written by its documentation, version 9."""

import pychrono as chrono
from adapter import inertia, motion, on_floor, run


def vector(v):
    return chrono.ChVector3d(*v)


def pushed(body, step):
    """Velocity and spin, with what forces and couples add to them in a step."""
    turning = [sum(a * b for a, b in zip(row, body["torque"])) for row in inertia(body, invert=True)]
    velocity = [v + step * f / body["mass"] for v, f in zip(body["velocity"], body["force"])]
    return velocity, [w + step * t for w, t in zip(body["spin"], turning)]


def ask(line):
    world, body = on_floor(line)
    contact, step = world["contacts"][0], line["ask"]["step"]
    system = chrono.ChSystemNSC()
    system.SetCollisionSystemType(chrono.ChCollisionSystem.Type_BULLET)
    system.SetGravitationalAcceleration(vector(world["gravity"]))
    iterations = line["ask"]["iterations"]
    if iterations:
        system.GetSolver().AsIterative().SetMaxIterations(iterations)
        system.GetSolver().AsIterative().SetTolerance(0)
    rubs = chrono.ChContactMaterialNSC()
    rubs.SetFriction(contact["friction"])
    rubs.SetRestitution(contact["restitution"])
    size = 100 * world["size"]
    floor, one = chrono.ChBody(), chrono.ChBody()
    floor.SetFixed(True)
    floor.AddCollisionShape(chrono.ChCollisionShapeBox(rubs, size, size, size), chrono.ChFramed(vector([0, 0, -size / 2])))
    for shape in world["shapes"]:
        made = (chrono.ChCollisionShapeBox(rubs, *shape["box"]) if "box" in shape
                else chrono.ChCollisionShapeSphere(rubs, shape["sphere"]))
        one.AddCollisionShape(made, chrono.ChFramed(vector(shape["at"]), chrono.ChQuaterniond(*shape["turn"])))
    moments = inertia(body)
    one.SetMass(body["mass"])
    one.SetInertiaXX(vector(moments[i][i] for i in range(3)))
    one.SetInertiaXY(vector([moments[0][1], moments[0][2], moments[1][2]]))
    one.SetPos(vector(body["at"]))
    velocity, spin = pushed(body, step)
    one.SetPosDt(vector(velocity))
    one.SetAngVelParent(vector(spin))
    for each in (floor, one):
        each.EnableCollision(True)
        system.AddBody(each)
    system.DoStepDynamics(step)
    v, w = one.GetPosDt(), one.GetAngVelParent()
    return motion(line, body, [v.x, v.y, v.z, w.x, w.y, w.z]), None, {"iterations": iterations, "step": step}


run("chrono", "documented 9", "associated, by sweeps: what slides also opens; at the contacts of whole shapes", ask)
