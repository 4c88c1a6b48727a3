"""Genesis: one step of its rigid solver, at the contacts of whole shapes on a floor; elliptic cones with many iterations. Not asked
where the answers were recorded: written by its documentation and examples."""

import genesis as gs
from adapter import inertia, motion, on_floor, run


def words(numbers):
    return " ".join(map(repr, numbers))


def described(world, body):
    """A free body as MJCF, in the axes of the scene."""
    (xx, xy, xz), (_, yy, yz), (_, _, zz) = inertia(body)
    geoms = "".join(
        f"<geom pos='{words(shape['at'])}' quat='{words(shape['turn'])}' "
        + (f"type='box' size='{words([s / 2 for s in shape['box']])}'/>" if "box" in shape
           else f"type='sphere' size='{shape['sphere']!r}'/>") for shape in world["shapes"])
    return (f"<mujoco><worldbody><body pos='{words(body['at'])}'><freejoint/><inertial pos='0 0 0' mass='{body['mass']!r}' "
            f"fullinertia='{words([xx, yy, zz, xy, xz, yz])}'/>{geoms}</body></worldbody></mujoco>")


def ask(line):
    world, body = on_floor(line)
    step, many = line["ask"]["step"], line["ask"]["iterations"]
    options = {"iterations": many, "friction_cone": gs.friction_cone.elliptic} if many else {}
    scene = gs.Scene(sim_options=gs.options.SimOptions(dt=step, substeps=1, gravity=tuple(world["gravity"])),
                     rigid_options=gs.options.RigidOptions(**options), show_viewer=False, show_FPS=False)
    rubs = gs.materials.Rigid(friction=world["contacts"][0]["friction"])
    scene.add_entity(gs.morphs.Plane(), material=rubs)
    one = scene.add_entity(gs.morphs.MJCF(file=described(world, body)), material=rubs)
    scene.build()
    one.set_dofs_velocity(body["velocity"] + body["spin"])
    push = {"links_idx": [one.base_link_idx], "ref": "link_com", "local": False}
    scene.sim.rigid_solver.apply_links_external_force(force=[body["force"]], **push)
    scene.sim.rigid_solver.apply_links_external_torque(torque=[body["torque"]], **push)
    scene.step()
    velocities = [float(v) for v in one.get_dofs_velocity().flatten()]
    return motion(line, body, velocities), None, {"iterations": many, "step": step}


gs.init(backend=gs.cpu, precision="64", logging_level="error")
run("genesis", gs.__version__, "associated, soft: contacts give way; at the contacts of whole shapes", ask)
