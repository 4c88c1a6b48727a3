"""The contact problem of a system from Lagrange's equations with multipliers, and how an exported one differs from it."""
from fractions import Fraction

from linear import reduced, solved_for
from motion import acceleration_row, unknowns, work_row


class Problem:
    """M v = f + H r + G l over the unknown accelerations v, u = H^T v + w, G^T v + b = 0. `columns`: of H by name."""

    def __init__(self, system, turning_equations):
        self.bodies = system.bodies
        self.size = len(unknowns(self.bodies))
        self.M, self.f = [], []
        for body in (b for b in self.bodies if b.moves_freely):
            self.add_body(body, turning_equations, system.gravity)
        self.columns, self.links = {}, []
        self.contacts = {e.rows[0][0]: e for e in system.elements if e.rows}
        for element in system.elements:
            among = element.among
            for f in element.links:
                row, constant = acceleration_row(f.function, self.bodies, self.names(among), f.change)
                self.links.append(row + [constant])
            for name, force, f in element.rows:
                row, constant = acceleration_row(f.function, self.bodies, self.names(among), f.change)
                work = self.work(f, among)
                assert row == work, "what a force works along is what it accelerates"
                self.columns[name, force] = (row, constant)
            for f, size in element.armatures:
                self.add_armature(size, *acceleration_row(f.function, self.bodies, self.names(among), f.change))
            for f, size in element.loads:
                for i, x in enumerate(self.work(f, among)):
                    self.f[i] += size * x

    def names(self, among):
        return [b for b in self.bodies if b.name in among]

    def work(self, f, among):
        return work_row(f.function, self.bodies, self.names(among), f.speed)

    def add_body(self, body, turning_equations, gravity):
        start = len(self.M)
        J = body.scene_inertia()
        given = (J[0][0], J[1][1], J[2][2], J[0][1], J[0][2], J[1][2], *body.spin)
        constant = turning_equations(*given, 0, 0, 0)
        for i in range(3):
            row = [Fraction(0)] * self.size
            row[start + i] = body.mass
            self.M.append(row)
            self.f.append(body.mass * gravity[i])
        for i in range(3):
            row = [Fraction(0)] * self.size
            for k in range(3):
                turning = [Fraction(int(j == k)) for j in range(3)]
                row[start + 3 + k] = Fraction(turning_equations(*given, *turning)[i] - constant[i])
            self.M.append(row)
            self.f.append(-Fraction(constant[i]))

    def add_armature(self, size, row, constant):
        """Of a kinetic energy of size/2 times the square of a speed whose derivative is row . v + constant."""
        for i, x in enumerate(row):
            self.f[i] -= size * x * constant
            for k, y in enumerate(row):
                self.M[i][k] += size * x * y

    def links_fit(self):
        """Whether accelerations satisfy them."""
        return all(any(link[:-1]) for link in reduced(self.links))

    def differences(self, exported):
        """Words on all that is not the same rational."""
        if sorted(exported["contacts"]) != sorted(self.contacts):
            return [f"contacts: found {exported['contacts']}, expected {list(self.contacts)}"]
        contacts = [self.contacts[name] for name in exported["contacts"]]
        friction = [e.friction if e.slides is None else 0 for e in contacts]
        if [Fraction(x) for x in exported["mu"]] != friction:
            return [f"mu: found {exported['mu']}, expected {friction}"]
        if "W" in exported:
            return self.differences_of_local_form(exported, contacts)
        found = []
        if numbers(exported["M"]) != self.M:
            found.append("M")
        if [Fraction(x) for x in exported["f"]] != self.f:
            found.append(f"f: found {exported['f']}, expected {[str(x) for x in self.f]}")
        H, w = numbers(exported["H"]), [Fraction(x) for x in exported["w"]]
        named = {}
        for i, name in enumerate(exported["contacts"]):
            for k, force in enumerate(("N", "T1", "T2")):
                named[name, force] = ([row[3 * i + k] for row in H], w[3 * i + k])
        for key, (row, constant) in self.columns.items():
            if key not in named:
                found.append(f"no column of {key}")
            elif named[key] != (row, constant):
                found.append(f"{key}: found {[str(x) for x in named[key][0]]} and {named[key][1]}, expected "
                             f"{[str(x) for x in row]} and {constant}")
        for key, (row, constant) in named.items():
            if key not in self.columns and (any(row) or constant):
                found.append(f"{key}: a column of more")
        G = numbers(exported.get("G", []))
        b = [Fraction(x) for x in exported.get("b", [])]
        links = [[row[i] for row in G] + [b[i]] for i in range(len(b))]
        if reduced(links) != reduced(self.links):
            found.append(f"what joints hold: rank {len(reduced(links))}, expected {len(reduced(self.links))}")
        return found


    def local_form(self, contacts):
        """u = W r + q, with r = N, T1, T2 of each contact; one that slides pushes by N - mu N d."""
        columns = [self.columns.get((name, force), ([Fraction(0)] * self.size, Fraction(0)))
                   for name in (e.rows[0][0] for e in contacts) for force in ("N", "T1", "T2")]
        links = reduced(self.links)
        rows = [M + [-link[i] for link in links] + [c[i] for c, _ in columns] + [self.f[i]] for i, M in enumerate(self.M)]
        rows += [link[:-1] + [Fraction(0)] * (len(links) + len(columns)) + [-link[-1]] for link in links]
        motion = solved_for(rows, self.size, self.size + len(links))
        for row in motion:
            for k, e in enumerate(contacts):
                if e.slides is not None:
                    row[3 * k] -= e.friction * (e.slides[0] * row[3 * k + 1] + e.slides[1] * row[3 * k + 2])
                    row[3 * k + 1] = row[3 * k + 2] = Fraction(0)
        u = [[sum(c[i] * motion[i][j] for i in range(self.size)) for j in range(len(columns) + 1)] for c, _ in columns]
        return [row[:-1] for row in u], [row[-1] + w for row, (_, w) in zip(u, columns)]

    def differences_of_local_form(self, exported, contacts):
        """Directions on a sphere may be carried along in any way; so where one slides on a sphere only N is compared."""
        W, q = self.local_form(contacts)
        found = []
        for k, e in enumerate(contacts):
            for t in range(1 if e.slides is not None and e.kind != "plane" else 3):
                i = 3 * k + t
                told = [Fraction(x) for x in exported["W"][i]], Fraction(exported["q"][i])
                if told != (W[i], q[i]):
                    found.append(f"row {t} of {exported['contacts'][k]}: found {exported['W'][i]} and {exported['q'][i]}, "
                                 f"expected {[str(x) for x in W[i]]} and {q[i]}")
        return found


def numbers(rows):
    return [[Fraction(x) for x in row] for row in rows]
