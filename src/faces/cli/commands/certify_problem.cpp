#include "faces/cli/commands/certify_problem.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <iostream>

#include "base/output/output_file.hpp"
#include "base/output/terminal.hpp"
#include "contact/formats/problem_check.hpp"
#include "contact/formats/read_files.hpp"
#include "contact/judge/certificate.hpp"
#include "contact/judge/problem_name.hpp"
#include "faces/cli/progress.hpp"
#include "proofs/check_contact/files.hpp"
#include "records/problems/contact_record.hpp"
#include "report/html/contact_report.hpp"
#include "report/scenes/contact_words.hpp"
#include "report/values/exact_json.hpp"

namespace slipproof::cli {

namespace {

int exit_code_of(const JudgedProblem& problem) {
  int code = success;
  for (const JudgedAnswer& answer : problem.answers) {
    if (is_certified(answer.judgement.verdict)) continue;
    if (answer.judgement.verdict != ContactVerdict::undecided) return refuted_or_not_certified;
    code = undecided;
  }
  return code;
}

std::string last_line(const JudgedProblem& problem, int code) {
  const auto certified = std::count_if(problem.answers.begin(), problem.answers.end(),
                                       [](const auto& a) { return is_certified(a.judgement.verdict); });
  const char* verdict = code == success ? "CERTIFIED" : code == undecided ? "UNDECIDED" : "NOT CERTIFIED";
  return fmt::format("s {} {}/{}\n", verdict, certified, problem.answers.size());
}

/// Quotes a word so that a shell reads it back unchanged.
std::string in_shell(const std::string& word) {
  const auto plain = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 ||
           std::string_view("_./+-=:,@%").find(c) != std::string::npos;
  };
  if (std::all_of(word.begin(), word.end(), plain)) return word;
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + '\'';
}

/// The command that makes the page again, with all options that the verdicts depend on.
std::string command_line(const CertifyProblemArguments& options) {
  std::string text = "slipproof certify " + in_shell(options.file);
  const auto add = [&](const char* option, const std::string& value) {
    text += std::string(" ") + option + ' ' + in_shell(value);
  };
  if (!options.answer.empty()) add("--answer", options.answer);
  if (options.refine) text += " --refine";
  if (options.all) text += " --all";
  if (!options.law.empty()) add("--law", options.law);
  if (options.tolerance) add("--tolerance", fmt::format("{}", *options.tolerance));
  if (options.within) add("--within", fmt::format("{}", *options.within));
  if (options.effort) add("--effort", fmt::format("{}", *options.effort));
  add("--report", options.report);
  return text;
}

/// Checks a certificate, which must be about this problem, as slipproof-check-contact does.
int check_certificate(const CertifyProblemArguments& options, const ProblemFile& problem, const CommonOptions& common) {
  CertifyProblemArguments others = options;
  others.check_certificate.clear();
  if (others.any()) {
    throw CLI::ValidationError("--check-certificate",
                               "found an option about an answer, expected none: --check-certificate judges no answer");
  }
  const std::string name = problem_name(mixed_problem(problem));
  const check_contact::ContactReport report = check_contact::check_contact_files({options.check_certificate}, name);
  if (!common.json) {
    print((common.quiet ? "" : report.text) + report.summary);
    return report.exit_code;
  }
  const auto& [verdict, message] = report.verdicts.front();
  Json document;
  document["schema"] = "slipproof/check-contact/1";
  document["problem"] = options.file;
  document["name"] = name;
  document["certificate"] = options.check_certificate;
  document["verdict"] = to_string(verdict);
  document["message"] = message;
  print(dump(document));
  return report.exit_code;
}

}  // namespace

ContactFileOptions CertifyProblemArguments::judging() const {
  ContactFileOptions options;
  if (tolerance) options.judge.tolerance = *tolerance;
  if (effort) options.judge.effort = *effort;
  options.judge.within = within;
  options.judge.refine = refine;
  options.judge.all = all;
  options.law = law_called(law);
  return options;
}

void add_problem_options(CLI::App& command, CertifyProblemArguments& options) {
  const auto group = command.add_option_group("Contact problems", problem_formats());
  group->add_option("--answer", options.answer, "The solver's answer: text, NumPy, MatrixMarket, JSON, HDF5");
  group
      ->add_option("--refine", options.refined,
                   "Look for a solution near the answer, or without one; with a FILE write it there, as JSON")
      ->expected(0, 1);
  group->add_flag("--all", options.all, "Find all solutions, in space as well, and prove that there are no others");
  group->add_option("--certificate", options.certificate,
                    "Write a certificate for slipproof-check-contact to this file");
  group->add_option("--report", options.report, "Write a page that draws the contacts in their cones");
  group
      ->add_option(
          "--within", options.within,
          "What is near: without it a hundredth of the largest force. No solution within this radius is proved, "
          "or the answer has not converged")
      ->check(number_in(0, 1e300));
  group->add_option("--law", options.law, "The law of contact, in place of the one that the problem names")
      ->check(CLI::IsMember(law_words()));
  group->add_option("--check-certificate", options.check_certificate,
                    "Judge no answer; check this certificate, and that it is about this problem");
}

int run_certify_problem(const CertifyProblemArguments& options, const GateArguments& gate_options,
                        const CommonOptions& common) {
  expect_page_name("--report", options.report);
  ContactFileOptions judge = options.judging();
  ReadProblem read = read_problem_file(options.file);
  if (!options.check_certificate.empty()) return check_certificate(options, read.problem, common);
  if (!options.answer.empty()) {
    judge.answer = read_answer_file(options.answer, answer_sizes(read.problem));
    Mistakes mistakes(options.answer);
    check_answer(read.problem, *judge.answer, "the answer's ", mistakes);
    mistakes.refuse_if_any();
  }
  const Inputs inputs{options.file, options.answer};
  refuse_one_file_twice({options.refined, options.certificate, options.report, gate_options.junit, gate_options.sarif});
  std::optional<OutputFile> refined, certificate, report;
  if (!options.refined.empty()) refined.emplace(options.refined, inputs);
  if (!options.certificate.empty()) certificate.emplace(options.certificate, inputs);
  if (!options.report.empty()) report.emplace(options.report, inputs);

  Gate gate(gate_options, options.file, inputs);
  ProgressLine line(!common.quiet);
  if (line.is_shown()) {
    judge.judge.progress = [&](const SearchState& at) {
      line.at(at.patterns, 0, fmt::format("{} patterns, {} open; {} motions found", at.patterns, at.open, at.motions));
    };
  }
  const JudgedProblem problem = judge_problem_file(options.file, std::move(read), judge);
  line.clear();
  std::string lines, words;
  for (std::size_t i = 0; i < problem.answers.size(); ++i) {
    lines += contact_line(problem, i) + '\n';
    words += contact_words(problem, i);
    if (const std::string help = advice(problem.answers[i].judgement); !help.empty()) words += "  " + help + '\n';
    gate.add(i + 1, as_record(problem, i));
  }
  const int code = exit_code_of(problem);
  words += last_line(problem, code);
  const bool in_words = common.quiet || is_terminal(STDOUT_FILENO);
  if (common.json || !in_words) print(lines);  // printed before other output is made, which may fail
  if (refined) {
    const std::string text = refined_answer(problem, 0);
    if (text.empty()) {
      words = "no improved answer: no solution is enclosed\n" + words;
    } else {
      refined->write(text);
    }
  }
  if (certificate) {
    const std::string text = contact_certificate(problem.mixed, problem.first().judgement);
    if (text.empty()) {
      words = "no certificate: nothing is proved about this answer\n" + words;
    } else {
      certificate->write(text);
    }
  }
  if (report) report->write(contact_report(problem, command_line(options), SLIPPROOF_VERSION));
  if (!common.json) {
    print(in_words ? narrow(words) : words);
  } else if (!common.quiet) {
    std::cerr << words;
  }
  gate.write();
  return gate.exit_code(code);
}

}  // namespace slipproof::cli
