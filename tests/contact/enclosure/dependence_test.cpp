// Exact dependence is found in each part of a problem by itself.
#include "contact/enclosure/dependence.hpp"

#include <doctest/doctest.h>

#include "contact/enclosure/answer.hpp"
#include "contact/enclosure/enclosure.hpp"
#include "contact/formats/read_files.hpp"

using namespace slipproof;

TEST_CASE("a hundred blocks on four corners each have one force that nothing determines") {
  const ReadProblem read = read_problem_file(SLIPPROOF_SOURCE_DIR "/cases/contact-problems/pushed-block.json");
  const MixedProblem one = mixed_problem(read.problem);
  std::string reason;
  const std::vector<double> answer = answer_vector(read.problem, one, read.answers.front(), reason);
  REQUIRE(reason.empty());
  constexpr std::size_t copies = 100;
  const std::size_t own = one.size() - one.free;
  const auto place = [&](std::size_t copy, std::size_t i) {
    return i < one.free ? copy * one.free + i : copies * one.free + copy * own + (i - one.free);
  };
  MixedProblem all;
  all.free = copies * one.free;
  all.dimension = one.dimension;
  all.c.resize(copies * one.size());
  std::vector<double> x(all.c.size());
  std::vector<MatrixEntry> entries, twice;
  for (std::size_t copy = 0; copy < copies; ++copy) {
    all.mu.insert(all.mu.end(), one.mu.begin(), one.mu.end());
    for (std::size_t i = 0; i < one.size(); ++i) {
      all.c[place(copy, i)] = one.c[i];
      x[place(copy, i)] = answer[i];
      for (std::size_t e = one.A.starts[i]; e < one.A.starts[i + 1]; ++e) {
        entries.push_back({static_cast<std::uint32_t>(place(copy, i)),
                           static_cast<std::uint32_t>(place(copy, one.A.column[e])), one.A.value[e]});
      }
    }
  }
  all.A = sparse_matrix(all.c.size(), all.c.size(), std::move(entries), twice);
  const auto found = enclose_solution(all, x);
  REQUIRE(std::holds_alternative<Enclosure>(found));
  const auto& box = std::get<Enclosure>(found);
  CHECK(box.system.size() > largest_dependent);
  CHECK(box.pinned.size() == copies);
  CHECK(distance_from(box, x) < 1e-6);
}
