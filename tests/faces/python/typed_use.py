"""What users write, for mypy: it is checked, not run. Each annotation is a claim about a type."""

from fractions import Fraction
from typing import List, Optional, Tuple

import slipproof


def use() -> None:
    W = [[2, 1], [1, 2]]
    q = [-5, -6]
    z = [1.3333333333333333, 2.3333333333333335]
    verdict = slipproof.certify(W, q, z)
    word: str = verdict.verdict
    certified: bool = verdict.certified
    modes: List[str] = verdict.modes
    exact: slipproof.Verdict = slipproof.certify([["2", "1"], ["1", "2"]], [Fraction(-5), -6], ["4/3", "7/3"])
    batch: slipproof.Verdicts = slipproof.certify(W, [[-5, -6], [-4, -5]], [z, z])
    words: List[str] = list(batch.verdicts)

    solution = slipproof.solve("scene.toml", F=300)
    a: Fraction = solution.motions[0].a
    first: Tuple[str, Fraction] = next(iter(solution.motions[0]))
    at_other_load: slipproof.Solution = solution.at("301.5")
    for motion in solution:
        number: Fraction = motion.values["N2"]
    for cell in slipproof.solve("scene.toml", F=None).cells:
        for over in cell:
            affine: slipproof.Affine = over.a
            there: Fraction = over.a(5)
    lower: Optional[Fraction] = solution.ranges[0].loads.lower
    proved: bool = slipproof.prove("x^2 + y^2 >= 2*x*y").proved
    found: slipproof.Search = slipproof.search("ladder")
