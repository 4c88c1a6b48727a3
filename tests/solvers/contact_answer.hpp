// What the programs that run one real solver on one contact problem give back.
#pragma once

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <string>
#include <vector>

#include "formats/problem_file.hpp"

namespace slipproof::test {

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

}  // namespace slipproof::test
