#!/usr/bin/env python3
"""Random structures in the plane: what `slipproof rest` says against linear programs of another kind.

    planar.py SLIPPROOF COUNT [SIZE] [--qsopt] [--seed N]

Whether it can rest, whether it is at the limit, and the interval of the load must be exactly those of the programs; and
the forces or the motion told must prove the answer. Without --qsopt the programs are solved here, by fractions.
"""
import sys

import asking
import programs
import random_planar
import reader


def differences(solver, structure, answer):
    out = [message] if (message := reader.wrong(structure, answer)) else []
    can = programs.can_rest(solver, structure)
    if answer["can_rest"] is not can:
        out.append(f"found can_rest {answer['can_rest']}, expected {can}")
    elif can and answer["touching"] is not programs.touches(solver, structure):
        out.append(f"found touching {answer['touching']}, expected the other")
    if structure.load is not None:
        expected = programs.loads(solver, structure)
        told = answer["load"]
        found = None if told["none"] else [reader.exact_end(told["from"]), reader.exact_end(told["to"])]
        if found != expected:
            out.append(f"found loads {found}, expected {expected}")
    return out


def main():
    chosen = asking.options("--qsopt")
    solver = programs.QSopt() if chosen.qsopt else programs.Simplex()
    if chosen.qsopt and not solver.there():
        print("needs esolver, of Debian's qsopt-ex")
        sys.exit(77)
    asking.compare(chosen, random_planar.structure, lambda s, answer: differences(solver, s, answer))


main()
