"""A file that is not there is a FileNotFoundError, wherever one is expected."""

from pathlib import Path

import pytest

import slipproof
from slipproof.testing import assert_motion

RECORDS = "cases/contact-problems/examples.jsonl"
PROBLEM = "cases/contact-problems/pushed-block.json"
CALLS = {
    "solve": lambda: slipproof.solve("no-such.file"),
    "Scene.load": lambda: slipproof.Scene.load("no-such.file"),
    "critical": lambda: slipproof.critical("no-such.file"),
    "phase_diagram": lambda: slipproof.phase_diagram("no-such.file"),
    "Mechanism.load": lambda: slipproof.Mechanism.load("no-such.file"),
    "Mechanism.load of a name": lambda: slipproof.Mechanism.load("no-such"),
    "search": lambda: slipproof.search("no-such.file"),
    "certify_file": lambda: slipproof.certify_file("no-such.file"),
    "certify_file's answer": lambda: slipproof.certify_file(PROBLEM, answer="no-such.file"),
    "certify_file's scene": lambda: slipproof.certify_file(RECORDS, scene="no-such.file"),
    "certify_file's mechanism": lambda: slipproof.certify_file(RECORDS, mechanism="no-such.file"),
    "certify_bicycles": lambda: slipproof.certify_bicycles(dict(a=[1.0]), scene="no-such.file"),
    "verify": lambda: slipproof.verify("no-such.file"),
    "prove": lambda: slipproof.prove("no-such.file"),
    "check": lambda: slipproof.check("no-such.file"),
    "assert_motion": lambda: assert_motion("no-such.file", {"a": 1}),
    **{f"{call.__name__} of a Path": lambda call=call: call(Path("no-such.file"))
       for call in (slipproof.solve, slipproof.certify_file, slipproof.verify, slipproof.prove, slipproof.check)},
}


@pytest.mark.parametrize("name", CALLS)
def test_a_missing_file_is_told_as_python_does(name):
    with pytest.raises(FileNotFoundError) as error:
        CALLS[name]()
    assert str(error.value.filename).startswith("no-such") and error.value.errno == 2


def test_a_name_that_is_no_mechanism_is_told_with_those_that_are():
    with pytest.raises(FileNotFoundError, match="ladder"):
        slipproof.Mechanism.load("laddr")
