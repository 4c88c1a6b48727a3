"""Rest in the plane as linear programs: each contact's cone has two rays, F is free. Solved by the simplex method here, or
by QSopt_ex (Debian's qsopt-ex), exactly, too."""
import re
import shutil
import subprocess
import tempfile
from fractions import Fraction
from pathlib import Path

import simplex


def columns(structure):
    """For each contact the names of its two rays, and what a unit of each is in N and S; for a pin's forces both signs."""
    rays = {}
    for c in structure.contacts:
        normal, tangent = c.forces()
        rays[f"p_{c.name}"] = {normal: Fraction(1), tangent: c.mu}
        rays[f"m_{c.name}"] = {normal: Fraction(1), tangent: -c.mu}
    for pin in structure.pins:
        for force in pin.forces():
            rays[f"p_{force}"], rays[f"m_{force}"] = {force: Fraction(1)}, {force: Fraction(-1)}
    return rays


def equations(structure, load):
    """The balance over the rays, at one load, or with F as f - h if load is None: ({column: coefficient}, right side)."""
    rays = columns(structure)
    out = []
    for _, forces, constant, factor in structure.rows():
        left = {}
        for ray, parts in rays.items():
            v = sum(k * forces.get(force, 0) for force, k in parts.items())
            if v:
                left[ray] = v
        if load is None:
            if factor:
                left["f"], left["h"] = factor, -factor
            out.append((left, -constant))
        else:
            out.append((left, -constant - factor * load))
    return out


def widened(program):
    """The same with a margin e <= 1 by which every ray is at least pressed: x = x' + e. A pin's two signs cancel."""
    out = [({**left, "e": sum(left.values())}, right) for left, right in program]
    return out + [({"e": Fraction(1), "slack": Fraction(1)}, Fraction(1))]


class Simplex:
    def maximise(self, program, objective):
        names = sorted({n for left, _ in program for n in left} | set(objective))
        index = {n: k for k, n in enumerate(names)}
        rows = [({index[n]: v for n, v in left.items()}, right) for left, right in program]
        return simplex.maximise(rows, len(names), {index[n]: v for n, v in objective.items()})


class QSopt:
    program = "esolver"

    def there(self):
        return shutil.which(self.program)

    def maximise(self, program, objective):
        used = {n for left, _ in program for n in left}
        if any(n not in used for n in objective):
            return Simplex().maximise(program, objective)
        for left, right in program:
            if not left and right:
                return "infeasible", None
        lines = ["Maximize", " obj: " + terms(objective) if objective else " obj: 0 " + min(used), "Subject To"]
        lines += [f" r{k}: {terms(left)} = {right}" for k, (left, right) in enumerate(program) if left]
        with tempfile.TemporaryDirectory() as folder:
            file, answer = Path(folder) / "p.lp", Path(folder) / "p.sol"
            file.write_text("\n".join(lines + ["End"]) + "\n")
            subprocess.run([self.program, "-L", "-O", str(answer), str(file)], capture_output=True, check=True)
            said = answer.read_text()
        status = re.search(r"status (?:= )?(\w+)", said).group(1)
        if status == "OPTIMAL":
            return "optimal", Fraction(re.search(r"Value = (\S+)", said).group(1))
        return {"UNBOUNDED": ("unbounded", None), "INFEASIBLE": ("infeasible", None)}[status]


def terms(left):
    return " ".join(f"{'-' if v < 0 else '+'} {abs(v)} {n}" for n, v in left.items())


def can_rest(solver, structure):
    return solver.maximise(equations(structure, structure.load or 0), {})[0] != "infeasible"


def touches(solver, structure):
    """Whether a structure that can rest has no forces inside of all cones."""
    return solver.maximise(widened(equations(structure, structure.load or 0)), {"e": Fraction(1)})[1] == 0


def loads(solver, structure):
    """The least and greatest F at which it can rest, None for unbounded; or None if it can at no F."""
    program = equations(structure, None)
    ends = []
    for sign in (-1, 1):
        status, value = solver.maximise(program, {"f": Fraction(sign), "h": Fraction(-sign)})
        if status == "infeasible":
            return None
        ends.append(None if status == "unbounded" else sign * value)
    return ends
