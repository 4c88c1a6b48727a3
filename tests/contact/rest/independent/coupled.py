#!/usr/bin/env python3
"""The time of `slipproof rest` beside IPOPT's on the problem of compas_cra (Kao, Iannuzzo, Thomaszewski, Coros, Van Mele and
Block, "Coupled Rigid-Block Analysis", Computer-Aided Design 146 (2022) 103216).

    coupled.py SLIPPROOF [KIND NUMBERS...]      structures as in make.py; without any: a row of them

IPOPT minimises the squares of normal forces f_n and of factors alpha, where forces balance within pyramids of friction, and
virtual displacements d = A^T q of the bodies, small ones, do not go deeper than eps, (d_n + eps) f_n = 0, and f_t = -alpha d_t.
Defaults are those of compas_cra: |d| <= 1e-3, eps = 1e-4, eight sides, tol 1e-8, constr_viol_tol 1e-7, from f = 1, q = 0.
Its time is the processor's within IPOPT, without the callbacks here; that of slipproof is of the whole program.
"""
import ctypes
import resource
import subprocess
import sys
import tempfile
import time
from fractions import Fraction
from pathlib import Path

import numpy

import make

BOUND, EPS, SIDES, NONE, LONGEST = 1e-3, 1e-4, 8, 2e19, 300.0
ROW = ["arch 21 1/8", "arch 51 1/8", "arch 101 1/8", "wall 5 5", "wall 10 10", "cards 4", "heap 5", "heap 30"]
INDEX, REAL, POINTER = ctypes.c_int, ctypes.c_double, ctypes.c_void_p
REALS, INDICES = ctypes.POINTER(REAL), ctypes.POINTER(INDEX)


class Coupled:
    """x = (f, q, alpha); g = (balance, friction, displacements, complementarity, depth, sliding)."""

    def __init__(self, structure):
        size = structure.dimension
        rows = structure.rows()
        names = {f: k for k, f in enumerate(f for c in structure.contacts for f in c.forces())}
        entries = [(i, names[f], float(v)) for i, (_, row, _, _) in enumerate(rows) for f, v in row.items()]
        self.row, self.column = (numpy.array([e[k] for e in entries], dtype=int) for k in (0, 1))
        self.value = numpy.array([e[2] for e in entries])
        self.push = numpy.array([float(r[2]) for r in rows])
        self.contacts, self.dofs, self.forces = len(structure.contacts), len(rows), len(names)
        self.normal = numpy.arange(self.contacts) * size
        self.tangents = numpy.array([self.normal + 1 + t for t in range(size - 1)])
        mu = numpy.array([float(c.mu) for c in structure.contacts])
        angles = numpy.arange(2 if size == 2 else SIDES) * 2 * numpy.pi / (2 if size == 2 else SIDES)
        sides = [numpy.cos(angles), numpy.sin(angles)][:size - 1]
        self.friction = []  # row, column, value
        for k, _ in enumerate(angles):
            at = k * self.contacts + numpy.arange(self.contacts)
            self.friction.append((at, self.normal, -mu))
            self.friction += [(at, self.tangents[t], numpy.full(self.contacts, sides[t][k])) for t in range(size - 1)]
        self.friction = [numpy.concatenate([part[k] for part in self.friction]) for k in range(3)]
        self.starts = numpy.cumsum([0, self.dofs, self.contacts * len(angles), self.forces, self.contacts, self.contacts,
                                    self.contacts * (size - 1)])
        self.count, self.conditions = self.forces + self.dofs + self.contacts, int(self.starts[-1])
        # The columns of A under each force: which entries of its matrix move it.
        self.q, self.alpha = slice(self.forces, self.forces + self.dofs), slice(self.forces + self.dofs, self.count)
        order = numpy.argsort(self.column, kind="stable")
        first = numpy.searchsorted(self.column[order], numpy.arange(self.forces + 1))
        self.of_force = [order[a:b] for a, b in zip(first, first[1:])]
        of_normals, self.of_tangents = [self.of_force[j] for j in self.normal], [[self.of_force[j] for j in t] for t in self.tangents]
        self.under_normal = numpy.concatenate(of_normals)
        self.normal_contact = numpy.repeat(numpy.arange(self.contacts), [len(e) for e in of_normals])
        self.under = [numpy.concatenate(t) for t in self.of_tangents]
        self.under_contact = [numpy.repeat(numpy.arange(self.contacts), [len(e) for e in t]) for t in self.of_tangents]
        self.structure_of_jacobian()
        self.structure_of_hessian()
        self.spent = 0.0

    def structure_of_jacobian(self):
        s, every = self.starts, numpy.arange(self.contacts)
        parts = [(self.row, self.column), (s[1] + self.friction[0], self.friction[1]),
                 (s[2] + self.column, self.forces + self.row),
                 (s[3] + every, self.normal), (s[3] + self.normal_contact, self.forces + self.row[self.under_normal]),
                 (s[4] + self.normal_contact, self.forces + self.row[self.under_normal])]
        for t, tangent in enumerate(self.tangents):
            at = s[5] + t * self.contacts
            parts += [(at + every, tangent), (at + every, self.forces + self.dofs + every),
                      (at + self.under_contact[t], self.forces + self.row[self.under[t]])]
        self.jacobian_at = tuple(numpy.concatenate([p[k] for p in parts]).astype(numpy.int32) for k in (0, 1))

    def structure_of_hessian(self):
        """Below the diagonal: of squares, of d_n f_n, and of alpha d_t."""
        alphas = self.forces + self.dofs + numpy.arange(self.contacts)
        parts = [(self.normal, self.normal), (alphas, alphas),
                 (self.forces + self.row[self.under_normal], self.normal[self.normal_contact])]
        for t in range(len(self.tangents)):
            parts.append((alphas[self.under_contact[t]], self.forces + self.row[self.under[t]]))
        self.hessian_at = tuple(numpy.concatenate([p[k] for p in parts]).astype(numpy.int32) for k in (0, 1))

    def displacements(self, x):
        return numpy.bincount(self.column, self.value * x[self.q][self.row], self.forces)

    def objective(self, x):
        return float((x[self.normal] ** 2).sum() + (x[self.alpha] ** 2).sum())

    def gradient(self, x):
        result = numpy.zeros(self.count)
        result[self.normal] = 2 * x[self.normal]
        result[self.alpha] = 2 * x[self.alpha]
        return result

    def values(self, x):
        d = self.displacements(x)
        sliding = [x[t] + x[self.alpha] * d[t] for t in self.tangents]
        balance = numpy.bincount(self.row, self.value * x[self.column], self.dofs)
        cone = numpy.bincount(self.friction[0], self.friction[2] * x[self.friction[1]], self.starts[2] - self.starts[1])
        depth = d[self.normal] + EPS
        return numpy.concatenate([balance, cone, d, depth * x[self.normal], depth, *sliding])

    def jacobian(self, x):
        d, ones = self.displacements(x), numpy.ones(self.contacts)
        below = self.value[self.under_normal]
        parts = [self.value, self.friction[2], self.value, d[self.normal] + EPS, below * x[self.normal][self.normal_contact], below]
        for t, tangent in enumerate(self.tangents):
            parts += [ones, d[tangent], self.value[self.under[t]] * x[self.alpha][self.under_contact[t]]]
        return numpy.concatenate(parts)

    def hessian(self, factor, multipliers):
        s = self.starts
        squares = numpy.full(self.contacts, 2 * factor)
        parts = [squares, squares, multipliers[s[3]:s[4]][self.normal_contact] * self.value[self.under_normal]]
        for t in range(len(self.tangents)):
            of = multipliers[s[5] + t * self.contacts:][:self.contacts]
            parts.append(of[self.under_contact[t]] * self.value[self.under[t]])
        return numpy.concatenate(parts)

    def bounds(self):
        low, high = numpy.full(self.count, -NONE), numpy.full(self.count, NONE)
        low[self.normal] = 0
        low[self.alpha] = 0
        s = self.starts
        least, most = numpy.zeros(self.conditions), numpy.zeros(self.conditions)
        least[:s[1]] = most[:s[1]] = -self.push
        least[s[1]:s[2]] = -NONE
        least[s[2]:s[3]], most[s[2]:s[3]] = -BOUND, BOUND
        most[s[4]:s[5]] = NONE
        return low, high, least, most


def ipopt():
    library = ctypes.CDLL("libipopt.so.1")
    library.CreateIpoptProblem.restype = POINTER
    library.AddIpoptStrOption.argtypes = [POINTER, ctypes.c_char_p, ctypes.c_char_p]
    library.AddIpoptNumOption.argtypes = [POINTER, ctypes.c_char_p, REAL]
    library.AddIpoptIntOption.argtypes = [POINTER, ctypes.c_char_p, INDEX]
    library.IpoptSolve.argtypes = [POINTER] + [REALS] * 6 + [POINTER]
    library.FreeIpoptProblem.argtypes = [POINTER]
    return library


def solve(library, problem):
    """IPOPT's status and its seconds of processor."""
    view = numpy.ctypeslib.as_array
    spent = [0.0]

    def timed(function):
        def call(*arguments):
            began = time.process_time()
            function(*arguments)
            spent[0] += time.process_time() - began
            return 1
        return call

    def copy(to, values):
        view(to, (len(values),))[:] = values

    def entries(at, rows, columns, to, compute):
        if rows:
            copy(rows, at[0]), copy(columns, at[1])
        else:
            copy(to, compute())

    x_of = lambda x: view(x, (problem.count,))
    objective = timed(lambda n, x, new, to, data: copy(to, [problem.objective(x_of(x))]))
    gradient = timed(lambda n, x, new, to, data: copy(to, problem.gradient(x_of(x))))
    values = timed(lambda n, x, new, m, to, data: copy(to, problem.values(x_of(x))))
    jacobian = timed(lambda n, x, new, m, count, rows, columns, to, data: entries(
        problem.jacobian_at, rows, columns, to, lambda: problem.jacobian(x_of(x))))
    hessian = timed(lambda n, x, new, factor, m, multipliers, fresh, count, rows, columns, to, data: entries(
        problem.hessian_at, rows, columns, to, lambda: problem.hessian(factor, view(multipliers, (problem.conditions,)))))
    kind = ctypes.CFUNCTYPE
    calls = [kind(INDEX, INDEX, REALS, INDEX, REALS, POINTER)(objective),
             kind(INDEX, INDEX, REALS, INDEX, INDEX, REALS, POINTER)(values),
             kind(INDEX, INDEX, REALS, INDEX, REALS, POINTER)(gradient),
             kind(INDEX, INDEX, REALS, INDEX, INDEX, INDEX, INDICES, INDICES, REALS, POINTER)(jacobian),
             kind(INDEX, INDEX, REALS, INDEX, REAL, INDEX, REALS, INDEX, INDEX, INDICES, INDICES, REALS, POINTER)(hessian)]
    low, high, least, most = (numpy.ascontiguousarray(b) for b in problem.bounds())
    pointer = lambda array: array.ctypes.data_as(REALS)
    made = library.CreateIpoptProblem(INDEX(problem.count), pointer(low), pointer(high), INDEX(problem.conditions), pointer(least),
                                      pointer(most), INDEX(len(problem.jacobian_at[0])), INDEX(len(problem.hessian_at[0])), INDEX(0), *calls)
    library.AddIpoptStrOption(made, b"sb", b"yes")
    library.AddIpoptIntOption(made, b"print_level", 0)
    library.AddIpoptNumOption(made, b"tol", 1e-8)
    library.AddIpoptNumOption(made, b"constr_viol_tol", 1e-7)
    library.AddIpoptNumOption(made, b"max_cpu_time", LONGEST)
    x = numpy.zeros(problem.count)
    x[:problem.forces] = 1
    outcome = REAL()
    began = time.process_time()
    status = library.IpoptSolve(made, pointer(x), None, ctypes.byref(outcome), None, None, None, None)
    seconds = time.process_time() - began - spent[0]
    library.FreeIpoptProblem(made)
    return {0: "solved", 1: "nearly solved", 2: "infeasible", -1: "too many steps", -2: "restoration failed", -4: "not in 300 s"}.get(status, f"status {status}"), seconds


def ours(slipproof, structure):
    """The verdict, and the seconds of processor of the whole program."""
    with tempfile.TemporaryDirectory() as folder:
        scene = structure.write(Path(folder))
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        run = subprocess.run([slipproof, "rest", str(scene), "--quiet"], capture_output=True, text=True)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
    seconds = after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime
    return run.stdout.strip().removeprefix("s ") or run.stderr.strip(), seconds


def main():
    slipproof, *given = sys.argv[1:]
    try:
        library = ipopt()
    except OSError:
        print("needs libipopt.so.1, of Debian's coinor-libipopt1v5")
        sys.exit(77)
    makers = {"arch": lambda n, t: make.arch(int(n), Fraction(t)), "wall": lambda c, b: make.wall(int(c), int(b)),
              "cards": lambda n: make.cards(int(n)), "heap": lambda n: make.heap(int(n))}
    bad = 0
    for line in [" ".join(given)] if given else ROW:
        kind, *numbers = line.split()
        structure = makers[kind](*numbers)
        verdict, mine = ours(slipproof, structure)
        status, theirs = solve(library, Coupled(structure))
        bad += status == "solved" and verdict == "CANNOT REST"
        print(f"{structure.name}, {len(structure.contacts)} contacts: {verdict}; IPOPT {status}, {theirs / mine:.3g} of its time", flush=True)
    if bad:
        sys.exit(f"{bad} that cannot rest were solved")


if __name__ == "__main__":
    main()
