// Contact problems at real size, as the field's own files hold them, and answers of solvers to them.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/algebra/sparse_matrix.hpp"
#include "contact/formats/impact/step_impact.hpp"
#include "contact/formats/law.hpp"

namespace slipproof {

enum class ProblemForm : std::uint8_t {
  /// w = W z + q, z >= 0, w >= 0, z_i w_i = 0. `dimension` is 1. With V, R and s: bilateral rows, as below.
  complementarity,
  /// u = W r + V lambda + q, V^T r + R lambda + s = 0.
  local,
  /// M v = H r + G lambda + f, u = H^T v + w, G^T v + b = 0.
  global
};

/// Impulses or forces r and velocities or accelerations u of contact k are at dimension * k: the normal part, then the
/// tangential one. A matrix that the form does not have, or the file leaves out, has no rows and no columns; V and G
/// may be left out if there are no bilateral rows.
struct ProblemFile {
  ProblemForm form = ProblemForm::local;
  std::size_t dimension = 3;  ///< 1 (complementarity), 2 or 3
  SparseMatrix W, V, R;       ///< complementarity and local
  std::vector<double> q, s;
  SparseMatrix M, H, G;  ///< global
  std::vector<double> f, w, b;
  std::vector<double> mu;  ///< Coulomb coefficient of each contact, >= 0; empty for complementarity
  /// The law that the solver used instead of Coulomb's, if the file states it, with a compliance R >= 0 of each
  /// component and a bias b in its u = W r + R r + q + b; R and b are empty if absent.
  ContactLaw law;
  std::vector<double> compliance, bias;
  /// Of a step in which contacts may approach. What it restores is added to u, as a bias is.
  std::optional<StepImpact> impact;
  std::string force_unit, velocity_unit;  ///< as in the file; may be empty
  std::string title;                      ///< the same
  /// Remarks for users, not for programs: a stored solution with r = 0, numbers printed with six digits, a trailing
  /// token. Sentences without a full stop.
  std::vector<std::string> remarks;

  std::size_t components() const { return form == ProblemForm::global ? H.columns : q.size(); }
  std::size_t contacts() const { return components() / dimension; }
};

/// The answer of a solver; parts that it does not give are empty. Keeps NaN and infinities: they are wrong answers.
struct SolverAnswer {
  std::string origin;             ///< "/solution", "/guesses/1", the name of a file
  std::vector<double> r;          ///< forces or impulses; z of a complementarity problem
  std::vector<double> u;          ///< velocities or accelerations; w of a complementarity problem
  std::vector<double> v, lambda;  ///< parts of the global form and of bilateral rows
};

/// The number of components of each part of an answer: a reader allocates no more. Nothing if it is unknown.
struct AnswerSizes {
  std::optional<std::size_t> r = std::nullopt, u = std::nullopt, v = std::nullopt, lambda = std::nullopt;
};

/// A problem with everything else in its file.
struct ReadProblem {
  ProblemFile problem;
  std::vector<SolverAnswer> answers;  ///< those in the problem's own file: its solution first, then guesses
};

}  // namespace slipproof
