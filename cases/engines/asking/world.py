"""A scene of `slipproof export --bodies` in the plane as engines build it: everything in the axes of the scene, at the
start.

`world(scene)` gives
  gravity, size      a vector; a length of the bodies, for what an engine needs a size of
  bodies             the ground first. `at`, `velocity`, `spin`; `mass`, or `acceleration` if it moves as prescribed;
                     `inertia`, or `turning`; `force` and `torque`: what pushes it at the centre of mass, without
                     gravity; `names`: of its accelerations along x, along y and counterclockwise, [name, sign] or null
  contacts           `of` and `on` (numbers of bodies), `at`, `normal` (out of `on`), `tangent` (along which slip and
                     friction count), `radius` of the disc that touches there, 0 for a point; `friction`, `forces`
  joints             `kind`, `first`, `second`, `at` and `to` (the same place but for rods and ropes), `axis`, `length`,
                     `ratio`, `carrier`, `one_sided`, `forces`
  friction           `first`, `second`, `limit`, `force`
It raises Refused for what the first step of no engine can say.
"""

import math


class Refused(Exception):
    """Why an engine cannot have a scene."""


def turned(body, vector):
    """A vector in the axes of a body, in those of the scene."""
    c, s = body["angle"]
    return [c * vector[0] - s * vector[1], s * vector[0] + c * vector[1]]


def place(body, point):
    x, y = turned(body, point)
    return [body["at"][0] + x, body["at"][1] + y]


def names_of(body):
    unknowns = list(body["unknowns"])
    names = [None, None, None]
    if "acceleration" not in body:
        names[0:2] = [unknowns.pop(0), unknowns.pop(0)]
    if "turning" not in body:
        names[2] = unknowns.pop(0)
    return names


def forces_at_points(scene, body, place):
    """Each force of the scene, and those of springs, whose tension is known: the body, the place and the force."""
    for force in scene["forces"]:
        yield body(force["on"]), place(body(force["on"]), force["at"]), force["is"]
    for joint in scene["joints"]:
        if joint["kind"] == "spring":
            first, second = (body(name) for name in joint["between"])
            at, to = place(first, joint["at"]), place(second, joint["to"])
            pull = [joint["force"] / joint["length"] * (q - p) for p, q in zip(at, to)]
            yield first, at, pull
            yield second, to, [-p for p in pull]


class World:
    def __init__(self, scene):
        self.scene, self.impact = scene, "impact" in scene  # which happens in no time, without accelerations
        ground = {"name": "ground", "at": [0, 0], "angle": [1, 0], "velocity": [0, 0], "spin": 0,
                  "acceleration": [0, 0], "turning": 0, "unknowns": []}
        self.bodies = [ground] + scene["bodies"]
        self.number = {body["name"]: i for i, body in enumerate(self.bodies)}

    def body(self, name):
        return self.bodies[self.number[name]]

    def contact(self, given):
        if given["bilateral"]:
            raise Refused(f"{given['name']}: a contact that cannot open")
        if "static_friction" in given:
            raise Refused(f"{given['name']}: two coefficients of friction, at rest and sliding")
        if "rolling_force" in given:
            raise Refused(f"{given['name']}: rolling resistance")
        of, on = self.body(given["of"]), self.body(given["on"])
        centre = place(of, given["point"])
        if "normal" in given:
            normal = turned(on, given["normal"])
        else:
            apart = [p - q for p, q in zip(centre, place(on, given["on_point"]))]
            distance = given["radius"] + given["on_radius"]
            normal = [apart[0] / distance, apart[1] / distance]
        slip = given.get("slip_direction")
        at = [p - given["radius"] * n for p, n in zip(centre, normal)]
        if (of["spin"] or on["spin"]) and not self.impact:
            self.refuse_turning(given, of, on, at)
        if given.get("tangential_restitution"):
            raise Refused(f"{given['name']}: a tangential restitution")
        return {"name": given["name"], "of": self.number[given["of"]], "on": self.number[given["on"]], "at": at,
                "normal": normal, "tangent": turned(on, slip) if slip else [normal[1], -normal[0]],
                "radius": max(given["radius"], 0), "friction": given["friction"], "forces": given["forces"],
                "restitution": given.get("restitution", 0)}

    def refuse_turning(self, given, of, on, at):
        """A wheel that rolls or slides on a line at rest needs no centripetal terms; all else that turns does."""
        rolls = math.dist(at, of["at"]) and given["radius"] and not any(given["point"])
        if on["spin"] or not rolls:
            raise Refused(f"{given['name']}: bodies that turn, whose centripetal acceleration no first step contains")

    def joint(self, given):
        first, second = (self.body(name) for name in given["between"])
        if (first["spin"] or second["spin"]) and not self.impact:
            raise Refused(f"{given['name']}: bodies that turn, whose centripetal acceleration no first step contains")
        joint = {"name": given["name"], "kind": given["kind"], "first": self.number[first["name"]],
                 "second": self.number[second["name"]], "forces": given["forces"]}
        if given["kind"] == "gear":
            return joint | {"at": first["at"], "to": second["at"], "ratio": given["ratio"], "carrier": self.number[given["carrier"]],
                            "one_sided": given.get("one_sided", False)}
        joint |= {"at": place(first, given["at"]), "to": place(second, given["to"])}
        if "axis" in given:
            joint["axis"] = turned(first, given["axis"])
        for key in ("length", "force"):
            if key in given:
                joint[key] = given[key]
        return joint

    def pushes(self):
        """The force and the couple on each body: forces, torques, and springs, whose tension is known."""
        total = [[0, 0, 0] for _ in self.bodies]

        def push(number, at, force):
            x, y = (p - q for p, q in zip(at, self.bodies[number]["at"]))
            total[number][0] += force[0]
            total[number][1] += force[1]
            total[number][2] += x * force[1] - y * force[0]

        for body, at, force in forces_at_points(self.scene, self.body, place):
            push(self.number[body["name"]], at, force)
        for torque in self.scene["torques"]:
            total[self.number[torque["on"]]][2] += torque["is"]
        return total

    def built(self):
        scene = self.scene
        contacts = [self.contact(c) for c in scene["contacts"] if c.get("state") != "open"]
        joints = [self.joint(j) for j in scene["joints"] if j["kind"] != "spring" and j.get("state") != "open"]
        bodies = []
        for body, push in zip(self.bodies, self.pushes()):
            kept = {key: body[key] for key in ("name", "at", "velocity", "spin", "mass", "inertia", "acceleration",
                                               "turning") if key in body}
            if body.get("mass") and body.get("turning"):
                raise Refused(f"{body['name']}: a free body that turns as prescribed")
            if body.get("mass") == 0 or body.get("inertia") == 0:
                raise Refused(f"{body['name']}: a body without mass or inertia")
            bodies.append(kept | {"force": push[:2], "torque": push[2], "names": names_of(body)})
        arms = [math.dist(c["at"], bodies[c[side]]["at"]) for c in contacts for side in ("of", "on") if c[side]]
        friction = [{"name": f["name"], "first": self.number[f["between"][0]], "second": self.number[f["between"][1]],
                     "limit": f["limit"], "force": f["force"]} for f in scene["friction"]]
        return {"gravity": scene["gravity"], "size": max(arms, default=0) or 1, "bodies": bodies,
                "contacts": contacts, "joints": joints, "friction": friction}


def world(scene):
    return World(scene).built()


def length(value):
    """Of a vector, or of a turning in the plane, which is a number."""
    return math.hypot(*value) if isinstance(value, list) else abs(value)


def least_inertia(body):
    return min(body["inertia"]) if isinstance(body["inertia"], list) else body["inertia"]


def natural(built):
    """The largest acceleration that gravity, forces and couples give to bodies that nothing holds; a couple at the
    scene's size."""
    result = math.hypot(*built["gravity"])
    for body in built["bodies"]:
        if body.get("mass"):
            result = max(result, math.hypot(*body["force"]) / body["mass"])
        if body.get("inertia"):
            result = max(result, length(body["torque"]) / least_inertia(body) * built["size"])
    return result


def step_of(built):
    """A step of games, 1/60 s, or a shorter one in which no body moves by more than about a hundredth of the size, and
    no velocity that is there at the start changes by more than that part of it."""
    size, gravity = built["size"], math.hypot(*built["gravity"])
    fastest, speed = gravity, 0
    for body in built["bodies"]:
        push = math.hypot(*body["force"]) + body.get("mass", 0) * gravity
        if body.get("mass"):
            fastest = max(fastest, push / body["mass"])
        if body.get("inertia"):
            fastest = max(fastest, (length(body["torque"]) + push * size) / least_inertia(body) * size)
        speed = max(speed, math.hypot(*body["velocity"]), length(body["spin"]) * size)
    limits = [0.1 * math.sqrt(size / fastest)] if fastest else []
    if speed:
        limits += [0.01 * size / speed] + ([0.01 * speed / fastest] if fastest else [])
    shortest = min(limits, default=1)
    return 1 / 60 if shortest >= 1 / 60 else 10.0 ** math.floor(math.log10(shortest))
