// Random claims whose force's domain depends on parameters, judged at single forces by the second judge of
// tests/claims/meaning, for a comparison with the semantics run in Coq. For each case writes NAME.canonical,
// NAME.points (CLAIM SYMBOL=VALUE ...) and NAME.expected (KIND VERDICT).
#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <set>

#include "claims/canonical/canonical_claims.hpp"
#include "claims/meaning/random/random_claims.hpp"
#include "claims/meaning/second_judge/second_judge.hpp"
#include "claims/reading/read_claims_file.hpp"

using namespace slipproof;
using meaning::Says;
using meaning::World;

namespace {

/// Those that are about one force, and `cover`, which is about none.
const std::vector<std::string> known = {"interval",    "impossible",  "formula", "motions", "unique",
                                        "force-cover", "equivalence", "exists",  "cover"};

class Writer {
 public:
  explicit Writer(std::filesystem::path folder) : folder_(std::move(folder)) {}

  std::uint64_t pairs = 0;

  void write(const meaning::Case& random, meaning::Dice& dice) {
    const std::string name = (folder_ / std::to_string(cases_++)).string();
    std::ofstream(name + ".canonical") << canonical_claims(read(random.file));
    std::ofstream points(name + ".points"), expected(name + ".expected");
    for (const meaning::Values& bicycle : random.bicycles) {
      for (std::size_t i = 0; i < random.file.claims.size(); ++i) {
        const std::string& kind = random.file.claims[i].kind;
        if (std::find(known.begin(), known.end(), kind) == known.end()) continue;
        try {
          const Rational force = some_force(random.file, i, bicycle, dice);
          const std::string verdict = judged(random.file, i, bicycle, force);
          points << random.file.claims[i].id << assignments(random.file.setting, bicycle, force) << '\n';
          expected << kind << ' ' << verdict << '\n';
          ++pairs;
        } catch (const meaning::OutOfReach&) {
        }
      }
    }
  }

 private:
  ClaimsFile read(const meaning::File& file) const {
    if (file.setting.mechanics) std::ofstream(folder_ / "mechanism.toml") << file.setting.mechanics->text();
    return parse_claims(file.text(), (folder_ / "random.toml").string());
  }

  /// Where something changes, or between, in the domain or not.
  static Rational some_force(const meaning::File& file, std::size_t claim, const meaning::Values& bicycle,
                             meaning::Dice& dice) {
    const auto world = World::make(file.setting, bicycle);
    if (!world || dice.one_in(6)) return dice.of<Rational>({0, 1, Rational(-3, 2), 7});
    return dice.of(meaning::SecondJudge(file, *world).places(claim));
  }

  static std::string judged(const meaning::File& file, std::size_t claim, const meaning::Values& bicycle,
                            const Rational& force) {
    const auto world = World::make(file.setting, bicycle);
    if (!world) return "no-point";
    if (file.claims[claim].kind == "cover") return in_words(meaning::SecondJudge(file, *world).judge(claim));
    if (!meaning::is_true(meaning::truth_of(world->force_domain(), world->at(force)))) return "no-point";
    meaning::File there = file;
    const std::string& X = file.setting.force;
    if (!X.empty()) {
      const meaning::Tree here = meaning::compare(meaning::symbol(X), "=", meaning::number(force));
      there.setting.force_domain = meaning::make(meaning::Op::conjunction, {file.setting.force_domain, here});
    }
    const auto at_force = World::make(there.setting, bicycle);
    return in_words(meaning::SecondJudge(there, *at_force).judge(claim));
  }

  static std::string in_words(Says says) { return says == Says::no_value ? "no-value" : std::string(name(says)); }

  static std::string assignments(const meaning::Setting& setting, const meaning::Values& bicycle,
                                 const Rational& force) {
    std::string line;
    for (const meaning::Parameter& parameter : setting.parameters) {
      line += fmt::format(" {}={}", parameter.symbol, bicycle.at(parameter.symbol).str());
    }
    if (setting.angle) {
      const Rational t = bicycle.at("beta"), below = 1 + t * t;
      line += fmt::format(" cb={} sb={}", Rational((1 - t * t) / below).str(), Rational(2 * t / below).str());
    }
    if (!setting.force.empty()) line += fmt::format(" {}={}", setting.force, force.str());
    return line;
  }

  std::filesystem::path folder_;
  std::size_t cases_ = 0;
};

}  // namespace

/// random_at_points OUTPUT SEED PAIRS
int main(int, char** argv) {
  const std::uint64_t seed = std::stoull(argv[2]), pairs = std::stoull(argv[3]);
  using Domain = meaning::RandomClaims::Domain;
  meaning::RandomClaims bicycles(seed, false, Domain::of_parameters), mechanisms(seed + 1, true, Domain::of_parameters);
  meaning::Dice dice(seed);
  Writer writer(argv[1]);
  for (std::size_t i = 0; writer.pairs < pairs; ++i) {
    writer.write((i % 3 == 0 ? bicycles : mechanisms).next(known[i % known.size()]), dice);
  }
}
