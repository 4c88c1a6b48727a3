"""Newton (newton-physics): one step of SolverXPBD, at the contacts of whole shapes on a floor. Not asked where the answers were
recorded: written by its documentation, version 1."""

import newton
import warp
from adapter import inertia, motion, on_floor, run


def ask(line):
    world, body = on_floor(line)
    contact, step = world["contacts"][0], line["ask"]["step"]
    rubs = newton.ModelBuilder.ShapeConfig(density=0.0, mu=contact["friction"], restitution=contact["restitution"],
                                           mu_torsional=0.0, mu_rolling=0.0)
    builder = newton.ModelBuilder(gravity=0.0)  # gravity is a force on the body: it may have any direction
    builder.add_ground_plane(cfg=rubs)
    number = builder.add_body(xform=warp.transform(body["at"], warp.quat_identity()), mass=body["mass"],
                              inertia=warp.mat33(sum(inertia(body), [])))
    for shape in world["shapes"]:
        w, x, y, z = shape["turn"]
        place = warp.transform(shape["at"], warp.quat(x, y, z, w))
        if "box" in shape:
            hx, hy, hz = (size / 2 for size in shape["box"])
            builder.add_shape_box(number, xform=place, hx=hx, hy=hy, hz=hz, cfg=rubs)
        else:
            builder.add_shape_sphere(number, xform=place, radius=shape["sphere"], cfg=rubs)
    model = builder.finalize()
    iterations = line["ask"]["iterations"] or 2
    solver = newton.solvers.SolverXPBD(model, iterations=iterations, enable_restitution="impact" in line)
    before, after, contacts = model.state(), model.state(), model.contacts()
    before.body_qd.assign([body["velocity"] + body["spin"]])
    force = [f + body["mass"] * g for f, g in zip(body["force"], world["gravity"])]
    before.body_f.assign([force + body["torque"]])
    model.collide(before, contacts)
    solver.step(before, after, model.control(), contacts, step)
    velocities = [float(v) for v in after.body_qd.numpy()[number]]
    return motion(line, body, velocities), None, {"iterations": iterations, "step": step}


run("newton", newton.__version__, "XPBD: positions are corrected, velocities follow; at the contacts of whole shapes", ask)
