"""Scenes: the same as the program, in Fractions."""

import pickle
from decimal import Decimal
from fractions import Fraction

import pytest

import slipproof

CITY = dict(R=Fraction(34, 100), h0="1.05", b2="0.45", b3="0.60", I1=0, I2="0.12", I3="0.12", r1="0.09", r2="0.045",
            L="0.17", M=85, J=12, f="0.8", g="9.81", kind="internal")


def scene_files(source):
    return sorted((source / "cases").glob("*.toml")) + sorted((source / "cases/mechanisms/scenes").glob("*.toml"))


def test_every_shipped_scene_gives_the_programs_document(source, program):
    files = scene_files(source)
    assert len(files) > 20
    for path in files:
        name = str(path.relative_to(source))
        assert slipproof.solve(name).to_json() == program("solve", "--json", name, parse=False), name


def test_objects_say_what_the_document_says(source):
    for path in scene_files(source):
        solution = slipproof.solve(path)
        document = solution.to_dict()
        assert [r.mode for r in solution.ranges] == [r["mode"] for r in document.get("ranges", [])]
        if "motions" not in document:
            continue
        for motion, d in zip(solution.motions, document["motions"], strict=True):
            assert [*motion.modes] == d["modes"] and motion.status == d["status"]
            texts = {**d["accelerations"], **d["forces"]}
            for name, number in motion.values.items():
                assert number == Fraction(texts[name]) and isinstance(number, Fraction)
        for rejected, d in zip(solution.rejected, document["rejected"], strict=True):
            assert (rejected.mode, rejected.violated) == (d["mode"], d["violated"])


def test_numbers_in_any_form_are_the_same_number():
    expected = slipproof.solve(**CITY, F="300").to_dict()
    for F in (300, 300.0, Fraction(600, 2), Decimal("300.0"), "600/2", "0x12C"):
        assert slipproof.solve(**CITY, F=F).to_dict() == expected


def test_a_float_is_taken_exactly():
    assert slipproof.solve(**CITY, F=0.1).load == Fraction(0.1) != Fraction(1, 10)
    assert slipproof.solve(**CITY, F="0.1").load == Fraction(1, 10)


def test_numpy_scalars_are_numbers():
    np = pytest.importorskip("numpy")
    assert slipproof.solve(**CITY, F=np.float32(0.1)).load == Fraction(float(np.float32(0.1)))
    assert slipproof.solve(**CITY, F=np.int64(7)).load == 7


def test_numbers_longer_than_python_prints_go_through():
    long = Fraction(10**3000 + 1, 10**3000)
    assert slipproof.solve(**CITY, F=long).load == long
    quotient = Fraction(1, 7**11000)  # 9297 digits: more than Python's str() allows
    assert slipproof.solve(**CITY, F=quotient).motions[0].a.denominator > 10**4300


def test_dict_file_and_keywords_are_the_same_scene(source):
    path = "cases/city-bicycle.toml"
    scene = slipproof.Scene.load(path)
    again = slipproof.Scene(scene.to_dict())
    flat = {k: v for t in scene.to_dict().values() if isinstance(t, dict) for k, v in t.items()}
    document = scene.solve().to_dict()
    assert again.solve().to_dict() == document
    assert slipproof.solve(name=scene.name, **flat).to_dict() == document
    assert pickle.loads(pickle.dumps(scene)).solve().to_dict() == document


def test_replace_changes_one_number_and_not_the_scene():
    scene = slipproof.Scene.load("cases/city-bicycle.toml")
    before = scene.solve().to_dict()
    assert scene.replace(F=7).solve().load == 7
    assert scene.replace(F=None).solve().load is None
    assert scene.solve().to_dict() == before
    ladder = slipproof.Scene.load("cases/mechanisms/scenes/ladder.toml")
    assert ladder.replace(W=7).solve().load == 7


def test_cells_of_all_loads_cover_the_line_and_hold_at_samples():
    for scene in (slipproof.Scene(**CITY),
                  slipproof.Scene.load("cases/mechanisms/scenes/ladder.toml").replace(W=None)):
        solution = scene.solve()
        cells = solution.cells
        assert cells
        for left, right in zip(cells, cells[1:]):
            assert left.loads.upper == right.loads.lower
            assert left.loads.upper_closed != right.loads.lower_closed
        for cell in cells:
            lower, upper = cell.loads.lower, cell.loads.upper
            load = (lower if upper is None or lower == upper else upper) or Fraction(0)
            if lower != upper:
                load = load - 1 if lower is None else load + 1 if upper is None else (lower + upper) / 2
            assert load in cell.loads
            there = scene.replace(**{solution.load_symbol: load}).solve()
            found = sorted((m.modes, [x(load) for x in m.values.values()]) for m in cell.motions)
            expected = sorted((m.modes, [m.values[n] for n in c.values]) for m in there.motions
                              for c in cell.motions if c.modes == m.modes)
            assert len(cell.motions) == len(there.motions)
            assert found == expected


def test_a_scene_without_a_force_has_no_motions_but_says_so():
    with pytest.raises(ValueError, match="found no F in the scene, expected one for motions"):
        slipproof.solve(**CITY).motions  # noqa: B018


def test_continua_have_ranges():
    assert slipproof.solve("cases/reduced-form.toml").continua == ()
    braked, rolling = slipproof.solve("cases/mechanisms/scenes/three-axles.toml").continua
    assert (braked.mode, rolling.mode) == ("stick/slip-/stick", "slip+/stick/stick")
    # They meet where no axle slips.
    assert braked.ranges["ax"] == (0, Fraction(25, 17)) and rolling.ranges["ax"] == (Fraction(25, 17), Fraction(225, 152))
    assert braked.ranges["N_middle"][0] == 0 < rolling.ranges["N_middle"][0]


def test_ranges_contain_their_loads():
    solution = slipproof.solve("cases/ambiguous.toml")
    consistent = {r.mode for r in solution.ranges if solution.load in r.loads}
    assert {mode for m in solution.motions for mode in m.all_modes} == consistent


def test_a_mechanism_by_name_and_by_scene(source):
    ladder = slipproof.Mechanism.load("ladder")
    assert ladder.load_symbol == "W" and ladder.angles == ("theta",) and ladder.elements == ("floor", "wall")
    values = dict(m=12, l=2, I=16, d=1, mu_f="0.5", mu_w="0.2", g="9.81", theta={"tan_half": "1/2"})
    by_scene = slipproof.solve("cases/mechanisms/scenes/ladder.toml")
    assert ladder.solve(values, load=100).to_dict()["motions"] == by_scene.to_dict()["motions"]
    assert ladder.solve(values).cells
    assert "ladder" in slipproof.shipped_mechanisms()
    assert "floor" in ladder.show()
    undetermined = ladder.solve(values, load=100).motions[0].force_ranges
    assert all(low < high for low, high in undetermined.values()) and undetermined


def test_notebooks_get_a_table_and_a_phase_line(source):
    for path in ("cases/ambiguous.toml", "cases/touring-bicycle.toml", "cases/mechanisms/scenes/ladder.toml",
                 "cases/mechanisms/scenes/painleve-rod.toml"):
        html = slipproof.solve(path)._repr_html_()
        assert html.startswith("<table>")
        from xml.dom.minidom import parseString
        parseString(f"<html>{html}</html>")
    assert "<svg" in slipproof.solve("cases/touring-bicycle.toml")._repr_html_()


def test_text_is_the_programs(program):
    path = "cases/touring-bicycle.toml"
    assert slipproof.solve(path).text() == program("solve", path, parse=False)
