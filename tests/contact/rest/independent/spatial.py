#!/usr/bin/env python3
"""Random structures in space: the proofs in what `slipproof rest` says are read, and its loads compared with CVXOPT's.

    spatial.py SLIPPROOF COUNT [SIZE] [--cvxopt] [--seed N]

Forces must balance and lie in their cones, a motion must prove that there are none, exactly. With --cvxopt the ends of
the load's interval must contain those of the second-order cone programs, within what floating point leaves open.
"""
import sys

import asking
import random_spatial
import reader

WITHIN = 1e-6
EFFORT = "200000000"  # not much: whether it must rest is not asked here


def outside(told, status, value):
    """How CVXOPT's end contradicts the one that is told, or ""."""
    if status == "unknown":
        return ""
    if status == "unbounded":
        return "" if told is None else f"found the end {told}, and CVXOPT none"
    if told is None:
        return "" if abs(value) > 1e6 else f"found no end, and CVXOPT {value}"
    lower, upper = (float(x) for x in told)
    slack = WITHIN * max(1.0, abs(value))
    return "" if lower - slack <= value <= upper + slack else f"found the end [{lower}, {upper}], and CVXOPT {value}"


def load_differences(structure, told):
    import cones
    out = [] if told["decided"] else ["found no ends"]
    for sign, key in ((-1, "from"), (1, "to")):
        status, value = cones.extreme(structure, sign)
        if told["none"] or status == "infeasible":
            if not told["none"] or status == "optimal":  # "unbounded" is a direction, which needs no load to start from
                out.append(f"found {told}, and CVXOPT {status} {value}")
        elif told["decided"] and (message := outside(reader.ends(told[key]), status, value)):
            out.append(f"{key}: {message}")
    return out


def differences(structure, answer, compare_loads):
    out = [message] if (message := reader.wrong(structure, answer)) else []
    if answer["can_rest"] is None:
        out.append("found no answer")
    if compare_loads and structure.load is not None:
        out += load_differences(structure, answer["load"])
    return out


def main():
    chosen = asking.options("--cvxopt")
    if chosen.cvxopt:
        try:
            import cvxopt  # noqa: F401
        except ImportError:
            print("needs Debian's python3-cvxopt")
            sys.exit(77)
    asking.compare(chosen, random_spatial.structure, lambda s, answer: differences(s, answer, chosen.cvxopt),
                   "--effort", EFFORT)


main()
