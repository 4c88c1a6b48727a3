// Problems at the edges of what problems may be, in every notation: each line gets its verdict, and what is said of an
// answer agrees with the definition of its law.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>

#include "base/number/binary64.hpp"
#include "base/number/parse.hpp"
#include "records/certify/judged.hpp"
#include "records/degenerate/law_check.hpp"
#include "records/degenerate/random_case.hpp"
#include "records/problems/contact_file.hpp"
#include "support/certified.hpp"
#include "support/files/hdf5_writer.hpp"
#include "support/files/small_files.hpp"
#include "support/how_many.hpp"

using namespace slipproof;
using namespace slipproof::test;
using namespace slipproof::test::degenerate;
using Json = nlohmann::json;

namespace degenerate {

namespace {

using Strings = std::set<std::string>;

const Strings certified_words{"certified", "unique", "solution within rho"};
const Strings refusing_words{"wrong",       "inaccurate", "not converged", "no solution", "no solution within rho",
                             "eps-solution"};

std::size_t problems() {
  return how_many<std::size_t>("SLIPPROOF_DEGENERATE", quick(800, 80));
}

bool finite(const RandomCase& random) {
  return std::ranges::all_of(random.answer.r, [](double x) { return std::isfinite(x); });
}

/// The last components of a solution in a line, which are those of r; lambda is before them.
struct Solution {
  std::vector<Rational> lambda, r;
};
Solution solution_in(const RandomCase& random, const Json& list) {
  std::vector<Rational> all;
  for (const Json& x : list) all.push_back(parse_rational(x.get<std::string>()));
  const auto first = all.end() - static_cast<std::ptrdiff_t>(random.problem.q.size());
  return {{all.begin(), first}, {first, all.end()}};
}

/// Whether bias or compliance were rounded when they were added: a remark says so, and solutions are of what came out.
bool rounded(const Json& line) {
  return std::ranges::any_of(line.value("remarks", Json::array()), [](const Json& remark) {
    return remark.get<std::string>().find(" added in binary64") != std::string::npos;
  });
}

/// Every solution that a line has is one.
void check_solutions(const RandomCase& random, const Json& line) {
  std::vector<Json> lists;
  for (const char* key : {"exact", "other"}) {
    if (line.contains(key) && !line[key].empty() && line[key][0].is_string()) lists.push_back(line[key]);
  }
  for (const Json& found : line.value("found", Json::array())) lists.push_back(found["z"]);
  for (const Json& continuum : line.value("continua", Json::array())) lists.push_back(continuum["nearest_z"]);
  for (const Json& list : lists) {
    CAPTURE(list.dump());
    const Solution found = solution_in(random, list);
    if (!rounded(line)) CHECK(solves(random.problem, found.r, found.lambda));
  }
  if (!line.contains("exact")) return;
  const Solution exact = solution_in(random, line["exact"]);
  const double rho = std::stod(line["rho"].get<std::string>());
  for (std::size_t i = 0; i < exact.r.size(); ++i) {
    CHECK(abs(exact.r[i] - to_rational(random.answer.r[i])) <= to_rational(rho));
  }
}

/// What the line says of the answer.
void check_verdict(const RandomCase& random, const Json& line) {
  const ProblemFile& p = random.problem;
  const std::string word = line["verdict"];
  if (!finite(random)) {
    CHECK(word == "invalid");
    return;
  }
  const bool bilateral = !p.s.empty();
  if (certified_words.contains(word) && p.law.kind == FrictionLaw::cone && p.compliance.empty() && !bilateral) {
    CHECK(solves_roughly(p, random.answer.r, 1e-4));
  }
  if (bilateral || !random.answer.u.empty()) return;
  if (solves(p, to_rationals(random.answer.r), {})) {
    const bool convex_or_modes = p.law.kind != FrictionLaw::diamond && p.law.kind != FrictionLaw::regularised;
    CHECK((word == "eps-solution" || !refusing_words.contains(word)));
    CHECK((word != "eps-solution" || !convex_or_modes || line.contains("reason")));
  }
}

std::string column_by_column(const SparseMatrix& m) {
  std::string text = fmt::format("0\n{}\n{}\n{} {}\n", m.rows, m.columns, m.rows, m.columns);
  const SparseMatrix columns = transposed(m);
  for (std::size_t j = 0; j < m.columns; ++j) {
    std::vector<double> column(m.rows, 0);
    for (std::size_t e = columns.starts[j]; e < columns.starts[j + 1]; ++e)
      column[columns.column[e]] = columns.value[e];
    for (const double a : column) text += fmt::format("{:.17g} ", a);
    text += '\n';
  }
  return text;
}

std::string lines_of(const Numbers& values) {
  std::string text;
  for (const double x : values) text += fmt::format("{:.17g}\n", x);
  return text;
}

std::string siconos_text(const ProblemFile& p) {
  const std::string sizes =
      p.dimension == 1 ? std::to_string(p.q.size()) : fmt::format("{}\n{}", p.dimension, p.contacts());
  return sizes + '\n' + column_by_column(p.W) + lines_of(p.q) + lines_of(p.mu);
}

std::string write_market(const Folder& folder, const ProblemFile& p) {
  const std::string banner = "%%MatrixMarket matrix ";
  std::string W = banner + fmt::format("coordinate real general\n{} {} {}\n", p.W.rows, p.W.columns, p.W.entries());
  for (std::size_t i = 0; i < p.W.rows; ++i) {
    for (std::size_t e = p.W.starts[i]; e < p.W.starts[i + 1]; ++e) {
      W += fmt::format("{} {} {:.17g}\n", i + 1, p.W.column[e] + 1, p.W.value[e]);
    }
  }
  const auto vector = [&](const char* name, const Numbers& values) {
    folder.write(name, banner + fmt::format("array real general\n{} 1\n", values.size()) + lines_of(values));
  };
  vector("m_q.mtx", p.q);
  if (p.dimension > 1) vector("m_mu.mtx", p.mu);
  return folder.write("m.mtx", W);
}

#ifdef SLIPPROOF_HDF5
std::string write_fclib(const Folder& folder, const ProblemFile& p) {
  const Hdf5Writer out(folder.path("p.hdf5"));
  out.group("/fclib_local");
  out.integers("/fclib_local/spacedim", {static_cast<long long>(p.dimension)});
  out.matrix("/fclib_local/W", static_cast<long long>(p.W.rows), static_cast<long long>(p.W.columns), -2,
             {p.W.column.begin(), p.W.column.end()}, {p.W.starts.begin(), p.W.starts.end()}, p.W.value);
  out.group("/fclib_local/vectors");
  out.reals("/fclib_local/vectors/q", p.q);
  out.reals("/fclib_local/vectors/mu", p.mu);
  return folder.path("p.hdf5");
}
#endif

/// The verdict on the answer to the problem in a file, or what is refused about it.
std::string verdict_on_file(const std::string& path, const RandomCase& random) {
  ContactFileOptions options;
  options.answer = random.answer;
  std::string word;
  const std::string refused = refusal(
      [&] {
        const JudgedProblem problem(path, read_problem_file(path), options);
        word = name(problem.first().judgement.verdict);
      },
      path);
  return refused.empty() ? word : refused;
}

}  // namespace

TEST_CASE("open forces beside a contact in the air, and forces that move nothing, are judged like others") {
  const std::string in_space =
      R"({"dimension":3,"W":{"rows":9,"columns":9,"entries":[[0,0,1],[0,3,1],[1,1,1],[1,4,1],[2,2,1],[2,5,1],[3,0,1],)"
      R"([3,3,1],[4,1,1],[4,4,1],[5,2,1],[5,5,1],[6,6,1],[7,7,1],[8,8,1]]},"q":[-1,0,0,-1,0,0,1,0,0],"mu":0.5,)"
      R"("r":[0.5,0,0,0.5,0,0,0,0,0]})";
  const std::string in_plane =
      R"({"dimension":2,"W":{"rows":6,"columns":6,"entries":[[0,0,1],[0,2,1],[1,1,1],[1,3,1],[2,0,1],[2,2,1],[3,1,1],)"
      R"([3,3,1],[4,4,1],[5,5,1]]},"q":[-1,0,-1,0,1,0],"mu":[0.5,0.5,0.5],"r":[0.5,0,0.5,0,0,0]})";
  const std::string nothing_moves =
      R"({"dimension":3,"W":{"rows":6,"columns":6,"entries":[]},"q":[0,0,3,1e-16,-0.5,-1e-16],"mu":[3,0],)"
      R"("r":[0,-1,0,1,0.5,0]})";
  CertifyOptions options;
  options.format = RecordFormat::json_lines;
  const std::string row_of_zeros =
      R"({"dimension":2,"W":[[0,0,0,0],[3,3,0,0],[2,-3,2,0],[-2,0,0,2]],"law":"associated","mu":[0.25,1],)"
      R"("q":[0,0,0,1],"r":[0,0.3,0,0],"u":[0,0,0,1]})";
  const std::string text = in_space + "\n" + in_plane + "\n" + nothing_moves + "\n" + row_of_zeros + "\n";
  const auto lines = certified(text, options).lines();
  REQUIRE(lines.size() == 4);
  CHECK(lines[0]["verdict"] == "solution within rho");
  CHECK(lines[0]["open_forces"]["directions"] == 3);
  CHECK(lines[1]["verdict"] == "solution within rho");
  CHECK(lines[1]["unique"] == "velocities");
  CHECK(lines[1]["open_forces"]["directions"] == 2);
  CHECK(lines[2]["verdict"] == "velocities of a solution within rho");
  CHECK(lines[3]["verdict"] == "wrong");
}

TEST_CASE("a failure inside one record leaves the others judged") {
  const CertifyOptions options;
  JudgedRecords records(options);
  const auto finish = [] {};
  CHECK(records.add(
      1, 1, [](RecordJudgement&) { throw std::runtime_error("out of range"); }, finish));
  CHECK(records.add(
      2, 2, [](RecordJudgement& to) { to = invalid_judgement("NaN"); }, finish));
  const Judged judged = records.result(finish);
  CHECK(judged.lines.starts_with(R"({"record":1,"verdict":"undecided")"));
  CHECK(judged.lines.find("out of range") != std::string::npos);
  CHECK(judged.lines.find(R"({"record":2,"verdict":"invalid")") != std::string::npos);
}

TEST_CASE("each line about a degenerate problem gets a verdict that agrees with the definition of its law") {
  CertifyOptions options;
  options.format = RecordFormat::json_lines;
  options.judge.effort = options.contact.effort = 20'000'000;  // so that none takes seconds
  std::string text;
  std::vector<std::pair<std::uint64_t, Notation>> asked;
  const auto notations = quick<std::uint64_t>(3, 2);  // of each problem
  for (std::uint64_t i = 0; i < problems(); ++i) {
    const RandomCase random = random_case(i);
    for (std::uint64_t k = 0; k < notations; ++k) {
      const auto notation = static_cast<Notation>((i + k) % 3);
      const Json line = line_of(random, notation);
      if (line.is_null()) continue;
      text += line.dump() + '\n';
      asked.emplace_back(i, notation);
    }
  }
  const std::vector<Json> lines = certified(text, options).lines();
  REQUIRE(lines.size() == asked.size());
  std::map<std::string, std::size_t> seen;
  for (std::size_t n = 0; n < lines.size(); ++n) {
    const RandomCase random = random_case(asked[n].first);
    CAPTURE(line_of(random, asked[n].second).dump());
    CAPTURE(lines[n].dump());
    ++seen[lines[n]["verdict"]];
    check_verdict(random, lines[n]);
    if (asked[n].second != Notation::global || random.problem.s.empty()) check_solutions(random, lines[n]);
  }
  for (const char* word : {"certified", "ambiguous", "solution within rho", "unique", "eps-solution", "wrong",
                           "invalid", "inaccurate", "not converged", "no solution"}) {
    CAPTURE(word);
    CHECK(seen[word] > lines.size() / 1000);
  }
}

TEST_CASE("a degenerate problem has one verdict in all formats of files") {
  for (std::uint64_t i = 0; i < problems(); i += 20) {
    const Folder folder;
    RandomCase random = random_case(i);
    if (!random.problem.s.empty()) continue;
    random.problem.law = {}, random.problem.compliance.clear(), random.problem.bias.clear();
    const std::string json = folder.write("p.json", line_of(random, Notation::sparse).dump() + "\n");
    CAPTURE(line_of(random, Notation::sparse).dump());
    const std::string word = verdict_on_file(json, random);
    CHECK(verdict_on_file(folder.write("p.dat", siconos_text(random.problem)), random) == word);
    if (random.problem.q.empty()) continue;
    CHECK(verdict_on_file(write_market(folder, random.problem), random) == word);
#ifdef SLIPPROOF_HDF5
    if (random.problem.dimension > 1) CHECK(verdict_on_file(write_fclib(folder, random.problem), random) == word);
#endif
  }
}

}  // namespace degenerate
