"""Scenes in space: bodies with vectors of three components, all motions, and answers about them."""

import pickle
from fractions import Fraction

import pytest

import slipproof
from slipproof import Body, Contact, Force, Mechanism
from slipproof.testing import assert_motion


def sledge(**options):
    """A particle on the floor that is pulled along (3, 4)."""
    return Mechanism.of("sledge", gravity=[0, 0, -10], load={"symbol": "F"}, parameters={"mu": "mu >= 0"},
                        bodies=[Body("sledge", mass=2, inertia=[1, 1, 1], at=[0, 0, 0], turning=None)],
                        contacts=[Contact("runner", "sledge", [0, 0, 0], normal=[0, 0, 1], through=[0, 0, 0],
                                          friction="mu", tangent=[1, 0, 0])],
                        forces=[Force("sledge", ["3/5*F", "4/5*F", 0])], **options)


def test_a_mechanism_of_vectors_with_three_components_is_in_space(program, tmp_path):
    assert sledge().dimension == 3 and sledge(dimension=3).elements == ("runner",)
    assert Mechanism.parse(sledge().to_dict()).dimension == 3 and Mechanism.load("ladder").dimension == 2
    assert "T2_runner" in sledge().show()
    domino = "cases/space/mechanisms/domino.toml"
    assert Mechanism.load(domino).show() == program("show", domino, parse=False)
    path = tmp_path / "sledge.toml"
    path.write_text(sledge().scene({"mu": "1/2"}, load=30).to_toml())
    solution = sledge().solve({"mu": "1/2"}, load=30)
    assert program("solve", "--json", path)["motions"] == solution.to_dict()["motions"]


def test_motions_are_those_of_coulombs_law_by_hand():
    stays = sledge().solve({"mu": "1/2"}, load=9)
    assert stays.complete and stays.only and [m.modes for m in stays] == [("stick",)]
    assert (stays.motions[0].T1_runner, stays.motions[0].T2_runner) == (-9 * Fraction(3, 5), -9 * Fraction(4, 5))
    slides = sledge().solve({"mu": "1/2"}, load=30).motions[0]
    acceleration = Fraction(30 - 10, 2)  # N = 20, so friction takes 10 along the pull
    for name, share in (("ax", Fraction(3, 5)), ("ay", Fraction(4, 5))):
        lower, upper = slides.accelerations[name] if isinstance(slides.accelerations[name], tuple) else [slides.accelerations[name]] * 2
        assert lower <= share * acceleration <= upper and upper - lower < 1e-9
    lower, upper = slides.slips["runner"]
    assert lower < 53.13010235415598 < upper and upper - lower < 1e-8
    assert slides.exists and slides.unique and slides.open_directions == 0 and slides.others_within is None


def test_what_is_exact_is_a_fraction_and_what_is_open_is_none():
    stool = slipproof.solve("cases/space/stool-tipping.toml")
    assert max(abs(x) for x in (stool.motions[0].alphax, stool.motions[0].alphay)) == Fraction(538, 275)
    cube = slipproof.solve("cases/space/cube-pushed-obliquely.toml")
    assert cube.complete and not cube.only and not any(motion.unique for motion in cube)
    assert isinstance(cube.motions[0].ax, slipproof.Bounds) and cube.motions[0].ax.lower < cube.motions[0].ax.upper
    assert pickle.loads(pickle.dumps(cube)).motions == cube.motions
    assert repr(cube).startswith("<slipproof.Solution of 'cube pushed obliquely': s COMPLETE motions")


def test_the_document_is_that_of_the_program(program):
    scene = "cases/space/domino.toml"
    solution = slipproof.solve(scene)
    assert solution.to_json().strip() == program("solve", "--json", scene, parse=False).strip()
    assert solution.text() == program("solve", scene, parse=False)
    straight = solution.scene.replace(mu="0.2").solve()
    assert [m.modes for m in solution] != [m.modes for m in straight] == [("lift/stick/stick/lift",)]


def test_answers_are_compared_with_the_whole_range():
    solution = sledge().solve({"mu": "1/2"}, load=30)
    assert assert_motion(solution, {"ax": 6, "ay": 8, "N_runner": 20}, only=True).modes == ("slip",)
    with pytest.raises(AssertionError, match="the nearest is off by .*, ay: found 7, expected"):
        assert_motion(solution, {"ax": 6, "ay": 7})
    with pytest.raises(AssertionError):
        assert_motion(solution, {"ax": 6, "ay": 8}, tolerance=0)  # the range is wider than nothing
    with pytest.raises(AssertionError, match="others are not excluded|the answer is one of them"):
        cube = slipproof.solve("cases/space/cube-pushed-obliquely.toml")
        ax = cube.motions[0].ax
        assert_motion(cube, {"ax": (ax.lower + ax.upper) / 2}, only=True)


def test_records_and_searches_are_those_of_the_program(program, tmp_path):
    records = tmp_path / "records.csv"
    records.write_text("F,ax,ay,az,alphax,alphay,alphaz\n30,6,8,0,0,0,0\n9,0,0,0,0,0,0\n30,8,6,0,0,0,0\n")
    scene = tmp_path / "sledge.toml"
    scene.write_text(sledge().scene({"mu": "1/2"}).to_toml())
    verdicts = slipproof.certify_file(records, scene=scene)
    assert list(verdicts.verdicts) == ["certified", "certified", "wrong"]
    found = sledge().search(samples=4)
    assert found.verdict == "none found" and found.to_dict()["one"] == 4 and found.to_dict()["undecided"] == 0
    assert slipproof.search("cases/space/mechanisms/leaning-rod.toml", samples=3, within="F = 3 and mu = 1 and g = 10").verdict == "found"


def test_what_is_in_the_plane_only_says_so():
    with pytest.raises(slipproof.InputError, match="found a mechanism in space, expected one in the plane"):
        slipproof.critical("cases/space/domino.toml")
    with pytest.raises(slipproof.InputError, match="load"):
        sledge().solve({"mu": "1/2"})


def test_rest_is_the_document_of_the_program(program, tmp_path):
    board = "cases/rest/block-on-board.toml"
    rest = slipproof.Scene.load(board).rest(tilt=(1, 0, 0))
    assert rest.to_dict() == program("rest", "--json", "--tilt", "1,0,0", board)
    assert rest.can_rest and rest.tilt == Fraction(1, 2) and rest.fall is None and pickle.loads(pickle.dumps(rest)) == rest
    wedge = slipproof.Scene.load("cases/rest/wedge-in-groove.toml").rest()
    assert wedge.can_rest and wedge.must_rest is False and "motion" in wedge.because
    slope = slipproof.Scene.load("cases/rest/block-on-slope.toml").rest(parameter="mu_s")
    assert slope.parameter == (Fraction(3, 4), None)
    table = "cases/rest/table-pulled-at-its-edge.toml"
    assert slipproof.Scene.load(table).rest().map is None
    pulled = slipproof.Scene.load(table).rest(map=("H", "P"))
    assert pulled.to_dict() == program("rest", "--json", "--map", "H", "P", table)
    assert pulled.map.exact and pulled.map.inside[2] == (Fraction(80, 7), Fraction(-240, 7))
    assert set(pulled.map.around) == set(pulled.map.inside) and pickle.loads(pickle.dumps(pulled)).map == pulled.map
    program("rest", "--quiet", "--map", "H", "P", "-o", str(tmp_path / "map.svg"), table, parse=False)
    assert pulled.map.svg == (tmp_path / "map.svg").read_text()
    framed = slipproof.Scene.load(table).rest(map=("H", "P"), x_range=(0, 20), y_range=(-10, 10)).map
    assert set(framed.inside) == {(0, -10), (0, 10), (17.5, -10), (20, 0), (20, 10)}
    for wrong in ({"map": "HP"}, {"map": ("H",)}, {"x_range": (0, 1)}, {"map": ("H", "P"), "x_range": (1, 1)}):
        with pytest.raises(ValueError, match="map|x_range"):
            slipproof.Scene.load(table).rest(**wrong)
    with pytest.raises(slipproof.InputError, match="mu"):
        slipproof.Scene.load(table).rest(map=("H", "mu"))
    for axis in (True, (1, 0)):
        with pytest.raises(ValueError, match="tilt"):
            slipproof.Scene.load(board).rest(tilt=axis)
