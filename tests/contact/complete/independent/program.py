"""`slipproof certify --all`, called with JSON Lines, and what it tells of each problem."""
import json
import subprocess
import tempfile
import time
from dataclasses import dataclass, field
from fractions import Fraction
from pathlib import Path


@dataclass
class Solution:
    modes: tuple  # a state for each contact
    r: list  # ranges (lower, upper)
    u: list
    strict: bool
    parameters: int = 0  # of a family


@dataclass
class Told:
    complete: bool
    solutions: list = field(default_factory=list)
    reason: str = ""
    verdict: str = ""
    failed: bool = False  # the program ended without a line


def exact(number):
    assert Fraction(float(number)) == number, f"{number} is not exact in binary64"
    return str(number)


def line_of(problem):
    """With the answer that all forces are 0, if the problem has none: without one the program looks for one."""
    answer = problem.answer or [0] * problem.size
    return json.dumps({"dimension": 3, "W": [[exact(x) for x in row] for row in problem.W],
                       "q": [exact(x) for x in problem.q], "mu": [exact(m) for m in problem.mu], "r": [exact(x) for x in answer]})


def range_of(told):
    if isinstance(told, str):
        return Fraction(told), Fraction(told)
    return tuple(None if end is None else Fraction(end) for end in told)


def read_line(line, dimension=3):
    """The program's line of a problem. A family is told by one of its members; `all_w` has the velocities of all that
    one stands for, where these are not its own."""
    if line.get("reason") and "all" not in line and line["verdict"] in ("invalid", "undecided"):
        return Told(False, reason=line["reason"], verdict=line["verdict"])
    if "all" not in line:
        return Told(False, reason="; ".join(line.get("left_out", ["nothing is told"])), verdict=line["verdict"])
    told = Told(True, verdict=line["verdict"])
    for s in line["all"]["found"]:
        told.solutions.append(Solution(tuple(s["modes"][0].split("/")), [range_of(x) for x in s["z"]],
                                       [range_of(x) for x in s.get("all_w", s["w"])], s["status"] == "strict"))
    for s in line["all"].get("continua", []):
        told.solutions.append(Solution(tuple(s["mode"].split("/")), [range_of(x) for x in s["nearest_z"]],
                                       [range_of(x) for x in s.get("all_w", s["w"])], False, s["parameters"]))
    assert len([s for s in told.solutions if s.parameters == 0]) == line["all"]["solutions"]
    return told


def run(program, problems, options):
    """The program's lines; None if it ended before the last."""
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "problems.jsonl"
        file.write_text("".join(line_of(p) + "\n" for p in problems))
        done = subprocess.run([program, "certify", str(file), "--all", "--threads", "1", *options], capture_output=True,
                              text=True)
    lines = [json.loads(line) for line in done.stdout.splitlines() if line.startswith('{"record"')]
    return (lines if len(lines) == len(problems) else None), f"exit code {done.returncode}: {done.stderr.strip()[-200:]}"


def told_of(program, problems, options):
    lines, end = run(program, problems, options)
    if lines is not None:
        return [read_line(line) for line in lines]
    if len(problems) == 1:
        return [Told(False, reason=end, failed=True)]
    half = len(problems) // 2
    return told_of(program, problems[:half], options) + told_of(program, problems[half:], options)


def certify_all(program, problems, options=()):
    """What is told of each, in order, and the seconds it took. Where the program fails, it is called again with fewer."""
    begin = time.monotonic()
    return told_of(program, problems, options), time.monotonic() - begin
