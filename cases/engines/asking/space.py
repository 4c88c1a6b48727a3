"""A scene in space as engines build it: as world.py for the plane, with vectors of three components. What is different:

  bodies    `turn`: a quaternion w x y z, which brings the principal axes of the body into the scene, and `inertia`: the
            three moments about these axes; `names`: six, of the accelerations along x y z and about x y z
  contacts  `tangent` and `second`, along which the forces after the first count
  joints    `axis` in the axes of the scene
"""

import math

from .world import Refused, forces_at_points

CLOSE = 1e-9  # of a size or a speed: what is 0 but for rounding


def dot(a, b):
    return sum(p * q for p, q in zip(a, b))


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def turned(body, vector):
    """A vector in the axes of a body, in those of the scene."""
    return [dot(row, vector) for row in body["turn"]]


def place(body, point):
    return [p + q for p, q in zip(body["at"], turned(body, point))]


def product(a, b):
    return [[sum(a[i][k] * b[k][j] for k in range(3)) for j in range(3)] for i in range(3)]


def principal(inertia):
    """Moments and axes (columns of a rotation) of xx yy zz xy xz yz, by Jacobi's rotations."""
    xx, yy, zz, xy, xz, yz = inertia
    m, axes = [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]], [[1, 0, 0], [0, 1, 0], [0, 0, 1]]
    for _ in range(20):
        for p, q in ((0, 1), (0, 2), (1, 2)):
            if abs(m[p][q]) <= 1e-18 * max(xx, yy, zz):
                continue
            angle = 0.5 * math.atan2(2 * m[p][q], m[q][q] - m[p][p])
            turn = [[float(i == j) for j in range(3)] for i in range(3)]
            turn[p][p] = turn[q][q] = math.cos(angle)
            turn[p][q], turn[q][p] = math.sin(angle), -math.sin(angle)
            m = product(product([list(column) for column in zip(*turn)], m), turn)
            axes = product(axes, turn)
    return [m[i][i] for i in range(3)], axes


def quaternion(r):
    """w x y z of a rotation, from its largest component."""
    squares = [1 + r[0][0] + r[1][1] + r[2][2], 1 + r[0][0] - r[1][1] - r[2][2],
               1 - r[0][0] + r[1][1] - r[2][2], 1 - r[0][0] - r[1][1] + r[2][2]]
    largest = max(range(4), key=lambda i: squares[i])
    x, y, z = r[2][1] - r[1][2], r[0][2] - r[2][0], r[1][0] - r[0][1]
    xy, xz, yz = r[0][1] + r[1][0], r[0][2] + r[2][0], r[1][2] + r[2][1]
    given = [[squares[0], x, y, z], [x, squares[1], xy, xz], [y, xy, squares[2], yz], [z, xz, yz, squares[3]]][largest]
    return [g / (2 * math.sqrt(squares[largest])) for g in given]


def names_of(body):
    unknowns = list(body["unknowns"])
    linear = [unknowns.pop(0) for _ in range(3)] if "acceleration" not in body else [None] * 3
    return linear + ([unknowns.pop(0) for _ in range(3)] if "turning" not in body else [None] * 3)


def own_shapes(scene, built):
    """Of the one body of a scene that stands on the level floor at 0, for engines that find contacts of shapes: boxes,
    spheres and hulls with `at`, from the centre of mass, and `turn`, in the axes of the scene. Raises Refused."""
    body = scene["bodies"][0]
    level = all(contact["on"] == 0 and contact["normal"][2] == 1 and abs(contact["at"][2]) <= CLOSE * built["size"]
                for contact in built["contacts"])
    if len(scene["bodies"]) != 1 or not level or not built["contacts"] or not body["shapes"]:
        raise Refused("shapes that are not those of one body on a level floor")
    shapes, identity = [], [1, 0, 0, 0]
    for shape in body["shapes"]:
        kind = next((kind for kind in ("box", "sphere", "hull") if kind in shape), None)
        if not kind:
            raise Refused("a shape that is no box, sphere or hull")
        if kind == "hull":
            shapes.append({"hull": [turned(body, point) for point in shape["hull"]], "at": [0, 0, 0], "turn": identity})
        else:
            turn = quaternion(body["turn"]) if kind == "box" else identity
            shapes.append({kind: shape[kind], "at": turned(body, shape["at"]), "turn": turn})
    return shapes


class WorldInSpace:
    def __init__(self, scene):
        self.scene, self.impact = scene, "impact" in scene
        still = [0, 0, 0]
        ground = {"name": "ground", "at": still, "turn": [[1, 0, 0], [0, 1, 0], [0, 0, 1]], "velocity": still, "spin": still,
                  "acceleration": still, "turning": still, "unknowns": []}
        self.bodies = [ground] + scene["bodies"]
        self.number = {body["name"]: i for i, body in enumerate(self.bodies)}

    def body(self, name):
        return self.bodies[self.number[name]]

    def contact(self, given):
        for key, said in (("bilateral", "a contact that cannot open"), ("rolling_force", "rolling resistance"),
                          ("static_friction", "two coefficients of friction, at rest and sliding")):
            if given.get(key):
                raise Refused(f"{given['name']}: {said}")
        of, on = self.body(given["of"]), self.body(given["on"])
        centre = place(of, given["point"])
        if "normal" in given:
            normal = turned(on, given["normal"])
        else:
            apart = [p - q for p, q in zip(centre, place(on, given["on_point"]))]
            normal = [a / (given["radius"] + given["on_radius"]) for a in apart]
        at = [p - given["radius"] * n for p, n in zip(centre, normal)]
        if not self.impact:
            self.refuse_turning(given, of, on, at, normal)
        if given.get("tangential_restitution"):
            raise Refused(f"{given['name']}: a tangential restitution")
        tangent, second = given.get("tangents") or self.any_tangents(normal)
        return {"name": given["name"], "of": self.number[given["of"]], "on": self.number[given["on"]], "at": at,
                "normal": normal, "tangent": tangent, "second": second, "radius": max(given["radius"], 0),
                "friction": given["friction"], "forces": given["forces"], "restitution": given.get("restitution", 0)}

    @staticmethod
    def any_tangents(normal):
        other = [0, 0, 1] if abs(normal[2]) < 0.5 else [1, 0, 0]
        tangent = cross(other, normal)
        tangent = [t / math.hypot(*tangent) for t in tangent]
        return tangent, cross(normal, tangent)

    @staticmethod
    def refuse_turning(given, of, on, at, normal):
        """Centripetal accelerations are in no first step: they may only be those of a ball about its centre, and of points
        that slide along the surface, where they change no force."""
        if any(on["spin"]):
            raise Refused(f"{given['name']}: a surface that turns, whose centripetal acceleration no first step contains")
        if any(of["spin"]) and not (given["radius"] and not any(given["point"])):
            arm = [p - q for p, q in zip(at, of["at"])]
            inward = dot(cross(of["spin"], cross(of["spin"], arm)), normal)
            if given.get("state") != "slides" or abs(inward) > CLOSE * dot(of["spin"], of["spin"]) * math.hypot(*arm):
                raise Refused(f"{given['name']}: bodies that turn, whose centripetal acceleration no first step contains")

    def joint(self, given):
        first, second = (self.body(name) for name in given["between"])
        if (any(first["spin"]) or any(second["spin"])) and not self.impact:
            raise Refused(f"{given['name']}: bodies that turn, whose centripetal acceleration no first step contains")
        if given["kind"] == "gear":
            raise Refused(f"{given['name']}: a gear in space")
        joint = {"name": given["name"], "kind": given["kind"], "first": self.number[first["name"]],
                 "second": self.number[second["name"]], "forces": given["forces"], "at": place(first, given["at"]),
                 "to": place(second, given["to"])}
        if "axis" in given:
            joint["axis"] = turned(first, given["axis"])
        return joint | {key: given[key] for key in ("length", "force") if key in given}

    def pushes(self):
        """The force and the couple on each body."""
        total = [([0, 0, 0], [0, 0, 0]) for _ in self.bodies]

        def push(body, at, force):
            pushed = total[self.number[body["name"]]]
            couple = cross([p - q for p, q in zip(at, body["at"])], force)
            for i in range(3):
                pushed[0][i] += force[i]
                pushed[1][i] += couple[i]

        for body, at, force in forces_at_points(self.scene, self.body, place):
            push(body, at, force)
        for torque in self.scene["torques"]:
            for i in range(3):
                total[self.number[torque["on"]]][1][i] += torque["is"][i]
        return total

    def built_body(self, body, force, torque):
        kept = {key: body[key] for key in ("name", "at", "velocity", "spin", "mass", "acceleration", "turning") if key in body}
        if body.get("mass") == 0 or ("inertia" in body and min(body["inertia"][:3]) == 0):
            raise Refused(f"{body['name']}: a body without mass or inertia")
        if ("mass" in body) != ("inertia" in body):
            raise Refused(f"{body['name']}: a body in space that is free in part")
        axes = [[1, 0, 0], [0, 1, 0], [0, 0, 1]]
        if "inertia" in body:
            kept["inertia"], axes = principal(body["inertia"])
            if not self.impact:
                self.refuse_gyroscopic(body)
        return kept | {"turn": quaternion(product(body["turn"], axes)), "force": force, "torque": torque, "names": names_of(body)}

    @staticmethod
    def refuse_gyroscopic(body):
        xx, yy, zz, xy, xz, yz = body["inertia"]
        spin = [dot(column, body["spin"]) for column in zip(*body["turn"])]
        momentum = [dot(row, spin) for row in ([xx, xy, xz], [xy, yy, yz], [xz, yz, zz])]
        if math.hypot(*cross(spin, momentum)) > CLOSE * max(xx, yy, zz) * dot(spin, spin):
            raise Refused(f"{body['name']}: a body that spins about no principal axis, whose gyroscopic couple engines leave out")

    def built(self):
        scene = self.scene
        if scene["friction"]:
            raise Refused("brakes and clutches in space")
        contacts = [self.contact(c) for c in scene["contacts"] if c.get("state") != "open"]
        joints = [self.joint(j) for j in scene["joints"] if j["kind"] != "spring" and j.get("state") != "open"]
        bodies = [self.built_body(body, *push) for body, push in zip(self.bodies, self.pushes())]
        arms = [math.dist(c["at"], bodies[c[side]]["at"]) for c in contacts for side in ("of", "on") if c[side]]
        return {"gravity": scene["gravity"], "size": max(arms, default=0) or 1, "bodies": bodies,
                "contacts": contacts, "joints": joints, "friction": []}
