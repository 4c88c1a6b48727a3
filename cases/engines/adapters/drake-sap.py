"""Drake: one discrete step of MultibodyPlant with SAP, at the contacts of whole shapes on a floor. Not asked where the answers were
recorded: written by its documentation, version 1.30."""

import pydrake.all as drake
from adapter import Refused, inertia, motion, on_floor, run


def shape_of(shape):
    return drake.Box(*shape["box"]) if "box" in shape else drake.Sphere(shape["sphere"])


def ask(line):
    if "impact" in line:
        raise Refused("Drake has no restitution")
    world, body = on_floor(line)
    mu, step = world["contacts"][0]["friction"], line["ask"]["step"]
    builder = drake.DiagramBuilder()
    plant, _ = drake.AddMultibodyPlantSceneGraph(builder, time_step=step)
    plant.set_discrete_contact_approximation(drake.DiscreteContactApproximation.kSap)
    rubs = drake.CoulombFriction(static_friction=mu, dynamic_friction=mu)
    (xx, xy, xz), (_, yy, yz), (_, _, zz) = ([m / body["mass"] for m in row] for row in inertia(body))
    one = plant.AddRigidBody(name="body", M_BBo_B=drake.SpatialInertia(
        mass=body["mass"], p_PScm_E=[0, 0, 0], G_SP_E=drake.UnitInertia(Ixx=xx, Iyy=yy, Izz=zz, Ixy=xy, Ixz=xz, Iyz=yz)))
    plant.RegisterCollisionGeometry(plant.world_body(), drake.RigidTransform(), drake.HalfSpace(), "floor", rubs)
    for i, shape in enumerate(world["shapes"]):
        place = drake.RigidTransform(drake.Quaternion(shape["turn"]), shape["at"])
        plant.RegisterCollisionGeometry(one, place, shape_of(shape), f"shape{i}", rubs)
    plant.mutable_gravity_field().set_gravity_vector(world["gravity"])
    plant.Finalize()
    diagram = builder.Build()
    root = diagram.CreateDefaultContext()
    context = plant.GetMyMutableContextFromRoot(root)
    plant.SetFreeBodyPose(context, one, drake.RigidTransform(body["at"]))
    plant.SetFreeBodySpatialVelocity(one, drake.SpatialVelocity(w=body["spin"], v=body["velocity"]), context)
    push = drake.ExternallyAppliedSpatialForce()
    push.body_index, push.p_BoBq_B = one.index(), [0, 0, 0]
    push.F_Bq_W = drake.SpatialForce(tau=body["torque"], f=body["force"])
    plant.get_applied_spatial_force_input_port().FixValue(context, [push])
    drake.Simulator(diagram, root).AdvanceTo(step)
    after = plant.EvalBodySpatialVelocityInWorld(context, one)
    return motion(line, body, [*after.translational(), *after.rotational()]), None, {"step": step}


run("drake", "documented 1.30", "convex (SAP), compliant: what slides also opens; at the contacts of whole shapes", ask)
