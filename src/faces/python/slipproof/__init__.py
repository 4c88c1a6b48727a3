"""Exact, provable answers about dry friction.

- :class:`Body`, :class:`Contact`, :class:`Joint`, ...: a mechanism from what is there, without a file
- :func:`solve`, :class:`Mechanism`: every motion of a bicycle or of any mechanism with dry friction, in the plane or in space
- :func:`certify`, :func:`certify_bicycles`, :func:`certify_file`: verdicts on the answers of solvers
- :func:`consistent_modes`: the consistent modes of many scenes
- :func:`critical`: the friction from which on a scene has several motions
- :func:`verify`, :func:`prove`, :func:`check`: claims of papers, and proofs
- :func:`phase_diagram`: pictures

Numbers may be int, float, Fraction, Decimal or text, and are taken exactly as they are; results are Fractions.
Functions may be called from any thread and let other threads run. Ctrl-C ends them.
"""

from ._bicycles import VERDICTS, BicycleVerdicts, certify_bicycles
from ._bodies import Body, Contact, Force, Friction, Joint, Torque
from ._certify import Impact, certify, certify_bodies, certify_file
from ._core import version as __version__
from ._errors import Diagnostic, InputError, TooMuchWork
from ._filter import MODES, ConsistentModes, consistent_modes
from ._mechanism import Mechanism, Search, search, shipped_mechanisms
from ._numbers import Affine, Bounds, Interval
from ._papers import Check, CheckedCertificate, ClaimVerdict, Proof, Verification, check, prove, verify
from ._phase import PhaseDiagram, phase_diagram
from ._progress import ProgressBar
from ._scene import Scene, solve
from ._solution import Cell, Continuum, Motion, Range, Rejected, Solution
from ._space import Rest, RestMap, SpaceMotion, SpaceSolution
from ._uniqueness import Critical, critical
from ._verdicts import CONTACT_VERDICTS, BatchVerdicts, Verdict, Verdicts

__all__ = [
    "CONTACT_VERDICTS", "MODES", "VERDICTS", "Affine", "BatchVerdicts", "BicycleVerdicts", "Body", "Bounds", "Cell", "Check", "CheckedCertificate", "ClaimVerdict", "ConsistentModes", "Contact", "Continuum", "Critical",
    "Diagnostic", "Force", "Friction",
    "Impact", "InputError", "Interval", "Joint", "Mechanism", "Motion", "PhaseDiagram", "ProgressBar", "Proof", "Range", "Rejected", "Rest", "RestMap", "Scene",
    "Search", "Solution", "SpaceMotion", "SpaceSolution", "TooMuchWork", "Torque", "Verdict", "Verdicts", "Verification", "__version__", "certify",
    "certify_bicycles", "certify_bodies", "certify_file",
    "check", "consistent_modes", "critical", "phase_diagram", "prove", "search", "shipped_mechanisms", "solve", "verify",
]
