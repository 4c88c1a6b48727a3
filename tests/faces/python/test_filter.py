"""Batches of bicycles against the exact solver, one scene at a time."""

import numpy as np
import pytest

import slipproof


def modes_of(scene):
    """By the solver."""
    solution = slipproof.solve(kind="internal", **scene)
    found = {mode for m in solution.motions for mode in m.all_modes}
    return found | {c.mode for c in solution.continua}


def test_masks_are_the_solvers(random_scenes):
    columns = random_scenes(150)
    found = slipproof.consistent_modes(**columns, threads=1)
    assert found.consistent.dtype == np.uint16 and found.consistent.shape == (150,)
    for i in range(150):
        scene = {name: float(values[i]) for name, values in columns.items()}
        assert set(found.names(i)) == modes_of(scene)
    assert sum(found.tiers.values()) == 150
    assert [int(n) for n in np.bincount(found.tier, minlength=2)] == list(found.tiers.values())
    assert not (found.strict & ~found.consistent).any()


def test_any_layout_gives_the_same(random_scenes):
    columns = random_scenes(40)
    expected = slipproof.consistent_modes(**columns)
    table = np.zeros(40, dtype=[(name, "f8") for name in columns])
    for name, values in columns.items():
        table[name] = values
    forms = [
        {name: table[name] for name in columns},  # strides
        {name: values[::-1][::-1] for name, values in columns.items()},
        {name: values.astype(">f8") for name, values in columns.items()},
        {name: values.tolist() for name, values in columns.items()},
        {**columns, "g": 9.81},
        {**columns, "g": [9.81], "F": columns["F"].astype(np.int32), "M": columns["M"].astype(np.float32)},
    ]
    for form in forms:
        found = slipproof.consistent_modes(**form)
        assert (found.consistent == expected.consistent).all() and (found.strict == expected.strict).all()
    back = slipproof.consistent_modes(**{name: values[::-1] for name, values in columns.items()})
    assert (back.consistent[::-1] == expected.consistent).all()


def test_contiguous_columns_are_not_copied():
    from slipproof._arrays import doubles

    column = np.arange(5.0)
    assert np.shares_memory(doubles("F", column, (1,)), column)
    assert not np.shares_memory(doubles("F", column[::-1], (1,)), column)


def test_nothing_and_one_scene(random_scenes):
    empty = {name: values[:0] for name, values in random_scenes(3).items()}
    assert slipproof.consistent_modes(**empty).consistent.shape == (0,)
    one = {name: float(values[0]) for name, values in random_scenes(3).items()}
    assert slipproof.consistent_modes(**one).consistent.shape == (1,)


def test_without_J_no_wheel_lifts(random_scenes):
    columns = random_scenes(50)
    del columns["J"]
    found = slipproof.consistent_modes(**columns)
    on_road = sum(1 << i for i, mode in enumerate(slipproof.MODES) if "lift" not in mode)
    assert not (found.consistent & ~np.uint16(on_road)).any() and found.consistent.any()


def test_an_external_force_is_another_force(random_scenes):
    columns = random_scenes(200)
    inside, outside = (slipproof.consistent_modes(**columns, kind=kind) for kind in ("internal", "external"))
    assert (inside.consistent != outside.consistent).any()


@pytest.mark.parametrize("name, value, message", [
    ("M", 0.0, "bicycle 1: M: found 0, expected M > 0"),
    ("R", -1.0, "bicycle 1: R: found -1, expected R > 0"),
    ("I2", -0.5, "bicycle 1: I2: found -0.5, expected I2 >= 0"),
    ("J", 0.0, "bicycle 1: J: found 0, expected J > 0"),
    ("f", -0.1, "bicycle 1: f: found -0.1, expected f >= 0"),
    ("h", -9.0, "bicycle 1: h: found -9, expected h > -R"),
    ("b2", -9.0, "expected b2 + b3 > 0"),
    ("g", float("nan"), "bicycle 1: g: found NaN, expected a finite number"),
    ("F", float("nan"), "found "),
    ("L", float("inf"), "found "),
])
def test_numbers_out_of_the_domain_are_named(random_scenes, name, value, message):
    columns = random_scenes(3)
    columns[name][1] = value
    with pytest.raises(ValueError) as error:
        slipproof.consistent_modes(**columns)
    assert message in str(error.value)
