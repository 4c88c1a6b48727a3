"""Records in memory: the program's verdicts on the recordings of real solvers."""

import csv
import json

import numpy as np
import pytest

import slipproof


def columns(path):
    with open(path, newline="") as file:
        rows = list(csv.DictReader(file))
    return {name: [row[name] for row in rows] if name == "mode" else np.array([float(row[name]) for row in rows])
            for name in rows[0]}


def test_recordings_of_solvers_get_the_programs_verdicts(source, program):
    files = sorted((source / "cases/solvers").glob("*.csv"))
    assert len(files) > 8
    for path in files:
        lines = program("certify", path, "--ignore-unknown", "--json", parse=False).splitlines()
        expected = [json.loads(line) for line in lines]
        found = slipproof.certify_bicycles(columns(path), ignore_unknown=True)
        assert list(found.verdicts) == [d["verdict"] for d in expected], path
        for i in range(0, len(expected), 37):
            if expected[i]["verdict"] != "invalid":  # there the place is a line of the file
                assert found[i].to_dict() == expected[i]


def test_arrays_frames_and_dicts_are_the_same(source):
    given = columns("cases/solvers/siconos-fc2d-lemke.csv")
    del given["info"]
    expected = slipproof.certify_bicycles(given)
    numbers = [name for name in given if name != "mode"]
    table = np.zeros(len(expected), dtype=[(name, "f8") for name in numbers] + [("mode", "U16")])
    for name in given:
        table[name] = given[name]
    found = [slipproof.certify_bicycles(table), slipproof.certify_bicycles(given, threads=1)]
    pandas = pytest.importorskip("pandas")
    found.append(slipproof.certify_bicycles(pandas.DataFrame(given)))
    found.append(slipproof.certify_bicycles(pandas.DataFrame(given).replace({"mode": {"": None}})))
    nothing = {**given, "mode": np.full(len(expected), np.nan)}
    without = slipproof.certify_bicycles({name: given[name] for name in numbers})
    assert (slipproof.certify_bicycles(nothing).codes == without.codes).all()
    for other in found:
        assert (other.codes == expected.codes).all() and (other.modes == expected.modes).all()
        assert other.summary == expected.summary
    assert sum(expected.counts().values()) == len(expected)


def test_a_structured_array_is_not_copied():
    table = np.zeros(4, dtype=[("pad", "u1"), ("a", "f8")])
    from slipproof._bicycles import _numbers

    assert np.shares_memory(_numbers("a", table["a"]), table)


def test_an_answer_is_told_in_full():
    scene = slipproof.Scene.load("cases/ambiguous.toml")
    motion = scene.solve().motions[0]
    answer = {name: [float(motion.values[name])] for name in ("a", "S2", "S3", "N2", "N3")}
    found = slipproof.certify_bicycles({**answer, "F": [3.27]}, scene=scene)
    assert found[0].verdict == "ambiguous" and found[0].motions == 3
    answer["a"][0] = float("nan")
    assert slipproof.certify_bicycles({**answer, "F": [3.27]}, scene=scene).counts() == {"invalid": 1}
