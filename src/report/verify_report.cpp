#include "report/verify_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <map>

#include "number/format.hpp"

namespace slipproof {

namespace {

using Out = std::back_insert_iterator<std::string>;

std::string mode_of(const Judgement& j) {
  return j.mode ? name(*j.mode) : std::string("no mode");
}

std::string forces(const Judgement& j, const std::string& F) {
  if (!j.witnesses || j.witnesses->empty()) return "";
  return fmt::format(" for {} in {}", F, to_string(*j.witnesses));
}

void write_motions(Out out, const Counterexample& e) {
  for (const auto& motion : e.motions->motions) {
    std::string modes;
    for (const ContactMode mode : motion.modes) modes += (modes.empty() ? "" : " = ") + name(mode);
    fmt::format_to(out, "        {:<24}{:<9}", modes, motion.strict ? "strict" : "boundary");
    using enum Quantity;
    for (const Quantity q : {a, S2, S3, N2, N3, slip2, slip3}) {
      fmt::format_to(out, " {} = {}", name(q), exact_text(motion.values[q]));
    }
    if (sign(motion.values[gap2]) != 0) fmt::format_to(out, " gap2 = {}", exact_text(motion.values[gap2]));
    if (sign(motion.values[gap3]) != 0) fmt::format_to(out, " gap3 = {}", exact_text(motion.values[gap3]));
    fmt::format_to(out, "\n");
  }
  for (const auto& c : e.motions->continua) {
    fmt::format_to(out, "        {:<24}continuum", name(c.continuum->mode));
    for (std::size_t k = 0; k < c.parameters.size(); ++k) {
      fmt::format_to(out, " {} in {}", name(c.continuum->parameters[k]), to_string(c.parameters[k]));
    }
    fmt::format_to(out, "\n");
  }
}

void write_counterexample(Out out, const ClaimsFile& file, const ClaimResult& result) {
  const Counterexample& e = *result.counterexample;
  const Setting& setting = file.settings[file.claims[result.claim].setting];
  fmt::format_to(out, "      {}\n      at", explain(file, result));
  for (std::size_t k = 0; k < e.values.size(); ++k) {
    fmt::format_to(out, " {} = {}", setting.parameters[k].symbol, exact_text(e.values[k]));
  }
  if (e.force) fmt::format_to(out, ", {} = {}", setting.force.symbol, exact_text(*e.force));
  fmt::format_to(out, "{}\n", e.minimal ? " (no simpler one)" : "");
  if (!e.motions) return;
  fmt::format_to(out, "      the motions there:\n");
  write_motions(out, e);
}

void write_certificates(Out out, const ClaimResult& claim) {
  for (const std::string& certificate : claim.certificates) fmt::format_to(out, "      by {}\n", certificate);
  for (const std::string& objection : claim.rejections) fmt::format_to(out, "      REJECTED {}\n", objection);
  if (claim.verdict == Verdict::holds && !claim.proved && !claim.unless_zero.empty()) {
    fmt::format_to(out, "      an identity, wherever these are not 0: {}\n", fmt::join(claim.unless_zero, ", "));
  }
  for (const std::string& statement : claim.outdated) fmt::format_to(out, "      outdated {}\n", statement);
  for (const CheckedCertificate& statement : claim.unproved) {
    fmt::format_to(out, "      {} {}{}{}\n", to_string(statement.state), statement.theorem,
                   statement.message.empty() ? "" : ": ", statement.message);
  }
}

}  // namespace

std::string explain(const ClaimsFile& file, const ClaimResult& result) {
  if (!result.counterexample) {
    if (result.verdict == Verdict::vacuous) return "it says something of no bicycle at all";
    if (result.verdict != Verdict::refuted) return "";
    const bool seeks = file.claims[result.claim].is<Exists>();
    return seeks ? "proved: there is none" : "proved to be false; no sample is a counterexample";
  }
  const Judgement& j = result.counterexample->judgement;
  const std::string& F = file.settings[file.claims[result.claim].setting].force.symbol;
  switch (j.reason) {
    case Reason::ends:
    case Reason::forces:
      return fmt::format("{}: claimed {} in {}, real {} in {}", mode_of(j), F,
                         j.claimed ? to_string(*j.claimed) : "several intervals", F, to_string(*j.real));
    case Reason::exists:
      return fmt::format("{} exists{}", mode_of(j), forces(j, F));
    case Reason::formula:
      return fmt::format("another value{}", forces(j, F));
    case Reason::continuum:
      return fmt::format("{} is a continuum of motions{}", mode_of(j), forces(j, F));
    case Reason::extra:
      return fmt::format("{} is a motion that the claim does not have{}", mode_of(j), forces(j, F));
    case Reason::missing:
      return fmt::format("{} is missing{}", j.mode ? mode_of(j) : "every motion", forces(j, F));
    case Reason::uncovered:
      if (j.real && !j.real->empty()) {
        return fmt::format("no line speaks of this bicycle, yet {} exists for {} in {}", mode_of(j), F,
                           to_string(*j.real));
      }
      return fmt::format("no line speaks of this bicycle; {} does not exist there", mode_of(j));
    case Reason::limit:
      return "false however large the parameter";
    case Reason::equation:
      return "an equation does not follow";
    case Reason::none:
    case Reason::no_value:
      break;
  }
  return "the claim has no value";
}

Summary summary(const ClaimsFile& file, const VerifyResult& result) {
  const auto rejected = [](const ClaimResult& claim) { return !claim.rejections.empty(); };
  if (std::any_of(result.claims.begin(), result.claims.end(), rejected)) return Summary::rejected;
  Summary worst = Summary::as_expected;
  for (const ClaimResult& claim : result.claims) {
    const auto unreadable = [](const CheckedCertificate& c) { return c.state == CertificateState::unreadable; };
    if (std::any_of(claim.unproved.begin(), claim.unproved.end(), unreadable)) worst = Summary::undecided;
    if (as_expected(file, claim)) continue;
    if (claim.verdict != Verdict::undecided && claim.verdict != Verdict::vacuous) return Summary::refuted;
    worst = Summary::undecided;
  }
  return worst;
}

std::string verify_text(const ClaimsFile& file, const VerifyResult& result, bool quiet) {
  std::string text;
  Out out(text);
  std::map<Verdict, int> count;
  int unexpected = 0, proved = 0;
  if (!quiet) {
    fmt::format_to(out, "{}\n{} bicycles for each setting and {} lines of them for each claim, seed {}\n\n",
                   file.paper.title, result.samples, result.lines, result.seed);
    fmt::format_to(out, "  {:<11} {:<9} {:<10} {:>8} {:>8}  line\n", "claim", "reading", "verdict", "samples",
                   "refuted");
  }
  for (const ClaimResult& claim : result.claims) {
    const bool expected = as_expected(file, claim);
    ++count[claim.verdict];
    if (!expected) ++unexpected;
    if (claim.proved) ++proved;
    if (quiet) continue;
    fmt::format_to(out, "  {:<11} {:<9} {:<10} {:>8} {:>8}  {}{}\n", file.claims[claim.claim].id, name(claim.reading),
                   claim.proved ? "proved" : name(claim.verdict), claim.samples(), claim.refuted,
                   file.claims[claim.claim].line, expected ? "" : "  unexpected");
    write_certificates(out, claim);
    if (claim.counterexample) write_counterexample(out, file, claim);
  }
  const Summary s = summary(file, result);
  constexpr std::array<const char*, 4> words{"VERIFIED", "REJECTED", "REFUTED", "UNDECIDED"};
  fmt::format_to(out, "{}s {} holds {} refuted {} undecided {} unexpected {} proved {}{}\n", quiet ? "" : "\n",
                 words[static_cast<std::size_t>(s)], count[Verdict::holds], count[Verdict::refuted],
                 count[Verdict::undecided], unexpected, proved,
                 count[Verdict::vacuous] == 0 ? "" : fmt::format(" vacuous {}", count[Verdict::vacuous]));
  return text;
}

}  // namespace slipproof
