#include "contact/problem/parts.hpp"

#include <algorithm>

#include "base/algebra/union_find.hpp"

namespace slipproof {

std::vector<ContactPart> parts_of(const MixedProblem& problem) {
  const auto item = [&](std::size_t i) {  // free unknowns, then contacts
    return i < problem.free ? i : problem.free + (i - problem.free) / problem.dimension;
  };
  UnionFind joined(problem.free + problem.contacts());
  for (std::size_t i = 0; i < problem.size(); ++i) {
    for (const std::uint32_t j : problem.A.columns_of(i)) joined.join(item(i), item(j));
  }
  std::vector<ContactPart> by_root(problem.free + problem.contacts());
  for (std::size_t i = 0; i < problem.free; ++i) by_root[joined.find(i)].free.push_back(i);
  for (std::size_t k = 0; k < problem.contacts(); ++k) by_root[joined.find(problem.free + k)].contacts.push_back(k);
  std::erase_if(by_root, [](const ContactPart& p) { return p.free.empty() && p.contacts.empty(); });
  return by_root;
}

std::vector<std::size_t> rows_of(const MixedProblem& problem, const ContactPart& part) {
  std::vector<std::size_t> rows = part.free;
  for (const std::size_t k : part.contacts) {
    for (std::size_t i = 0; i < problem.dimension; ++i) rows.push_back(problem.normal(k) + i);
  }
  return rows;
}

MixedProblem part_of(const MixedProblem& problem, const ContactPart& part, const std::vector<std::size_t>& rows) {
  const auto place = [&](std::uint32_t column) {  // rows ascend
    return static_cast<std::uint32_t>(std::ranges::lower_bound(rows, std::size_t{column}) - rows.begin());
  };
  MixedProblem result;
  result.free = part.free.size();
  result.dimension = problem.dimension;
  result.law.kind = problem.law.kind;
  result.A.rows = result.A.columns = rows.size();
  for (const std::size_t i : rows) {
    for (std::size_t e = problem.A.starts[i]; e < problem.A.starts[i + 1]; ++e) {
      result.A.column.push_back(place(problem.A.column[e]));
      result.A.value.push_back(problem.A.value[e]);
    }
    result.A.starts.push_back(result.A.value.size());
    result.c.push_back(problem.c[i]);
  }
  for (const std::size_t k : part.contacts) result.mu.push_back(problem.mu[k]);
  return result;
}

std::vector<std::vector<std::size_t>> free_parts(const MixedProblem& problem) {
  UnionFind parts(problem.free);
  for (std::size_t i = 0; i < problem.free; ++i) {
    for (const std::uint32_t j : problem.A.columns_of(i)) {
      if (j < problem.free) parts.join(i, j);
    }
  }
  std::vector<std::vector<std::size_t>> by_root(problem.free);
  for (std::size_t i = 0; i < problem.free; ++i) by_root[parts.find(i)].push_back(i);
  std::erase_if(by_root, [](const auto& part) { return part.empty(); });
  return by_root;
}

}  // namespace slipproof
