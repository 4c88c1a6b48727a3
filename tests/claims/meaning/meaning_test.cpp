// The product's judge, and the statements that it writes, against the second judge, which was written from
// proofs/MEANING.md alone.
#include <doctest/doctest.h>

#include <algorithm>
#include <functional>
#include <map>

#include "base/input/diagnostic.hpp"
#include "claims/judge/judge.hpp"
#include "claims/meaning/random/random_kinds.hpp"
#include "claims/meaning/random/shrink.hpp"
#include "claims/meaning/second_judge/second_judge.hpp"
#include "claims/meaning/statement_judge.hpp"
#include "claims/paper/claim_kind.hpp"
#include "claims/reading/read_claims_file.hpp"
#include "claims/statements/claim_statements.hpp"
#include "support/how_many.hpp"
#include "support/run_program.hpp"

using namespace slipproof;

namespace {

using meaning::Says;

constexpr std::uint64_t quick = test::quick(1000, 80);

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

/// In the order of the setting's parameters.
std::vector<Rational> in_order(const meaning::Setting& setting, const meaning::Values& bicycle) {
  std::vector<Rational> result;
  for (const auto& parameter : setting.parameters) result.push_back(bicycle.at(parameter.symbol));
  if (setting.angle) result.push_back(bicycle.at("beta"));
  return result;
}

/// With the mechanism in a file beside it.
ClaimsFile read(const meaning::File& file) {
  static const test::TemporaryFolder folder;
  if (!file.setting.mechanics) return parse_claims(file.text(), "random.toml");
  folder.write("mechanism.toml", file.setting.mechanics->text());
  return parse_claims(file.text(), (folder.path() / "random.toml").string());
}

std::string text(const meaning::File& file) {
  return file.text() + (file.setting.mechanics ? "\nwith mechanism.toml:\n" + file.setting.mechanics->text() : "");
}

/// One claim at one bicycle.
struct Pair {
  const meaning::File& random;
  const ClaimsFile& file;
  const meaning::World& world;
  const meaning::Values& bicycle;
  std::size_t claim;
  Says says;
};

/// How the product differs from the second judge; empty if it does not.
using Compare = std::function<std::string(const Pair&)>;

/// Goes through random claims, and counts what is found.
class Comparison {
 public:
  /// Of bicycles, or of random mechanisms.
  Comparison(bool mechanisms, Compare compare) : mechanisms_(mechanisms), compare_(std::move(compare)) {}

  /// How often each kind ended in each way.
  std::map<std::string, std::map<Says, std::uint64_t>> counts;
  std::uint64_t pairs = 0, out_of_reach = 0;

  void run(std::uint64_t wanted, std::uint64_t seed) {
    meaning::RandomClaims random(seed, mechanisms_);
    for (std::size_t i = 0; pairs < wanted; ++i) of(random.next(meaning::kinds[i % meaning::kinds.size()]));
    for (const auto& [difference, count] : differences_) MESSAGE(difference << ": " << count << " times");
    MESSAGE(pairs << " pairs, out of reach " << out_of_reach);
  }

 private:
  void of(const meaning::Case& random) {
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

  std::string different(const Pair& pair) const {
    const std::string difference = compare_(pair);
    if (difference.empty()) return "";
    return pair.random.claims[pair.claim].kind + ": the page says " + std::string(name(pair.says)) + ", " + difference;
  }

  void report(const meaning::File& random, const meaning::Values& bicycle, std::size_t claim,
              const std::string& difference) {
    if (differences_[difference]++ > 0) return;  // one of each sort is enough to read
    const auto same = [&](const meaning::File& file, std::size_t index) {
      return difference == different_again(file, bicycle, index);
    };
    const auto [file, index] = meaning::shrunk(random, claim, same);
    FAIL_CHECK(file.claims[index].id << ", " << difference << "\nbicycle: " << describe(bicycle) << "\n" << text(file));
  }

  /// Empty also where a smaller claim is none.
  std::string different_again(const meaning::File& random, const meaning::Values& bicycle, std::size_t claim) const {
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

  bool mechanisms_;
  Compare compare_;
  std::map<std::string, std::uint64_t> differences_;
};

std::string judged_otherwise(const Pair& pair) {
  const CompiledClaims compiled(pair.file);
  const auto sample = SolvedSample::make(compiled.settings[0], in_order(pair.random.setting, pair.bicycle));
  if (!sample) return "the product has no such bicycle";
  const Says product = in_words_of_the_page(judge(pair.file, compiled, pair.claim, Reading::printed, *sample).outcome);
  return product == pair.says ? "" : "the product " + std::string(name(product));
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

/// How many claims of each kind have statements, and how many have refutations.
struct Stated {
  std::map<std::string, std::uint64_t, std::less<>> claims, refutations;
};

/// The statements of a claim say together that it says nothing or is right; its refutation, that it is wrong.
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

void compare_judgements(bool mechanisms, std::uint64_t seed) {
  Comparison comparison(mechanisms, judged_otherwise);
  comparison.run(test::how_many<std::uint64_t>("SLIPPROOF_MEANING_CLAIMS", mechanisms ? 2 * quick : quick), seed);
  if (comparison.pairs < (mechanisms ? 20'000 : 2'000)) return;  // too few to see every end of every kind
  for (const std::string& kind : meaning::kinds) {
    for (const Says says : {Says::nothing, Says::no_value, Says::right, Says::wrong}) {
      if (kind == "exists" && says == Says::wrong) continue;  // at one bicycle it never is
      CAPTURE(kind);
      CAPTURE(name(says));
      CHECK(comparison.counts[kind][says] * (mechanisms ? 10'000 : 2000) >= comparison.pairs);
    }
  }
}

void compare_statements(bool mechanisms, std::uint64_t seed) {
  meaning::Dice dice(2);
  Stated stated;
  Comparison comparison(mechanisms, [&](const Pair& pair) { return stated_otherwise(pair, dice, stated); });
  comparison.run(test::how_many<std::uint64_t>("SLIPPROOF_MEANING_STATEMENTS", mechanisms ? quick : quick / 2), seed);
  if (comparison.pairs < 1'000) return;  // too few to see every kind
  for (const ClaimKind* known : claim_kinds()) {
    const std::string kind(known->name());
    CAPTURE(kind);
    CHECK(stated.claims[kind] * 500 >= comparison.pairs);
    if (kind != "limit") CHECK(stated.refutations[kind] * 500 >= comparison.pairs);
  }
}

}  // namespace

TEST_CASE("random claims are judged as the page on their meaning says") {
  compare_judgements(false, 1);
}

TEST_CASE("random claims about random mechanisms are judged as the page says") {
  compare_judgements(true, 5);
}

TEST_CASE("statements are true where the page on the meaning of claims says so") {
  compare_statements(false, 3);
}

TEST_CASE("statements about random mechanisms are true where the page says so") {
  compare_statements(true, 7);
}
