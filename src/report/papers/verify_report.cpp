#include "report/papers/verify_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

#include "base/number/format.hpp"
#include "base/output/listed.hpp"
#include "report/papers/claim_counts.hpp"
#include "report/papers/explain.hpp"
#include "report/papers/second_checker.hpp"

namespace slipproof {

namespace {

/// The accelerations that are not 0; so gaps of contacts that stay closed are left out.
std::string accelerations_text(const Counterexample& e, const MotionAtLoad& motion) {
  const auto names = acceleration_names(e.scene.mechanism);
  std::vector<std::string> words;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const Rational& value = motion.accelerations[i];
    if (!value.is_zero()) words.push_back(names[i] + " = " + exact_text(value));
  }
  return listed(words, " ");
}

std::string range_text(const std::string& name, const Range& range) {
  if (range.is_point()) return fmt::format("{} = {}", name, exact_text(*range.lower));
  return fmt::format("{} in {}", name, to_string(ForceInterval::between(range.lower, true, range.upper, true)));
}

std::string forces_text(const Counterexample& e, const MotionAtLoad& motion) {
  const auto names = force_names(e.scene.mechanism);
  std::vector<std::string> words;
  for (std::size_t i = 0; i < names.size(); ++i) words.push_back(range_text(names[i], motion.forces[i]));
  return listed(words, " ");
}

ReportTable motions_table(const Counterexample& e) {
  ReportTable table{{{"", false, 23}, {"", false, 9}, ""}};
  for (const MotionAtLoad& motion : e.motions->motions) {
    const std::string accelerations = accelerations_text(e, motion), forces = forces_text(e, motion);
    table.row({equal_modes(motion.all_modes()), motion.strict() ? "strict" : "boundary",
               accelerations.empty() ? forces : accelerations});
    if (!accelerations.empty() && !forces.empty()) table.row({"", "", forces});
  }
  const auto names = acceleration_names(e.scene.mechanism);
  for (const ContinuumAtLoad& c : e.motions->continua) {
    std::vector<std::string> words;
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (!c.accelerations[i].is_point()) words.push_back(range_text(names[i], c.accelerations[i]));
    }
    table.row({name(c.mode), "continuum", listed(words, " ")});
  }
  return table;
}

std::string place_text(const ClaimsFile& file, const ClaimResult& result, const Counterexample& e) {
  std::string text = "at";
  for (const auto& [symbol, value] : place_of(file, result, e)) text += " " + symbol + " = " + exact_text(value);
  return text;
}

void write_counterexample(Document& document, const ClaimsFile& file, const ClaimResult& result) {
  const Counterexample& e = *result.counterexample;
  const Setting& setting = file.settings[file.claims[result.claim].setting];
  document.line(explain(file, result));
  const bool among_built = !setting.realisable.empty() && e.unrealisable.empty();
  document.line(place_text(file, result, e) + (!e.minimal    ? ""
                                               : among_built ? " (no simpler one can be built)"
                                                             : " (no simpler one)"));
  document.line(realisability(file, result));
  const bool moves = e.motions && is_about_motions(file.claims[result.claim]);
  if (moves && (!e.motions->motions.empty() || !e.motions->continua.empty())) {
    document.item("the motions there:").table(motions_table(e));
  } else if (moves) {
    document.line(no_motions(e));
  }
  if (!result.simplest) return;
  document.line("simpler, but it cannot be built, for it breaks " + broken_conditions(setting, *result.simplest) + ":");
  document.line(place_text(file, result, *result.simplest));
}

constexpr std::size_t few_names = 12;

/// Of many names how many they are, with the first and the last.
std::string number_and_ends(const std::string& word, const std::vector<std::string>& found) {
  return fmt::format("{} {}, {} to {}; --names lists them", word, counted(found.size(), "certificate"), found.front(),
                     found.back());
}

void write_certificates(Document& document, const ClaimResult& claim, Names names) {
  const auto are_many = [&](const std::vector<std::string>& found) {
    return names == Names::few && found.size() > few_names;
  };
  if (are_many(claim.certificates)) {
    document.line(number_and_ends("by", claim.certificates));
  } else {
    for (const std::string& certificate : claim.certificates) document.line("by " + certificate);
  }
  for (const std::string& objection : claim.rejections) document.line("REJECTED " + objection);
  if (const std::string where = claim.identity_where(); claim.verdict == Verdict::holds && !where.empty()) {
    document.line("an identity, wherever " + where);
  }
  for (const std::string& statement : claim.outdated) document.line("outdated " + statement);
  std::vector<std::string> missing;
  for (const CheckedCertificate& statement : claim.unproved) {
    if (statement.state == CertificateState::missing) {
      missing.push_back(statement.theorem);
    } else {
      document.line(std::string(to_string(statement.state)) + " " + statement.theorem +
                    (statement.message.empty() ? "" : ": ") + statement.message);
    }
  }
  if (missing.empty()) return;
  document.line(are_many(missing) ? number_and_ends("missing", missing) : "missing " + listed(missing));
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

Document verify_document(const ClaimsFile& file, const VerifyResult& result, Names names) {
  Document document;
  document.title(file.paper.title);
  document.line(fmt::format("{} for each setting and {} of them for each claim, seed {}",
                            counted(result.samples, noun(file)), counted(result.lines, "line"), result.seed));
  document.line(fmt::format(
      "tried: how many {0}s; says: at how many of them the claim says something; refuted: at how many it is false. An "
      "equation is tried at every {1}th {0} only: if it is not an identity, nearly every one shows that.",
      noun(file), thinned_to));
  ReportTable& table = document.table({{{"claim", false, 10},
                                        {"reading", false, 8},
                                        {"verdict", false, 9},
                                        {"says", true, 8},
                                        {"tried", true, 7},
                                        {"refuted", true, 7},
                                        "line"}});
  std::map<Verdict, int> count;
  int unexpected = 0, proved = 0;
  for (const ClaimResult& claim : result.claims) {
    const bool expected = as_expected(file, claim);
    ++count[claim.verdict];
    if (!expected) ++unexpected;
    if (claim.proved) ++proved;
    const Claim& stated = file.claims[claim.claim];
    std::vector<ReportCell> cells{stated.id,
                                  stated.reading_name(claim.reading),
                                  claim.proved ? "proved" : name(claim.verdict),
                                  std::to_string(claim.samples()),
                                  std::to_string(claim.tried),
                                  std::to_string(claim.refuted),
                                  std::to_string(stated.line)};
    if (!expected) cells.emplace_back("unexpected");
    Document& below = table.row(std::move(cells));
    write_certificates(below, claim, names);
    if (!claim.counterexample && claim.verdict != Verdict::holds) below.line(explain(file, claim));
    if (claim.counterexample) write_counterexample(below, file, claim);
  }
  if (result.claims.empty()) {
    document.status("s UNDECIDED no claim was judged");
    return document;
  }
  if (result.second_checker) document.line(in_words(*result.second_checker), 2);
  const std::size_t missing = result.missing();
  if (missing > 0) document.line(missing_text(missing), 2);
  document.line(counts_text(count_claims(file, result)), 2);
  document.status(fmt::format("s {} holds {} refuted {} undecided {} unexpected {} proved {}{}{}",
                              summary_word(summary(file, result)), count[Verdict::holds], count[Verdict::refuted],
                              count[Verdict::undecided], unexpected, proved,
                              count[Verdict::vacuous] == 0 ? "" : fmt::format(" vacuous {}", count[Verdict::vacuous]),
                              missing == 0 ? "" : fmt::format(" missing {}", missing)));
  return document;
}

}  // namespace slipproof
