"""with_ctypes.py LIBRARY PROGRAM SOURCES: the C interface through ctypes says what the program says."""
import ctypes as c
import glob
import json
import math
import os
import re
import subprocess
import sys
import threading
import unittest

LIBRARY, PROGRAM, SOURCES = sys.argv[1:4]
text, size = c.c_char_p, c.c_size_t


def structure(*fields):
    return type("Structure", (c.Structure,), {"_fields_": fields})


Interval = structure(("lower", text), ("upper", text), ("nearest_lower", c.c_double), ("nearest_upper", c.c_double),
                     ("lower_closed", c.c_int), ("upper_closed", c.c_int))
Value = structure(("name", text), ("range", Interval))
Motion = structure(("modes", c.POINTER(text)), ("mode_count", size), ("strict", c.c_int), ("continuum", c.c_int),
                   ("values", c.POINTER(Value)), ("value_count", size))
Range = structure(("mode", text), ("loads", Interval))
Cell = structure(("loads", Interval), ("motions", c.POINTER(Motion)), ("motion_count", size))
Rejection = structure(("mode", text), ("violated", text), ("margin", text))
Mistake = structure(("place", text), ("line", size), ("column", size), ("found", text), ("expected", text),
                    ("message", text))
Doubles = c.POINTER(c.c_double)
Problem = structure(("size", size), ("dimension", size), ("W", Doubles), ("q", Doubles), ("mu", Doubles),
                    ("z", Doubles), ("w", Doubles))
Judgement = structure(("verdict", text), ("certified", c.c_int), ("error", c.c_double), ("backward_error", c.c_double),
                      ("json", text))

lib = c.CDLL(LIBRARY)
handle = c.c_void_p
for name, result in {"version": text, "error_message": text, "error_count": size, "error_mistake": Mistake,
                     "solution_json": text, "solution_name": text, "solution_load": text,
                     "solution_motions": c.POINTER(Motion), "solution_ranges": c.POINTER(Range),
                     "solution_cells": c.POINTER(Cell), "solution_rejections": c.POINTER(Rejection),
                     "verdict_judgement": Judgement}.items():
    getattr(lib, "slipproof_" + name).restype = result


def program(*arguments, **options):
    return subprocess.run([PROGRAM, *arguments], stdout=subprocess.PIPE, **options).stdout


class Solution:
    def __init__(self, path):
        self.handle = handle()
        error = handle()
        status = lib.slipproof_solve_file(os.fsencode(path), c.byref(self.handle), c.byref(error))
        if status != 0:
            message = lib.slipproof_error_message(error).decode()
            lib.slipproof_error_free(error)
            raise ValueError(message)

    def __del__(self):
        lib.slipproof_solution_free(self.handle)

    def json(self):
        return lib.slipproof_solution_json(self.handle)

    def array(self, name):
        count = size()
        elements = getattr(lib, "slipproof_solution_" + name)(self.handle, c.byref(count))
        return elements[:count.value]


def modes(motion):
    return [mode.decode() for mode in motion.modes[:motion.mode_count]]


def ends(interval):
    return [end and end.decode() for end in (interval.lower, interval.upper)]


def nearest(fraction):
    top, _, bottom = fraction.partition("/")
    return int(top) / int(bottom or 1)  # correctly rounded


class TheInterface(unittest.TestCase):
    def test_exports_what_the_header_promises(self):
        lines = subprocess.run(["nm", "-D", "--defined-only", LIBRARY], check=True, stdout=subprocess.PIPE, text=True)
        exported = sorted(re.findall(r" T (\w+)", lines.stdout))
        with open(SOURCES + "/src/faces/c_interface/slipproof.h", encoding="ascii") as header:
            promised = sorted(re.findall(r"^SLIPPROOF_API [^(]*?(\w+)\(", header.read(), re.MULTILINE))
        self.assertEqual(exported, promised)
        others = [line for line in lines.stdout.splitlines() if not re.search(r" (T slipproof_|A SLIPPROOF_)", line)]
        self.assertEqual(others, [])

    def test_version(self):
        self.assertEqual(b"slipproof " + lib.slipproof_version() + b"\n", program("--version"))


class Solving(unittest.TestCase):
    SCENES = sorted(glob.glob(SOURCES + "/cases/*.toml") + glob.glob(SOURCES + "/cases/mechanisms/scenes/*.toml"))

    def test_scenes_are_solved_as_by_the_program(self):
        self.assertGreater(len(self.SCENES), 25)
        for path in self.SCENES:
            with self.subTest(path):
                solution = Solution(path)
                self.assertEqual(solution.json(), program("solve", "--json", "--quiet", path))
                self.agrees(solution, json.loads(solution.json()))

    def agrees(self, solution, document):
        self.assertEqual(lib.slipproof_solution_name(solution.handle).decode(), document["scene"])
        motions = [m for m in solution.array("motions") if not m.continuum]
        self.assertEqual(len(motions), len(document.get("motions", [])))
        for motion, expected in zip(motions, document.get("motions", [])):
            self.assertEqual(sorted(modes(motion)), sorted(expected["modes"] + expected.get("boundary_modes", [])))
            self.assertEqual(bool(motion.strict), expected["status"] == "strict")
            self.values_agree(motion, expected)
        at_load = "motions" in document
        self.assertEqual(sum(m.continuum for m in solution.array("motions")),
                         len(document["continua"]) if at_load else 0)
        self.assertEqual([r.mode.decode() for r in solution.array("rejections")],
                         [r["mode"] for r in document.get("rejected", [])])
        for rejection, expected in zip(solution.array("rejections"), document.get("rejected", [])):
            self.assertEqual(rejection.margin and rejection.margin.decode(), expected.get("margin"))
            self.assertTrue(rejection.violated)
        ranges = [(r.mode.decode(), ends(r.loads), [bool(r.loads.lower_closed), bool(r.loads.upper_closed)])
                  for r in solution.array("ranges")]
        self.assertEqual(ranges, [(r["mode"], r["load"], r["closed"])
                                  for r in document.get("ranges", [])])
        cells = solution.array("cells")
        self.assertEqual(bool(cells), not at_load)
        if "cells" in document:
            self.assertEqual([ends(cell.loads) for cell in cells], [cell["load"] for cell in document["cells"]])
            self.assertEqual([[modes(m) for m in cell.motions[:cell.motion_count]] for cell in cells],
                             [[m["modes"] or m["boundary_modes"] for m in cell["motions"]] +
                              [[m] for m in cell["continua"]]
                              for cell in document["cells"]])

    def values_agree(self, motion, expected):
        numbers = {**expected, **expected.get("accelerations", {}), **expected.get("forces", {})}
        intervals = expected.get("force_ranges", {})
        for value in motion.values[:motion.value_count]:
            name = value.name.decode()
            lower, upper = ends(value.range)
            self.assertEqual([lower, upper], intervals.get(name) or [numbers[name]] * 2)
            if lower:
                self.assertEqual(value.range.nearest_lower, nearest(lower))
            self.assertEqual(value.range.nearest_upper, nearest(upper) if upper else math.inf)

    def test_a_file_that_is_not_there(self):
        with self.assertRaisesRegex(ValueError, "no-such.toml: "):
            Solution("no-such.toml")

    def test_threads_share_a_solution(self):
        path = SOURCES + "/cases/ambiguous.toml"
        solution, expected, found = Solution(path), program("solve", "--json", "--quiet", path), []

        def work():
            found.extend(Solution(path).json() for _ in range(20))
            found.append(solution.json())

        threads = [threading.Thread(target=work) for _ in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(found, [expected] * 84)


def doubles(values):
    return None if values is None else (c.c_double * len(values))(*values)


def judged(dimension, W, q, mu, z, w=None):
    """(status, message or judgement, line)"""
    flat = [x for row in W for x in row]
    problem = Problem(len(q), dimension, *map(doubles, (flat, q, mu, z, w)))
    verdict, error = handle(), handle()
    status = lib.slipproof_certify(c.byref(problem), None, c.byref(verdict), c.byref(error))
    if status != 0:
        message = lib.slipproof_error_message(error).decode()
        lib.slipproof_error_free(error)
        return status, message, None
    found = lib.slipproof_verdict_judgement(verdict)
    line = json.loads(found.json)
    result = (found.verdict.decode(), bool(found.certified), found.error, found.backward_error)
    lib.slipproof_verdict_free(verdict)
    return status, result, line


class Certifying(unittest.TestCase):
    def test_records_as_by_the_program(self):
        records, lines = [], []
        with open(SOURCES + "/cases/contact-problems/examples.jsonl", encoding="ascii") as file:
            for line in file:
                record = json.loads(line)
                numbers = sum(record.get("W", record.get("M")), []) + record["q"] + record["z"] + record.get("w", [])
                if all(isinstance(x, (int, float)) for x in numbers) and "mode" not in record:
                    records.append(record)
                    lines.append(json.dumps(record))
        answers = program("certify", "--json", "--format", "jsonl", "-", input="\n".join(lines).encode(),
                          stderr=subprocess.DEVNULL)
        self.assertGreater(len(records), 4)
        for record, answer in zip(records, map(json.loads, answers.splitlines())):
            mu = record.get("mu")
            if isinstance(mu, (int, float)):
                mu = [mu] * (len(record["q"]) // 2)
            _, found, line = judged(2 if mu else 1, record.get("W", record.get("M")), record["q"], mu, record["z"],
                                    record.get("w"))
            answer["record"] = 1
            self.assertEqual(line, answer)
            self.assertEqual(found[0], answer["verdict"])
            self.assertEqual(found[1], answer["verdict"] == "certified")

    def test_a_spatial_problem_as_by_the_program(self):
        path = SOURCES + "/cases/contact-problems/pushed-block.json"
        with open(path, encoding="ascii") as file:
            p = json.load(file)
        W = [[0.0] * len(p["q"]) for _ in p["q"]]
        if isinstance(p["W"], dict):
            for i, j, x in p["W"]["entries"]:
                W[i][j] = x
        else:
            W = p["W"]
        mu = p["mu"] if isinstance(p["mu"], list) else [p["mu"]] * (len(p["q"]) // 3)
        _, found, line = judged(3, W, p["q"], mu, p["r"], p.get("u"))
        expected = json.loads(program("certify", "--json", path, stderr=subprocess.DEVNULL))
        for key in ("verdict", "rho", "backward_error", "worst", "undetermined_forces"):
            self.assertEqual(line[key], expected[key])
        self.assertEqual(found[:2], ("solution within rho", True))
        self.assertAlmostEqual(found[2] / float(expected["rho"]), 1, 2)

    def test_what_cannot_be_judged(self):
        identity, nan = [[1, 0], [0, 1]], math.nan
        for arguments, message in [
                ((4, identity, [1, 1], None, [0, 0]), "dimension: found 4, expected 1, 2 or 3"),
                ((3, identity, [1, 1], [1], [0, 0]), "size: found 2, expected a multiple of 3 that is not 0"),
                ((1, [], [], None, []), "size: found 0, expected a multiple of 1 that is not 0"),
                ((1, identity, [1, 1], None, None), "z: found NULL, expected a pointer"),
                ((2, identity, [1, 1], None, [0, 0]), "mu: found NULL, expected a pointer"),
                ((1, identity, [1, 1], [1, 1], [0, 0]), "mu: found coefficients, expected NULL in dimension 1"),
                ((2, identity, [1, 1], [-1], [0, 0]), "mu"),
                ((1, [[1, nan], [0, 1]], [1, 1], None, [0, 0]), "W"),
                ((1, identity, [1, math.inf], None, [0, 0]), "q"),
        ]:
            with self.subTest(message):
                status, found, _ = judged(*arguments)
                self.assertEqual(status, 2)
                self.assertIn(message, found)

    def test_no_finite_answer_is_invalid(self):
        for z in ([math.nan, 0], [0, -math.inf]):
            self.assertEqual(judged(1, [[1, 0], [0, 1]], [1, 1], None, z)[1][:2], ("invalid", False))
        self.assertEqual(judged(3, [[1, 0, 0], [0, 1, 0], [0, 0, 1]], [-1, 0, 0], [1], [math.nan, 0, 0])[1][0], "invalid")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
