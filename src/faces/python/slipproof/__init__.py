"""Exact, provable answers about dry friction.

Every motion of a bicycle or of any planar mechanism with dry friction (:func:`solve`, :class:`Mechanism`), verdicts on
what solvers answer (:func:`certify`, :func:`certify_bicycles`, :func:`certify_file`), consistent modes of many scenes (:func:`consistent_modes`),
from which friction on a scene has several motions (:func:`critical`),
claims of papers and proofs (:func:`verify`, :func:`prove`, :func:`check`), pictures (:func:`phase_diagram`).

Numbers go in as int, float, Fraction, Decimal or text, exactly as they are, and come out as Fractions. Functions are safe
to call from threads and let others run; Ctrl-C ends them.
"""

from ._bicycles import VERDICTS, BicycleVerdicts, certify_bicycles
from ._certify import Verdict, Verdicts, certify, certify_file
from ._core import version as __version__
from ._errors import Diagnostic, InputError, TooMuchWork
from ._filter import MODES, ConsistentModes, consistent_modes
from ._mechanism import Mechanism, Search, search, shipped_mechanisms
from ._numbers import Affine, Interval
from ._papers import Check, CheckedCertificate, ClaimVerdict, Proof, Verification, check, prove, verify
from ._phase import PhaseDiagram, phase_diagram
from ._progress import ProgressBar
from ._scene import Scene, solve
from ._solution import Cell, Continuum, Motion, Range, Rejected, Solution
from ._uniqueness import Critical, critical

__all__ = [
    "MODES", "VERDICTS", "Affine", "BicycleVerdicts", "Cell", "Check", "CheckedCertificate", "ClaimVerdict", "ConsistentModes", "Continuum", "Critical",
    "Diagnostic",
    "InputError", "Interval", "Mechanism", "Motion", "PhaseDiagram", "ProgressBar", "Proof", "Range", "Rejected", "Scene",
    "Search", "Solution", "TooMuchWork", "Verdict", "Verdicts", "Verification", "__version__", "certify",
    "certify_bicycles", "certify_file",
    "check", "consistent_modes", "critical", "phase_diagram", "prove", "search", "shipped_mechanisms", "solve", "verify",
]
