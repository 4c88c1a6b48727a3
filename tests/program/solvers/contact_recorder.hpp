// What the programs have in common that run one real solver on one contact problem from a file. A run is a process of
// its own, as solvers crash or never end; contact_runs.sh limits its time.
#pragma once

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <exception>
#include <fstream>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "contact/formats/read_files.hpp"

namespace slipproof::test {

struct ContactOutcome {
  int code = 1;                 ///< the solver's own word: 0 is success
  std::optional<double> error;  ///< what it tells of its error, if it does
  SolverAnswer answer;
};

/// A solver with a setting, a tolerance or a precision, ready for one problem.
struct ContactRun {
  std::string solver, setting;
  std::function<ContactOutcome()> solve;
};

inline std::string list(const char* name, const std::vector<double>& numbers) {
  std::string text = fmt::format("\"{}\":[", name);
  const char* comma = "";
  for (const double x : numbers) {
    const std::string word = std::isnan(x) ? "NaN" : std::isinf(x) ? (x > 0 ? "Infinity" : "-Infinity") : "";
    text += comma + (word.empty() ? fmt::format("{}", x) : word);
    comma = ",";
  }
  return text + ']';
}

inline void write_answer(const char* path, const SolverAnswer& answer) {
  std::string text = '{' + list("r", answer.r);
  if (!answer.u.empty()) text += ',' + list("u", answer.u);
  if (!answer.v.empty()) text += ',' + list("v", answer.v);
  std::ofstream(path) << text << "}\n";
}

/// Solvers talk on standard output, where our one line is to stand alone: what they say goes to standard error.
class OneLine {
 public:
  OneLine() : output_(dup(STDOUT_FILENO)) { dup2(STDERR_FILENO, STDOUT_FILENO); }

  /// The exit code.
  int print(const std::string& line) const {
    std::fflush(nullptr);
    return write(output_, line.data(), line.size()) == static_cast<ssize_t>(line.size()) ? 0 : 1;
  }

 private:
  int output_;
};

inline int record(const ContactRun& run, const char* answer_path) {
  const OneLine output;
  const auto start = std::chrono::steady_clock::now();
  const ContactOutcome outcome = run.solve();
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
  write_answer(answer_path, outcome.answer);
  const std::string error = outcome.error ? fmt::format("{:.3g}", *outcome.error) : "";
  return output.print(fmt::format("{},{},{:.3f}\n", outcome.code, error, time.count()));
}

/// With a problem's FILE alone, prints the `SOLVER SETTING` of every run of runs_for(problem). With SOLVER SETTING
/// ANSWER makes that one, writes its answer into the file ANSWER, and prints `code,error,seconds`. Gives the exit code,
/// 2 for what is no run.
template <class RunsFor>
int record_contact(int argc, char** argv, const RunsFor& runs_for) try {
  if (argc != 2 && argc != 5) {
    fmt::print(stderr, "usage: {} FILE [SOLVER SETTING ANSWER]\n", argv[0]);
    return 2;
  }
  ProblemFile problem = read_problem_file(argv[1]).problem;
  for (const ContactRun& run : runs_for(problem)) {
    if (argc == 2) fmt::print("{} {}\n", run.solver, run.setting);
    if (argc == 5 && argv[2] == run.solver && argv[3] == run.setting) return record(run, argv[4]);
  }
  if (argc == 2) return 0;
  fmt::print(stderr, "{} {}: no such run for {}\n", argv[2], argv[3], argv[1]);
  return 2;
} catch (const std::exception& error) {
  fmt::print(stderr, "{}\n", error.what());
  return 2;
}

}  // namespace slipproof::test
