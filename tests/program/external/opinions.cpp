// What z3 and cvc5 say of the shipped statements and certificates, beside the prover and the checker: a table. All
// times are processor times. A program that is not installed is left out. Environment variables: SLIPPROOF_SECONDS
// (10): limit on a query; 0: ask nothing SLIPPROOF_JOBS (2): how many run at a time SLIPPROOF_ANSWERS: a folder that
// keeps answers by the text of their question, so that only what changed is asked again; SLIPPROOF_PAPER: the folder of
// one paper, to ask about it alone; SLIPPROOF_WRITE_OPINIONS: if set, the answers become those columns of
// proofs/PAPER/second-opinions.csv (what Coq says stays)
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <functional>
#include <future>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "proofs/check/files.hpp"
#include "proofs/search/prove_files.hpp"
#include "support/run_program.hpp"

using namespace slipproof;
using test::quoted;
using test::read_file;
using test::run;
using test::TemporaryFolder;

namespace {

const std::filesystem::path kFolder = SLIPPROOF_SOURCE_DIR "/proofs";
const std::filesystem::path kProofs = kFolder / "rozenblat-yashin";

std::string setting(const char* name, const char* otherwise) {
  const char* value = std::getenv(name);
  return value == nullptr ? otherwise : value;
}

const std::string kSeconds = setting("SLIPPROOF_SECONDS", "10");

bool installed(const std::string& program) {
  const bool found = std::system(("command -v " + program + " >/dev/null").c_str()) == 0;
  if (!found) MESSAGE(program, " is not installed: skipped");
  return found;
}

struct Answer {
  /// `unsat`, `proved`, ...; `timeout`; `unknown`: given up; `-`: not asked; otherwise a contradiction or
  /// an error
  std::string text = "-";
  double seconds = 0;  ///< of processor time
};

double processor_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// What this thread answers.
template <class Action>
Answer timed(const Action& action) {
  const double begin = processor_seconds();
  Answer answer{action()};
  answer.seconds = processor_seconds() - begin;
  return answer;
}

/// What the shell command writes, with a limit on its processor time.
Answer output(const std::string& command, const std::string& seconds) {
  const TemporaryFolder folder;
  const auto out = folder.path() / "out", times = folder.path() / "times";
  const std::string limited = "exec 2>/dev/null; (ulimit -t " + seconds + "; " + command + ") >" +
                              quoted(out.string()) + " 2>&1; times >" + quoted(times.string());
  if (std::system(limited.c_str()) < 0) return {};
  // The second line of `times` is of the children, user and system: 0m3.2s 0m0.1s
  std::istringstream children(read_file(times));
  std::string line;
  std::getline(children, line);
  Answer answer{read_file(out)};
  double minutes = 0, part = 0;
  for (char m = 0, s = 0; children >> minutes >> m >> part >> s;) answer.seconds += 60 * minutes + part;
  return answer;
}

/// The answer kept to a question, or the one that `ask` gives, kept from now on. A question that ran out of its limit
/// is asked again with a higher one.
Answer kept(const std::string& program, const std::string& question, const std::string& limit,
            const std::function<Answer()>& ask) {
  const std::string folder = setting("SLIPPROOF_ANSWERS", "");
  const auto file = std::filesystem::path(folder) /
                    fmt::format("{}-{:016x}-{}", program, std::hash<std::string>{}(question), question.size());
  if (!folder.empty()) {
    Answer answer;
    int asked_for = 0;
    if (std::ifstream(file) >> answer.text >> answer.seconds >> asked_for &&
        (answer.text != "timeout" || asked_for >= std::stoi(limit))) {
      return answer;
    }
  }
  if (limit == "0") return {};
  const Answer answer = ask();
  if (!folder.empty() && answer.text.find_first_of(" \n") == std::string::npos) {
    std::ofstream(file) << answer.text << ' ' << answer.seconds << ' ' << limit << '\n';
  }
  return answer;
}

Answer solver(const std::string& program, const std::filesystem::path& file) {
  return kept(program, read_file(file), kSeconds, [&] {
    Answer answer = output(program + " " + quoted(file.string()), kSeconds);
    for (const char* known : {"unsat", "sat", "unknown"}) {
      if (answer.text.starts_with(known)) return Answer{known, answer.seconds};
    }
    if (answer.text.find("rror") == std::string::npos) answer.text = "timeout";
    return answer;
  });
}

struct Row {
  std::string name;  ///< without extension, in the folder of the paper
  Answer check, prove, z3, z3_values, cvc5;
};

std::string cell(const Answer& answer) {
  return answer.text == "-" ? "-" : fmt::format("{} {:.2f}", answer.text, answer.seconds);
}

/// What each program says of the statements of one paper.
std::vector<Row> ask_all(const std::filesystem::path& paper) {
  const bool z3 = installed("z3"), cvc5 = installed("cvc5");
  const TemporaryFolder folder;
  REQUIRE(run({"prove", paper / "claims.toml", "--smtlib", folder.path() / "smt"}).exit_code == 0);
  const auto statements = statements_in(paper);
  std::vector<Row> rows(statements.size());
  check::Checker checker;
  const auto ask = [&](std::size_t i) {
    const std::filesystem::path name = statements[i].lexically_relative(paper);
    const auto file = [&](const char* extension) {  // the statements of FILE.theorems are in the folder FILE
      const std::filesystem::path below = name.parent_path().replace_extension() / name.filename();
      return (folder.path() / "smt" / below).replace_extension(extension);
    };
    Row& row = rows[i];
    row.name = std::filesystem::path(name).replace_extension().string();
    row.check =
        timed([&] { return std::string(check::to_string(checker.check(certificate_of(statements[i])).verdict)); });
    row.prove = timed([&] {
      return std::string(prove_statement(statements[i].string(), read_file(statements[i])).proved() ? "proved" : "?");
    });
    if (z3) row.z3 = solver("z3", file(".smt2"));
    const auto values = file(".witness.smt2");
    if (z3 && std::filesystem::exists(values)) row.z3_values = solver("z3", values);
    if (cvc5) row.cvc5 = solver("cvc5", file(".smt2"));
  };
  std::atomic<std::size_t> next = 0;
  const auto work = [&] {
    for (std::size_t i = next++; i < rows.size(); i = next++) ask(i);
  };
  std::vector<std::future<void>> jobs(std::stoul(setting("SLIPPROOF_JOBS", "2")));
  for (auto& job : jobs) job = std::async(std::launch::async, work);
  for (auto& job : jobs) job.get();
  return rows;
}

/// For other programs: one line a statement. With values for the unknowns, z3 confirms the statement, too.
void write_opinions(const std::filesystem::path& paper, const std::vector<Row>& rows) {
  std::map<std::string, std::string> coq;  // by statement
  std::istringstream old(read_file(paper / "second-opinions.csv"));
  for (std::string line; std::getline(old, line);)
    coq[line.substr(0, line.find(','))] = line.substr(line.rfind(',') + 1);
  std::ofstream file(paper / "second-opinions.csv", std::ios::binary);
  file << "statement,z3,cvc5,coq\n";
  for (const Row& row : rows) {
    const std::string& z3 = row.z3_values.text == "unsat" ? row.z3_values.text : row.z3.text;
    file << row.name << ',' << z3 << ',' << row.cvc5.text << ',' << (coq.contains(row.name) ? coq[row.name] : "-")
         << '\n';
  }
}

/// All of them, or SLIPPROOF_PAPER alone.
std::vector<std::string> papers() {
  if (const char* one = std::getenv("SLIPPROOF_PAPER")) return {one};
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(kFolder)) {
    if (std::filesystem::exists(entry.path() / "claims.toml")) names.push_back(entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace

TEST_CASE("nobody contradicts the shipped proofs") {
  std::vector<Row> rows;
  for (const std::string& name : papers()) {
    std::vector<Row> more = ask_all(kFolder / name);
    if (std::getenv("SLIPPROOF_WRITE_OPINIONS") != nullptr) write_opinions(kFolder / name, more);
    for (Row& row : more) {
      row.name = name + "/" + row.name;
      rows.push_back(std::move(row));
    }
  }

  std::string table =
      "| statement | check, ms | prove, s | z3, s | z3 with values, s | cvc5, s "
      "|\n|---|---|---|---|---|---|\n";
  double check = 0, prove = 0, solver_time[3] = {};
  int decided[3] = {};
  for (const Row& row : rows) {
    table += fmt::format("| {} | {:.1f} | {} | {} | {} | {} |\n", row.name, 1000 * row.check.seconds, cell(row.prove),
                         cell(row.z3), cell(row.z3_values), cell(row.cvc5));
    check += row.check.seconds;
    prove += row.prove.seconds;
    const Answer* others[] = {&row.z3, &row.z3_values, &row.cvc5};
    for (int k = 0; k < 3; ++k) {
      solver_time[k] += others[k]->seconds;
      decided[k] += others[k]->text == "unsat";
    }
    CAPTURE(row.name);
    CHECK(row.check.text == "accepted");
    for (const Answer* answer : others) {
      CAPTURE(answer->text);
      const bool fine =
          answer->text == "unsat" || answer->text == "timeout" || answer->text == "unknown" || answer->text == "-";
      CHECK(fine);
    }
  }
  table += fmt::format("| all {} | {:.0f} | {:.1f} | {} in {:.0f} | {} in {:.0f} | {} in {:.0f} |\n", rows.size(),
                       1000 * check, prove, decided[0], solver_time[0], decided[1], solver_time[1], decided[2],
                       solver_time[2]);
  fmt::print("{}", table);
  CHECK((!installed("z3") || kSeconds == "0" || decided[0] > 0));
  CHECK((!installed("cvc5") || kSeconds == "0" || decided[2] > 0));
}

TEST_CASE("z3 contradicts statements that are made false") {
  if (!installed("z3")) return;
  struct Change {
    const char *theorem, *from, *to;
  };
  for (const Change& change :
       std::vector<Change>{{"claims.theorems/A1.1.only-then", "F * sigma < xi1", "F * sigma < xi1/2"},
                           {"claims.theorems/A2.1.repaired.only-then", "< xi2", "< (xi2 + xi3)/2"},
                           {"claims.theorems/A3.2", "b < b0", "b < 2*b0"},
                           {"claims.theorems/A4.1.only-then", "< xi6", "< (xi4 + xi6)/2"},
                           {"claims.theorems/A1.cover", "b0 < b", "2*b0 < b"},
                           {"by-hand.theorems/A2.1.printed-refuted", "P < xi3", "P > xi3"}}) {
    CAPTURE(std::string(change.theorem));
    const TemporaryFolder folder;
    std::string text = read_file(kProofs / (std::string(change.theorem) + ".statement"));
    const auto place = text.rfind(change.from);
    REQUIRE(place != std::string::npos);
    folder.write("changed.statement", text.replace(place, std::string(change.from).size(), change.to));
    REQUIRE(run({"prove", folder.path() / "claims.toml", "--smtlib", folder.path()}).exit_code == 0);
    CHECK(solver("z3", folder.path() / "changed.smt2").text == "sat");
  }
}
