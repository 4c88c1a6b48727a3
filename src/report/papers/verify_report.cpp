#include "report/papers/verify_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <map>

#include "base/number/format.hpp"
#include "report/papers/explain.hpp"
#include "report/papers/second_checker.hpp"

namespace slipproof {

namespace {

using Out = std::back_insert_iterator<std::string>;

/// The accelerations that are not 0; so gaps of contacts that stay closed are left out.
std::string accelerations_text(const Counterexample& e, const MotionAtLoad& motion) {
  const auto names = acceleration_names(e.scene.mechanism);
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const Rational& value = motion.accelerations[i];
    if (!value.is_zero()) text += fmt::format("{}{} = {}", text.empty() ? "" : " ", names[i], exact_text(value));
  }
  return text;
}

std::string range_text(const std::string& name, const Range& range) {
  if (range.is_point()) return fmt::format("{} = {}", name, exact_text(*range.lower));
  return fmt::format("{} in {}", name, to_string(ForceInterval::between(range.lower, true, range.upper, true)));
}

std::string forces_text(const Counterexample& e, const MotionAtLoad& motion) {
  const auto names = force_names(e.scene.mechanism);
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    text += (text.empty() ? "" : " ") + range_text(names[i], motion.forces[i]);
  }
  return text;
}

void write_motion(Out out, const Counterexample& e, const MotionAtLoad& motion) {
  const std::string modes = equal_modes(motion.all_modes());
  const std::string accelerations = accelerations_text(e, motion), forces = forces_text(e, motion);
  fmt::format_to(out, "        {:<23} {:<9} {}\n", modes, motion.strict() ? "strict" : "boundary",
                 accelerations.empty() ? forces : accelerations);
  if (!accelerations.empty() && !forces.empty()) fmt::format_to(out, "        {:<33} {}\n", "", forces);
}

void write_motions(Out out, const Counterexample& e) {
  for (const MotionAtLoad& motion : e.motions->motions) write_motion(out, e, motion);
  const auto names = acceleration_names(e.scene.mechanism);
  for (const ContinuumAtLoad& c : e.motions->continua) {
    fmt::format_to(out, "        {:<23} continuum", name(c.mode));
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (!c.accelerations[i].is_point()) fmt::format_to(out, " {}", range_text(names[i], c.accelerations[i]));
    }
    fmt::format_to(out, "\n");
  }
}

void write_place(Out out, const ClaimsFile& file, const ClaimResult& result, const Counterexample& e) {
  for (const auto& [symbol, value] : place_of(file, result, e)) {
    fmt::format_to(out, " {} = {}", symbol, exact_text(value));
  }
}

void write_counterexample(Out out, const ClaimsFile& file, const ClaimResult& result) {
  const Counterexample& e = *result.counterexample;
  const Setting& setting = file.settings[file.claims[result.claim].setting];
  fmt::format_to(out, "      {}\n      at", explain(file, result));
  write_place(out, file, result, e);
  const bool among_built = !setting.realisable.empty() && e.unrealisable.empty();
  fmt::format_to(out, "{}\n", !e.minimal ? "" : among_built ? " (no simpler one can be built)" : " (no simpler one)");
  if (const std::string built = realisability(file, result); !built.empty()) {
    fmt::format_to(out, "      {}\n", built);
  }
  const bool moves = e.motions && is_about_motions(file.claims[result.claim]);
  if (moves && (!e.motions->motions.empty() || !e.motions->continua.empty())) {
    fmt::format_to(out, "      the motions there:\n");
    write_motions(out, e);
  } else if (moves) {
    fmt::format_to(out, "      {}\n", no_motions(e));
  }
  if (!result.simplest) return;
  fmt::format_to(out, "      simpler, but it cannot be built, for it breaks {}:\n      at",
                 broken_conditions(setting, *result.simplest));
  write_place(out, file, result, *result.simplest);
  fmt::format_to(out, "\n");
}

void write_certificates(Out out, const ClaimResult& claim) {
  for (const std::string& certificate : claim.certificates) fmt::format_to(out, "      by {}\n", certificate);
  for (const std::string& objection : claim.rejections) fmt::format_to(out, "      REJECTED {}\n", objection);
  if (claim.verdict == Verdict::holds && !claim.proved && !claim.unless_zero.empty()) {
    fmt::format_to(out, "      an identity, wherever these are not 0: {}\n", fmt::join(claim.unless_zero, ", "));
  }
  for (const std::string& statement : claim.outdated) fmt::format_to(out, "      outdated {}\n", statement);
  std::string missing;
  for (const CheckedCertificate& statement : claim.unproved) {
    if (statement.state == CertificateState::missing) {
      missing += (missing.empty() ? "" : ", ") + statement.theorem;
      continue;
    }
    fmt::format_to(out, "      {} {}{}{}\n", to_string(statement.state), statement.theorem,
                   statement.message.empty() ? "" : ": ", statement.message);
  }
  if (!missing.empty()) fmt::format_to(out, "      missing {}\n", missing);
}

}  // namespace

Summary summary(const ClaimsFile& file, const VerifyResult& result) {
  const auto rejected = [](const ClaimResult& claim) { return !claim.rejections.empty(); };
  if (std::any_of(result.claims.begin(), result.claims.end(), rejected)) return Summary::rejected;
  Summary worst = result.claims.empty() ? Summary::undecided : Summary::as_expected;
  for (const ClaimResult& claim : result.claims) {
    const auto unreadable = [](const CheckedCertificate& c) { return c.state == CertificateState::unreadable; };
    if (std::any_of(claim.unproved.begin(), claim.unproved.end(), unreadable)) worst = Summary::undecided;
    if (as_expected(file, claim)) continue;
    if (claim.verdict != Verdict::undecided && claim.verdict != Verdict::vacuous) return Summary::refuted;
    worst = Summary::undecided;
  }
  return worst;
}

std::string_view summary_word(Summary summary) {
  constexpr std::array<std::string_view, 4> words{"VERIFIED", "REJECTED", "REFUTED", "UNDECIDED"};
  return words[static_cast<std::size_t>(summary)];
}

std::string verify_text(const ClaimsFile& file, const VerifyResult& result, bool quiet) {
  std::string text;
  Out out(text);
  std::map<Verdict, int> count;
  int unexpected = 0, proved = 0;
  if (!quiet) {
    fmt::format_to(out, "{}\n{} for each setting and {} of them for each claim, seed {}\n", file.paper.title,
                   counted(result.samples, noun(file)), counted(result.lines, "line"), result.seed);
    fmt::format_to(out,
                   "says: at how many {}s the claim says something; tried: of how many (equations and identities "
                   "are tried at one in {})\n\n",
                   noun(file), thinned_to);
    fmt::format_to(out, "  {:<11} {:<9} {:<10} {:>8} {:>8} {:>8}  line\n", "claim", "reading", "verdict", "says",
                   "tried", "refuted");
  }
  for (const ClaimResult& claim : result.claims) {
    const bool expected = as_expected(file, claim);
    ++count[claim.verdict];
    if (!expected) ++unexpected;
    if (claim.proved) ++proved;
    if (quiet) continue;
    fmt::format_to(out, "  {:<11} {:<9} {:<10} {:>8} {:>8} {:>8}  {}{}\n", file.claims[claim.claim].id,
                   name(claim.reading), claim.proved ? "proved" : name(claim.verdict), claim.samples(), claim.tried,
                   claim.refuted, file.claims[claim.claim].line, expected ? "" : "  unexpected");
    write_certificates(out, claim);
    if (!claim.counterexample && claim.verdict != Verdict::holds) {
      fmt::format_to(out, "      {}\n", explain(file, claim));
    }
    if (claim.counterexample) write_counterexample(out, file, claim);
  }
  const Summary s = summary(file, result);
  if (result.claims.empty()) return text + (quiet ? "" : "\n") + "s UNDECIDED no claim was judged\n";
  if (!quiet && result.second_checker) fmt::format_to(out, "\n  {}\n", in_words(*result.second_checker));
  const std::size_t missing = result.missing();
  if (!quiet && missing > 0) fmt::format_to(out, "\n  {}\n", missing_text(missing));
  fmt::format_to(out, "{}s {} holds {} refuted {} undecided {} unexpected {} proved {}{}{}\n", quiet ? "" : "\n",
                 summary_word(s), count[Verdict::holds], count[Verdict::refuted], count[Verdict::undecided], unexpected,
                 proved, count[Verdict::vacuous] == 0 ? "" : fmt::format(" vacuous {}", count[Verdict::vacuous]),
                 missing == 0 ? "" : fmt::format(" missing {}", missing));
  return text;
}

}  // namespace slipproof
