// Solutions that are not near an answer, or not in all of its forces; and other laws.
#pragma once

#include "contact/exact/border.hpp"
#include "contact/judge/judge.hpp"

namespace slipproof {

/// The effort for what is looked for beyond a verdict, in proportion to the problem: as much as it is solved with; more
/// if more than the usual effort is allowed. Problems with few contacts are solved faster than in proportion.
Work work_beyond_verdict(const MixedProblem& problem, Work effort);

/// Leaves out blocks of which a dense inverse would take longer than all the rest; those with sparse factors stay. Few
/// modes are tried.
EnclosureOptions with_little_work(EnclosureOptions options);

/// Whether a solution may be near an answer: where the law fails all around, it is not. `within` is what counts as
/// near, in place of `contact_near`.
bool may_be_near(const MixedProblem& problem, const ContactJudgement& judgement, std::span<const Rational> w,
                 std::optional<double> within);

/// An answer that is not right after sweeps over its contacts, if they lead to one that is; else as it is.
std::vector<double> improved_answer(const MixedProblem& problem, const std::vector<double>& x,
                                    const ContactJudgeOptions& options);

/// A solution without rounding: at a border between linear modes, or of a complementarity problem. Nothing if none is
/// found.
std::optional<BorderSolution> exact_solution_near(const MixedProblem& problem, std::span<const double> x,
                                                  Effort& effort);

/// What follows of every solution of a convex law, around the one that is `known`, or around the answer with its forces
/// improved. `u` are the velocities that it gives, or empty. Throws TooMuchWork.
void bound_every_solution(const MixedProblem& problem, std::span<const double> u, bool known, Effort& effort,
                          ContactJudgement& judgement);

/// Looks in all modes whose equations are linear (exact/linear_modes.hpp) for a solution that is not the known one:
/// `other_exact`. Where the known one leaves forces undetermined, only one with other velocities counts. Sets
/// `linear_modes`, whether they were tried: they are not if that is too much work. Requires Coulomb's law and a known
/// solution.
void look_in_linear_modes(const MixedProblem& problem, Effort effort, ContactJudgement& judgement);

/// Encloses a solution that has an answer's velocities, up to `near` of their size, and its forces moved inside of
/// their cones (forces_inside()), by little if that suffices; near the forces of `toward`, if that is given. Nothing if
/// none was found. Requires Coulomb's law. Throws TooMuchWork.
std::optional<Enclosure> enclose_inside(const MixedProblem& problem, std::span<const double> x, double near,
                                        const EnclosureOptions& options, Effort& effort,
                                        std::span<const double> toward = {});

/// The contacts whose forces are open: the enclosed solution, found along a path or inside of the cones, has the
/// answer's velocities, and such a change of forces would usually move contacts far more. Empty where that is not so.
std::vector<std::size_t> open_contacts(const MixedProblem& problem, const ContactJudgement& judgement,
                                       double tolerance);

/// For an answer that is wrong for the cone: the pyramid for which it would be right, which engines use instead. `w` is
/// A x + c.
std::optional<FrictionLaw> pyramid_that_fits(const MixedProblem& problem, std::span<const double> x,
                                             std::span<const Rational> w, double tolerance);

}  // namespace slipproof
