"""Every public name says what it is, what its arguments are, and what it raises."""

import inspect
import re

import pytest

import slipproof
import slipproof.testing

CALLS = {name: thing for name, thing in vars(slipproof).items()
         if name in slipproof.__all__ and inspect.isroutine(thing)}
CALLS.update({f"testing.{name}": getattr(slipproof.testing, name) for name in slipproof.testing.__all__})
CLASSES = {name: thing for name, thing in vars(slipproof).items()
           if name in slipproof.__all__ and inspect.isclass(thing)}


def members(cls):
    for name, thing in inspect.getmembers(cls):
        own = getattr(inspect.unwrap(thing.fget if isinstance(thing, property) else getattr(thing, "__func__", thing)),
                      "__module__", "") if not name.startswith("_") else ""
        if str(own).startswith("slipproof"):
            yield name, thing


@pytest.mark.parametrize("name", sorted(CALLS))
def test_functions_name_their_arguments_and_errors(name):
    text = inspect.getdoc(CALLS[name]) or ""
    arguments = [a for a in inspect.signature(CALLS[name]).parameters]
    missing = [a for a in arguments if f"``{a}" not in text and f"``{a}``" not in text]
    assert not missing, f"{name} does not say what these are: {missing}"
    assert not arguments or re.search(r"\bRaises\b", text), f"{name} does not say what it raises"


@pytest.mark.parametrize("name", sorted(CLASSES))
def test_classes_and_their_members_say_what_they_are(name):
    cls = CLASSES[name]
    assert cls.__doc__ and not cls.__doc__.startswith(f"{name}("), name
    public = list(members(cls))
    for member, thing in public:
        assert inspect.getdoc(thing), f"{name}.{member} says nothing"
        arguments = [a for a in inspect.signature(thing).parameters if a not in ("self", "cls")] if callable(thing) else []
        missing = [a for a in arguments if f"``{a}" not in inspect.getdoc(thing)]
        assert not missing, f"{name}.{member} does not say what these are: {missing}"


@pytest.mark.parametrize("name, unit", [
    ("solve", "SI units"), ("certify", "units"), ("certify_bicycles", "SI units"), ("consistent_modes", "kg m^2"),
    ("Scene", "SI units"), ("Body", "kg m^2"), ("Contact", "in m"), ("Joint", "in m"), ("Force", "in N"),
    ("Torque", "in N m"), ("Friction", "in N m"), ("phase_diagram", "in degrees")])
def test_what_takes_quantities_says_their_units(name, unit):
    assert unit in (inspect.getdoc(getattr(slipproof, name)) or "")


def test_there_are_many():
    assert len(CALLS) > 12 and len(CLASSES) > 25 and {"solve", "certify", "prove"} <= set(CALLS)
    assert sum(len(list(members(c))) for c in CLASSES.values()) > 60
