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

/// Problems w = W z + q of one size, their numbers in lists, one problem after the other.
struct ProblemBatch {
  std::size_t count = 0;
  ProblemFile common;          ///< what all have: form, dimension, law, compliance, bias; W, if it is the same for all
  std::span<const double> W;   ///< by rows; empty: that of `common`
  std::span<const double> q;   ///< its size is that of the problems, `count` times
  std::span<const double> mu;  ///< of each contact, of all problems; empty: that of `common`
  std::span<const double> z;   ///< the answers; empty: one is looked for, as the options say
  std::span<const double> w;   ///< empty: not given
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
