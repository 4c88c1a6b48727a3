"""What cannot be used is refused with the exception, the place, what was found and what was expected."""

import numpy as np
import pytest

import slipproof

W2 = np.eye(2)
GOOD = dict(M=94, R=0.3, h=0.56, b2=0.34, b3=0.68, I1=0.01, I2=0.12, I3=0.2, r1=0.09, r2=0.036, L=0.17, J=15.7, f=0.8,
            g=9.81, F=300.0)
SCENE = "cases/city-bicycle.toml"
LADDER = dict(m=12, l=2, I=16, d=1, mu_f="0.5", mu_w="0.2", g="9.81", theta={"tan_half": "1/2"})
RECORD = dict(F=[3.27], a=[3.0], S2=[3.0], S3=[0.0], N2=[9.0], N3=[0.1])


def modes(**changes):
    return lambda: slipproof.consistent_modes(**{**GOOD, **changes})


def solve(*scene, **changes):
    return lambda: slipproof.solve(*scene, **changes)


def certify(*arguments, **options):
    return lambda: slipproof.certify(*arguments, **options)


def bicycles(without=(), **changes):
    given = {k: v for k, v in {**RECORD, **changes}.items() if k not in without}
    return lambda: slipproof.certify_bicycles(given, scene="cases/ambiguous.toml")


class Broken:
    """A sparse matrix that is none."""

    shape = (2, 2)

    def __init__(self, indptr, indices, data=(1.0, 1.0)):
        self.indptr, self.indices, self.data = np.array(indptr), np.array(indices), np.array(data)

    def tocsr(self):
        return self


TYPE, VALUE, INPUT = TypeError, ValueError, slipproof.InputError
CASES = [
    # Columns of the filter
    (modes(F="300"), TYPE, "F: found an array of <U3, expected numbers that are float64 without rounding"),
    (modes(F=["1", "2"]), TYPE, "F: found an array of <U1, expected numbers"),
    (modes(F=np.array([1, "2"], dtype=object)), TYPE, "F: found an array of object, expected numbers"),
    (modes(F=None), TYPE, "F: found an array of object, expected numbers"),
    (modes(F=1j), TYPE, "F: found an array of complex128, expected numbers"),
    (modes(F=[True, False]), TYPE, "F: found an array of bool, expected numbers"),
    (modes(F=np.zeros(3, dtype=np.longdouble)), TYPE, "F: found an array of float128, expected numbers"),
    (modes(F=np.zeros(3, dtype="M8[s]")), TYPE, "F: found an array of datetime64[s], expected numbers"),
    (modes(F=np.zeros((2, 2))), VALUE, "F: found shape (2, 2), expected 0 dimensions or 1 dimension"),
    (modes(F=[[1.0], [2.0, 3.0]]), VALUE, "F: found rows of different lengths, expected numbers in rows of one length"),
    (modes(F=np.zeros(3), f=np.zeros(4)), VALUE, "F: found 3 numbers, expected 4 as in f, or 1"),
    (modes(F=np.zeros(0), f=np.zeros(4)), VALUE, "F: found 0 numbers, expected 4 as in f, or 1"),
    (modes(F=2**60), VALUE, "F: found integers beyond 2**53, expected numbers"),
    (modes(F=[-(2**60)]), VALUE, "F: found integers beyond 2**53"),
    (modes(F=2**70), TYPE, "F: found an array of object"),
    (modes(F=np.ma.masked_array([1.0], [True])), TYPE, "F: found MaskedArray, expected an array without a mask"),
    (modes(M=-1), VALUE, "bicycle 0: M: found -1, expected M > 0"),
    (modes(F=np.nan), VALUE, "found NaN, expected a finite number"),
    (modes(F=np.inf), VALUE, "found infinity, expected a finite number"),
    (modes(kind="inner"), VALUE, "kind: found 'inner', expected 'internal' or 'external'"),
    (modes(kind=1), TYPE, "kind: found int, expected 'internal' or 'external'"),
    (modes(threads=-1), VALUE, "threads: found -1, expected a whole number from 0 to 4096"),
    (modes(threads=2.5), TYPE, "threads: found float, expected a whole number"),
    (modes(threads=True), TYPE, "threads: found bool, expected a whole number"),
    (modes(Q=1), TYPE, "unexpected keyword argument 'Q'"),
    (lambda: slipproof.consistent_modes(F=1), TYPE, "missing 13 required keyword-only arguments"),
    # Scenes
    (solve(SCENE, F="3/0"), INPUT, "force.F: F: found a zero denominator"),
    (solve(SCENE, F="three"), INPUT, "force.F: F: found 't', expected a digit"),
    (solve(SCENE, F=""), INPUT, "force.F: F: found nothing, expected a number"),
    (solve(SCENE, F="1e99999"), INPUT, "force.F: F: found the exponent 99999, expected"),
    (solve(SCENE, F=float("nan")), VALUE, "force.F: found nan, expected a finite number"),
    (solve(SCENE, F=float("-inf")), VALUE, "force.F: found -inf, expected a finite number"),
    (solve(SCENE, F=[1]), TYPE, "force.F: found list, expected a number: int, float, Fraction, Decimal, or a text"),
    (solve(SCENE, F=1j), TYPE, "force.F: found complex, expected a number"),
    (solve(SCENE, F=True), INPUT, "force.F: F: found a boolean, expected"),
    (solve(SCENE, F=10**10001), INPUT, "force.F: F: found 10002 characters, expected at most 10000 in a number"),
    (solve(SCENE, R=0), INPUT, "bicycle.R: R: found '0', expected"),
    (solve(SCENE, f=-1), INPUT, "road.f: f: found '-1', expected"),
    (solve(SCENE, colour=1), INPUT, "bicycle.colour: unknown key 'colour' in [bicycle]"),
    (solve(SCENE, kind="sideways"), INPUT, "force.kind: "),
    (solve(R=1), INPUT, "missing road, expected a table with f and g"),
    (solve(), INPUT, "missing"),
    (solve({"bicycle": 5}), INPUT, "bicycle: "),
    (solve({1: 2}), TYPE, "a key of the scene: found int, expected str"),
    (solve({"bicycle": {1: 2}}), TYPE, "a key of bicycle: found int, expected str"),
    (solve(5), TYPE, "path: found int, expected a path"),
    (solve("no-such.toml"), FileNotFoundError, "No such file or directory: 'no-such.toml'"),
    (solve("cases"), IsADirectoryError, "Is a directory"),
    (solve("README.md"), INPUT, "README.md:3"),
    (lambda: slipproof.Scene(5), TYPE, "scene: found int, expected a dict; Scene.load(path) reads a file"),
    (lambda: slipproof.Scene.parse(b"x"), TYPE, "text: found bytes, expected str"),
    (lambda: slipproof.Scene.parse("R = \n", "mine.toml"), INPUT, "mine.toml:1:5: "),
    (lambda: slipproof.Scene.parse("\udcff"), INPUT, "scene:1:1: "),
    (lambda: slipproof.Mechanism.load("laddr"), FileNotFoundError, "laddr"),
    (lambda: slipproof.Mechanism.load(7), TYPE, "path: found int, expected a path"),
    (lambda: slipproof.Mechanism.load("ladder").solve(5), TYPE, "values: found int, expected a dict"),
    (lambda: slipproof.Mechanism.load("ladder").solve({}), INPUT, "values: "),
    (lambda: slipproof.Mechanism.load("ladder").solve({**LADDER, "mq": 1}), INPUT, "values.mq: values: unknown parameter"),
    (lambda: slipproof.Mechanism.load("ladder").solve({**LADDER, "theta": 1}), INPUT, "values.theta: theta: found "),
    (lambda: slipproof.Mechanism.load("painleve-rod").solve({}, load=1), VALUE, "load: found 1, expected none"),
    # Contact problems
    (certify(W2, [1, 2, 3], [1, 2, 3]), VALUE, "W: found shape (2, 2), expected (3, 3) as q has shape (3,)"),
    (certify(np.eye(3), [1, 2], [1, 2]), VALUE, "W: found shape (3, 3), expected (2, 2)"),
    (certify([1, 2], [1, 2], [1, 2]), VALUE, "W: found shape (2,), expected 2 dimensions"),
    (certify(W2, [1, 2], [1]), VALUE, "z: found shape (1,), expected (2,) as q has shape (2,)"),
    (certify(W2, [1, 2], [1, 2], w=[1]), VALUE, "w: found shape (1,), expected (2,)"),
    (certify(W2, 5, [1, 2]), VALUE, "q: found shape (), expected 1 dimension or 2 dimensions"),
    (certify(np.zeros((0, 0)), [], []), VALUE, "q: found no components, expected at least one"),
    (certify(W2, [1, np.nan], [1, 2]), VALUE, "q[1]: found nan, expected a finite number"),
    (certify([[1, np.inf], [0, 1]], [1, 2], [1, 2]), VALUE, "W[0, 1]: found inf, expected a finite number"),
    (certify(W2, [1, 2], [1, 2], [-1.0]), VALUE, "mu: found -1.0, expected coefficients >= 0"),
    (certify(W2, [1, 2], [1, 2], [np.nan]), VALUE, "mu[0]: found nan, expected a finite number"),
    (certify(W2, [1, 2], [1, 2], [1, 1]), VALUE, "mu: found 2 coefficients for 2 components, expected 2 or 3 components for each contact"),
    (certify(np.eye(5), np.ones(5), np.ones(5), 0.5), VALUE, "mu: found one number for 5 components, expected 2 or 3 components for each contact"),
    (certify(np.eye(6), np.ones(6), np.ones(6), 0.5), VALUE, "dimension: found nothing, and one mu for 6 components, expected 2 or 3: "),
    (certify(W2, [1, 2], [1, 2], "half"), VALUE, "mu: found 'h', expected a digit"),
    (certify(W2, [1, 2], [1, 2], dimension=3), VALUE, "mu: found None, expected the coefficients of friction"),
    (certify(W2, [1, 2], [1, 2], 0.5, dimension=1), VALUE, "mu: found coefficients of friction, expected none"),
    (certify(W2, [1, 2], [1, 2], 0.5, dimension=4), VALUE, "dimension: found 4, expected a whole number from 1 to 3"),
    (certify(W2, [1, 2], ["1", ""]), VALUE, "z[1]: found nothing, expected a number"),
    (certify([[1, {}], [0, 1]], [1, 2], [1, 2]), TYPE, "W[0, 1]: found dict, expected a number"),
    (certify(W2 * 1j, [1, 2], [1, 2]), TYPE, "W: found an array of complex128, expected numbers"),
    (certify(W2, [1, 2]), VALUE, "z: found None, expected an answer, refine=True or all=True"),
    (certify(W2, [1, 2], [1, 2], tolerance=2), VALUE, "tolerance: found 2.0, expected a number from 0 to 1"),
    (certify(W2, [1, 2], [1, 2], tolerance="1"), TYPE, "tolerance: found str, expected a number"),
    (certify(W2, [1, 2], [1, 2], tolerance=np.nan), VALUE, "tolerance: found nan, expected a number from 0 to 1"),
    (certify(W2, [1, 2], [1, 2], law="pyramid"), VALUE, "law: found 'pyramid', expected 'coulomb' or 'cone' or 'box' or 'diamond'"),
    (certify(W2, [1, 2], [1, 2], method="best"), VALUE, "method: found 'best', expected 'auto' or 'exact' or"),
    (certify(W2, [1, 2], [1, 2], method="exact", refine=True), VALUE, "method: found 'exact', expected an array W"),
    (certify(W2, [1, 2], [1, 2], effort=0), VALUE, "effort: found 0, expected a whole number from 1"),
    (certify(W2, [1, 2], [1, 2], within=-1), VALUE, "within: found -1.0, expected a number from 0"),
    (certify(W2, [1, 2], [1, 2], progress=5), TYPE, "progress: found int, expected a function of (done, all), or True"),
    (certify(np.zeros((4, 2, 2)), np.zeros((3, 2)), np.zeros((3, 2))), VALUE, "W: found shape (4, 2, 2), expected (3, 2, 2)"),
    (certify(np.zeros((3, 2, 2)), np.zeros((3, 2)), np.zeros((2, 2))), VALUE, "z: found shape (2, 2), expected (3, 2)"),
    (certify(np.zeros((3, 2, 2)), np.zeros((3, 2)), np.zeros((2, 2)), refine=True), VALUE, "z: found shape (2, 2), expected (3, 2)"),
    (certify(np.zeros((4, 3, 3)), np.zeros((3, 3)), np.zeros((3, 3)), 1, dimension=3), VALUE, "W: found shape (4, 3, 3), expected (3, 3, 3)"),
    (certify(np.eye(3), np.zeros((3, 3)), np.zeros((3, 3)), np.zeros((2, 1)), dimension=3), VALUE, "mu: found shape (2, 1)"),
    (certify(np.zeros((3, 2, 2)), np.zeros((3, 2)), np.zeros((3, 2)), np.zeros((2, 1))), VALUE, "mu: found shape (2, 1)"),
    (certify(Broken([0, 1, 3], [0, 1]), [1, 2], [1, 2]), VALUE, "W: found indptr and indices that do not fit each other"),
    (certify(Broken([0, 1, 2], [0, 2]), [1, 2], [1, 2]), VALUE, "W: found indptr and indices that do not fit"),
    (certify(Broken([0, 1, 2], [0, -1]), [1, 2], [1, 2]), VALUE, "W: found indptr and indices that do not fit"),
    (certify(Broken([0, 2, 1], [0, 1]), [1, 2], [1, 2]), VALUE, "W: found indptr and indices that do not fit"),
    (certify(Broken([0, 1, 2], [0, 1], [1.0, np.nan]), [1, 2], [1, 2]), INPUT, "W"),
    (certify(Broken([0, 1, 2], [0, 1]), [1, 2, 3], [1, 2, 3]), VALUE, "W: found shape (2, 2), expected (3, 3)"),
    # Records
    (lambda: slipproof.certify_bicycles(5), TYPE, "records: found int, expected a structured array, a dict of columns"),
    (lambda: slipproof.certify_bicycles(np.zeros(3)), TYPE, "records: found an array of float64, expected one with fields"),
    (bicycles(a=["x"]), TYPE, "a: found an array of <U1, expected numbers"),
    (bicycles(a=[[1.0]]), VALUE, "a: found shape (1, 1), expected 1 dimension"),
    (bicycles(a=[1.0, 2], S2=[1.0, 2, 3]), VALUE, "found 3 values, expected 2 as in a, or 1"),
    (bicycles(a=[2**60]), VALUE, "a: found integers beyond 2**53"),
    (bicycles(mode=["slide/stick"]), VALUE, "mode: found 'slide/stick', expected one of stick/stick"),
    (bicycles(mode=[1.0]), TYPE, "mode: found an array of float64, expected texts such as 'stick/stick'"),
    (bicycles(mode=np.array([77], np.uint8)), VALUE, "found the mode 77, expected 0 to 15"),
    (bicycles(kind=["inner"]), VALUE, "kind: found 'inner', expected one of internal, external"),
    (bicycles(colour=[1.0]), VALUE, "records: found the column 'colour', expected one of"),
    (bicycles(without=("a",)), VALUE, "missing a"),
    (lambda: slipproof.certify_bicycles({1: [1.0]}), TYPE, "the name of a column: found int, expected str"),
    # Files
    (lambda: slipproof.certify_file(5), TYPE, "path: found int, expected a path"),
    (lambda: slipproof.certify_file("no-such.csv"), FileNotFoundError, "no-such.csv"),
    (lambda: slipproof.certify_file("README.md"), INPUT, "README.md"),
    (lambda: slipproof.certify_file("cases/contact-problems/pushed-block.json", answer=5), TYPE, "answer: found int"),
    (lambda: slipproof.certify_file("cases/contact-problems/pushed-block.json", answer="none"), FileNotFoundError, "none"),
    (lambda: slipproof.verify("no-such.toml"), FileNotFoundError, "no-such.toml"),
    (lambda: slipproof.verify({"papers": {}}), INPUT, "papers: "),
    (lambda: slipproof.verify("x = 1\n"), INPUT, "claims.toml"),
    (lambda: slipproof.verify(SCENE), INPUT, "city-bicycle.toml"),
    (lambda: slipproof.verify(SCENE, samples=0), VALUE, "samples: found 0, expected a whole number from 1"),
    (lambda: slipproof.verify(SCENE, only=5), TYPE, "only: found int, expected str"),
    (lambda: slipproof.prove("no-such.statement"), FileNotFoundError, "no-such.statement"),
    (lambda: slipproof.prove("x\ny\n"), INPUT, "statement:1"),
    (lambda: slipproof.prove("x^2 >= 2x"), INPUT, "formula:1:8: found `2x`, expected"),
    (lambda: slipproof.prove("x >"), INPUT, "formula:1:4: found the end of the line, expected"),
    (lambda: slipproof.prove("x\ny\n", effort="much"), TYPE, "effort: found str, expected a whole number"),
    (lambda: slipproof.check(), TYPE, "paths: found NoneType, expected at least one certificate"),
    (lambda: slipproof.check(5), TYPE, "paths: found int, expected a path"),
    (lambda: slipproof.search("ladder", wanted="two"), VALUE, "wanted: found 'two', expected 'none' or 'several' or"),
    (lambda: slipproof.search("ladder", wanted="gain"), INPUT, "found no impact, which alone may gain energy"),
    (lambda: slipproof.search("ladder", law="hertz"), VALUE, "law: found 'hertz', expected 'newton' or 'moreau' or"),
    (lambda: slipproof.search("ladder", within="mu_f <"), INPUT, "within:1:"),
    (lambda: slipproof.search("ladder", within=3), TYPE, "within: found int, expected str"),
    (lambda: slipproof.critical(SCENE, x="colour"), VALUE, "colour"),
    (lambda: slipproof.critical(SCENE, x=3), TYPE, "x: found int, expected the symbol of a parameter"),
    (lambda: slipproof.phase_diagram(SCENE, x="colour"), VALUE, "colour"),
    (lambda: slipproof.phase_diagram(SCENE, x=3), TYPE, "x: found int, expected the symbol of a parameter"),
    (lambda: slipproof.phase_diagram(SCENE, y="f"), INPUT, "multiplies"),
    (lambda: slipproof.phase_diagram(SCENE, x_range=5), TYPE, "x_range: found int, expected a pair of numbers"),
    (lambda: slipproof.phase_diagram(SCENE, x_range=(1, 0)), VALUE, "range"),
    (lambda: slipproof.phase_diagram(SCENE, columns=1), VALUE, "columns: found 1, expected a whole number from 2"),
]


def test_there_are_many():
    assert len(CASES) >= 80


@pytest.mark.parametrize("call, exception, message", CASES, ids=[f"{i}: {c[2][:40]}" for i, c in enumerate(CASES)])
def test_is_refused(call, exception, message):
    with pytest.raises(Exception) as error:
        call()
    assert type(error.value) is exception and message in str(error.value), repr(error.value)


def test_all_mistakes_of_a_scene_come_at_once():
    with pytest.raises(slipproof.InputError) as error:
        slipproof.solve(SCENE, R="x", f=-1, colour=2)
    places = [d.place for d in error.value.diagnostics]
    assert places == ["bicycle.R", "bicycle.colour", "road.f"]
    assert error.value.place == "bicycle.R" and error.value.found and error.value.expected


def test_mistakes_in_a_file_have_line_and_column(tmp_path):
    path = tmp_path / "mine.toml"
    path.write_text('[bicycle]\nR = "x"\n')
    with pytest.raises(slipproof.InputError) as error:
        slipproof.solve(path)
    (first, *_) = error.value.diagnostics
    assert all(d.file == str(path) for d in error.value.diagnostics)
    assert any(d.line == 2 for d in error.value.diagnostics) and f"{path}:" in str(first)
