// Answers to many contact problems of one size, judged at real size on many threads.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "records/problems/contact_file.hpp"

namespace slipproof {

/// Problems of one form and size. A list has the numbers of all, one problem after the other, matrices by rows; what is
/// empty is that of `common`.
struct ProblemBatch {
  std::size_t count = 0;
  ProblemFile common;                  ///< form, dimension, law; and what is the same for all
  std::span<const double> W, q;        ///< local and complementarity
  std::span<const double> M, H, f, w;  ///< global
  std::span<const double> mu;
  std::span<const double> before;   ///< velocities before, where `common` has an impact
  std::span<const double> r, u, v;  ///< the answers; without r one is looked for, as the options say
};

/// What is proved of each answer.
struct BatchVerdicts {
  std::vector<ContactVerdict> verdicts;
  std::vector<double> rho;             ///< distance of a solution; NaN where none is known
  std::vector<double> backward_error;  ///< NaN of an invalid answer
  std::vector<std::string> lines;      ///< as contact_line() writes them, numbered from 1
};

/// Judges each answer as judge_problem_file() does; calls progress(done) after each, on any thread. Throws InputError
/// for what no problem can have, with the number of the problem, from 1. Uses the threads of on_threads().
BatchVerdicts judge_batch(const ProblemBatch& batch, const ContactFileOptions& options,
                          const std::function<void(std::uint64_t)>& progress = {});

}  // namespace slipproof
