#include "claims/meaning/comparison.hpp"

#include <doctest/doctest.h>

#include <algorithm>

#include "base/input/diagnostic.hpp"
#include "claims/judge/judge.hpp"
#include "claims/meaning/random/random_kinds.hpp"
#include "claims/meaning/random/shrink.hpp"
#include "claims/meaning/statement_judge.hpp"
#include "claims/reading/read_claims_file.hpp"
#include "claims/statements/claim_statements.hpp"
#include "support/run_program.hpp"

namespace slipproof::test {

namespace {

using meaning::Says;

Says in_words_of_the_page(Outcome outcome) {
  switch (outcome) {
    case Outcome::outside:
      return Says::nothing;
    case Outcome::holds:
      return Says::right;
    case Outcome::refuted:
      return Says::wrong;
    case Outcome::undecided:
      break;
  }
  return Says::no_value;
}

std::string describe(const meaning::Values& bicycle) {
  std::string result;
  for (const auto& [symbol, value] : bicycle) result += symbol + " = " + value.str() + "; ";
  return result;
}

std::string text(const meaning::File& file) {
  return file.text() + (file.setting.mechanics ? "\nwith mechanism.toml:\n" + file.setting.mechanics->text() : "");
}

/// What is no statement by the grammar of FORMAT.md: where statements have no word for a claim, there should be none.
std::string unreadable(const std::vector<NamedStatement>& statements) {
  for (const NamedStatement& statement : statements) {
    try {
      read_statement("random", statement.text);
    } catch (const InputError& error) {
      const std::string message = error.what();
      return "no statement: " + message.substr(message.rfind(": ") + 2);
    }
  }
  return "";
}

}  // namespace

std::vector<Rational> in_order(const meaning::Setting& setting, const meaning::Values& bicycle) {
  std::vector<Rational> result;
  for (const auto& parameter : setting.parameters) result.push_back(bicycle.at(parameter.symbol));
  if (setting.angle) result.push_back(bicycle.at("beta"));
  return result;
}

ClaimsFile read(const meaning::File& file) {
  static const TemporaryFolder folder;
  if (!file.setting.mechanics) return parse_claims(file.text(), "random.toml");
  folder.write("mechanism.toml", file.setting.mechanics->text());
  return parse_claims(file.text(), (folder.path() / "random.toml").string());
}

void Comparison::run(std::uint64_t wanted) {
  for (std::size_t i = 0; pairs < wanted; ++i) of(random_.next(meaning::kinds[i % meaning::kinds.size()]));
  for (const auto& [difference, count] : differences_) MESSAGE(difference << ": " << count << " times");
  MESSAGE(pairs << " pairs, out of reach " << out_of_reach);
}

void Comparison::of(const meaning::Case& random) {
  const ClaimsFile file = read(random.file);
  for (const meaning::Values& bicycle : random.bicycles) {
    if (!meaning::World::is_bicycle(random.file.setting, bicycle)) continue;
    for (std::size_t i = 0; i < random.file.claims.size(); ++i) {
      try {
        const auto world = meaning::World::make(random.file.setting, bicycle);
        const Says says = meaning::SecondJudge(random.file, *world).judge(i);
        const std::string difference = different({random.file, file, *world, bicycle, i, says});
        ++pairs;
        ++counts[random.file.claims[i].kind][says];
        if (!difference.empty()) report(random.file, bicycle, i, difference);
      } catch (const meaning::OutOfReach&) {
        ++out_of_reach;
      }
    }
  }
}

std::string Comparison::different(const Pair& pair) const {
  const std::string difference = compare_(pair);
  if (difference.empty()) return "";
  return pair.random.claims[pair.claim].kind + ": the page says " + std::string(name(pair.says)) + ", " + difference;
}

void Comparison::report(const meaning::File& random, const meaning::Values& bicycle, std::size_t claim,
                        const std::string& difference) {
  if (differences_[difference]++ > 0) return;  // one of each sort is enough to read
  const auto same = [&](const meaning::File& file, std::size_t index) {
    return difference == different_again(file, bicycle, index);
  };
  const auto [file, index] = meaning::shrunk(random, claim, same);
  FAIL_CHECK(file.claims[index].id << ", " << difference << "\nbicycle: " << describe(bicycle) << "\n" << text(file));
}

std::string Comparison::different_again(const meaning::File& random, const meaning::Values& bicycle,
                                        std::size_t claim) const {
  try {
    const ClaimsFile file = read(random);
    const auto world = meaning::World::make(random.setting, bicycle);
    if (!world) return "";
    const Says says = meaning::SecondJudge(random, *world).judge(claim);
    return different({random, file, *world, bicycle, claim, says});
  } catch (const meaning::OutOfReach&) {
    return "";
  } catch (const InputError&) {
    return "";
  }
}

std::string judged_otherwise(const Pair& pair) {
  const CompiledClaims compiled(pair.file);
  const auto sample = SolvedSample::make(compiled.settings[0], in_order(pair.random.setting, pair.bicycle));
  if (!sample) return "the product has no such bicycle";
  const Says product = in_words_of_the_page(judge(pair.file, compiled, pair.claim, Reading::printed, *sample).outcome);
  return product == pair.says ? "" : "the product " + std::string(name(product));
}

std::string stated_otherwise(const Pair& pair, meaning::Dice& dice, Stated& stated) {
  const Claim& claim = pair.file.claims[pair.claim];
  const meaning::StatementJudge judge(pair.random, pair.world, pair.claim, dice);
  const bool exists = claim.kind().name() == "exists";
  const auto refutations = claim_refutation(pair.file, claim, Reading::printed);
  const auto statements = claim_statements(pair.file, claim, Reading::printed);
  stated.claims[std::string(claim.kind().name())] += statements.empty() ? 0 : 1;
  stated.refutations[std::string(claim.kind().name())] += refutations.empty() ? 0 : 1;
  for (const auto& texts : {refutations, statements}) {
    if (const std::string difference = unreadable(texts); !difference.empty()) return difference;
  }
  const auto is_true = [&](const NamedStatement& statement) { return judge.is_true(statement.text); };
  const bool refuted = !refutations.empty() && std::all_of(refutations.begin(), refutations.end(), is_true);
  if (refuted && pair.says != (exists ? Says::nothing : Says::wrong)) return "its refutation is true";
  for (const NamedStatement& statement : statements) {
    if (statement.refutes && pair.says != Says::wrong && !is_true(statement)) {
      return "a statement that refutes it is false:" + statement.name.substr(claim.id.size());
    }
  }
  if (statements.empty()) return "";
  const auto untrue = std::find_if_not(statements.begin(), statements.end(), is_true);
  const bool fine = pair.says == Says::right || (!exists && pair.says == Says::nothing);
  if (claim.kind().name() == "limit" && fine) return "";  // `from` may be too low
  if (fine == (untrue == statements.end())) return "";
  if (!fine) return "all statements are true";
  return "a statement is false:" + untrue->name.substr(claim.id.size());
}

}  // namespace slipproof::test
