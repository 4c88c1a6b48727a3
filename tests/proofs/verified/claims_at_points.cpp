// Judges claims at single forces, for a comparison with the semantics run in Coq. For each claims file, in each reading
// and with mutants, writes NAME.canonical, NAME.points (CLAIM SYMBOL=VALUE ...) and NAME.expected (KIND VERDICT).
#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <random>
#include <set>

#include "claims/canonical/canonical_claims.hpp"
#include "claims/judge/judge.hpp"
#include "claims/mutation/claims_mutants.hpp"
#include "claims/reading/read_claims_file.hpp"
#include "claims/sampling/sampler.hpp"
#include "mechanics/family/solved_sample.hpp"

using namespace slipproof;

namespace {

using Random = std::mt19937_64;
std::size_t below(Random& random, std::size_t n) {
  return static_cast<std::size_t>(random() % n);
}

constexpr const char* one_force = "the_one_force";

/// The settings with a parameter to which the force is equal.
ClaimsFile at_one_force(ClaimsFile file) {
  for (Setting& s : file.settings) {
    s.parameters.push_back({one_force, make_truth(true), "", 0});
    if (s.force.symbol.empty()) continue;
    s.force.domain = make(
        Operation::logical_and,
        {s.force.domain, make_comparison({make_symbol(s.force.symbol), make_symbol(one_force)}, {Relation::equal})});
  }
  return file;
}

/// Changes each claim, or each setting's definitions, in one place.
ClaimsFile mutated(const ClaimsFile& file, Random& random) {
  std::map<std::pair<bool, std::size_t>, std::vector<const ClaimsMutant*>> places;
  const std::vector<ClaimsMutant> all = mutants(file);
  for (const ClaimsMutant& m : all) {
    if (!m.is_linear()) places[{m.part.has_value(), m.part ? m.index : m.setting}].push_back(&m);
  }
  const bool definitions = below(random, 4) == 0;
  ClaimsFile changed = file;
  for (const auto& [place, here] : places) {
    if (place.first != definitions) changed = here[below(random, here.size())]->apply(changed);
  }
  return changed;
}

std::string assignments(const Setting& s, const std::vector<Rational>& values, const Rational& force) {
  std::string line;
  for (std::size_t i = 0; i < s.parameters.size(); ++i) {
    if (!s.parameters[i].angle) line += fmt::format(" {}={}", s.parameters[i].symbol, values[i].str());
  }
  for (const FreeAngle& a : s.angles) {
    const Rational& t = values[a.parameter];
    const Rational d = Rational(1) + t * t;
    line += fmt::format(" {}={} {}={}", a.cosine, Rational((Rational(1) - t * t) / d).str(), a.sine,
                        Rational(Rational(2) * t / d).str());
  }
  if (!s.force.symbol.empty()) line += fmt::format(" {}={}", s.force.symbol, force.str());
  return line;
}

void add_ends(const ForceInterval& cell, std::vector<Rational>& forces) {
  if (cell.empty()) return;
  if (cell.lower()) forces.push_back(*cell.lower());
  if (cell.upper()) forces.push_back(*cell.upper());
  forces.push_back(cell.sample());
}

class Run {
 public:
  Run(const ClaimsFile& file, const std::string& name, std::size_t samples, std::uint64_t seed)
      : file_(file),
        at_force_(at_one_force(file)),
        compiled_(file),
        one_(at_force_),
        random_(seed),
        points_(name + ".points"),
        expected_(name + ".expected") {
    const std::string canonical = canonical_claims(file);
    std::ofstream(name + ".canonical") << canonical;
    for (std::size_t i = 0; i < file.claims.size(); ++i) {
      if (known.contains(file.claims[i].kind().name())) by_setting_[file.claims[i].setting].push_back(i);
    }
    for (const auto& [setting, claims] : by_setting_) {
      const Sampler sampler(compiled_.settings[setting], seed);
      for (std::size_t k = 0; k < samples; ++k) {
        std::vector<Rational> values = sampler.at(k);
        if (!values.empty()) judge_at(setting, claims, std::move(values));
      }
    }
  }

 private:
  static inline const std::set<std::string, std::less<>> known = {
      "interval", "impossible", "formula", "motions", "exists", "equivalence", "cover", "force-cover", "unique"};

  void write(std::size_t claim, const std::string& where, std::string_view verdict) {
    points_ << file_.claims[claim].id << where << '\n';
    expected_ << file_.claims[claim].kind().name() << ' ' << verdict << '\n';
  }

  void judge_at(std::size_t setting, const std::vector<std::size_t>& claims, std::vector<Rational> values) {
    const Setting& s = file_.settings[setting];
    if (below(random_, 20) == 0) {
      Rational& moved = values[below(random_, values.size())];
      moved = below(random_, 2) == 0 ? Rational(0) : Rational(0) - moved;
    }
    std::vector<Rational> forces{Rational(static_cast<long>(below(random_, 9)) - 4) /
                                 Rational(static_cast<long>(1 + below(random_, 3)))};
    const auto sample = in_domain(compiled_.settings[setting], values)
                            ? SolvedSample::make(compiled_.settings[setting], values)
                            : nullptr;
    if (!s.force.symbol.empty() && sample && sample->force_domain()) {
      add_ends(*sample->force_domain(), forces);
      for (const LoadCell& cell : sample->cells()) add_ends(cell.loads, forces);
      for (const std::size_t claim : claims) {
        for (const Program* p : {&compiled_.claims[claim].printed.forces, &compiled_.claims[claim].printed.holds}) {
          try {
            for (const TruthCell& cell : sample->over_forces(*p)) add_ends(cell.forces, forces);
          } catch (const std::exception&) {
          }
        }
      }
    }
    for (int i = 0; i < 2; ++i) {
      const Rational force = forces[below(random_, forces.size())];
      const std::string where = assignments(s, values, force);
      std::vector<Rational> with_force = values;
      with_force.push_back(force);
      const auto here = sample ? SolvedSample::make(one_.settings[setting], with_force) : nullptr;
      // A cover is judged also where the force is not in the domain.
      const bool outside = here && here->force_domain() && here->force_domain()->empty();
      const auto has_place = [&](std::size_t claim) {
        return here && (!outside || file_.claims[claim].kind().name() == "cover");
      };
      const std::size_t one = claims[below(random_, claims.size())];
      if (!has_place(one)) write(one, where, "no-point");
      for (const std::size_t claim : claims) {
        if (has_place(claim)) write(claim, where, verdict(claim, *here));
      }
    }
  }

  std::string_view verdict(std::size_t claim, SolvedSample& sample) {
    const Judgement j = judge(at_force_, one_, claim, Reading::printed, sample);
    switch (j.outcome) {
      case Outcome::outside:
        return "nothing";
      case Outcome::holds:
        return "right";
      case Outcome::refuted:
        return "wrong";
      default:
        return j.reason == Reason::unsure ? "unsure" : "no-value";
    }
  }

  const ClaimsFile& file_;
  const ClaimsFile at_force_;
  const CompiledClaims compiled_, one_;
  Random random_;
  std::ofstream points_, expected_;
  std::map<std::size_t, std::vector<std::size_t>> by_setting_;
};

}  // namespace

/// claims_at_points OUTPUT SEED SAMPLES ROUNDS CLAIMS...: SAMPLES bicycles for each setting, and a quarter of them for
/// each of ROUNDS mutants.
int main(int argc, char** argv) {
  const std::filesystem::path output = argv[1];
  const std::uint64_t seed = std::stoull(argv[2]);
  const std::size_t samples = std::stoull(argv[3]), rounds = std::stoull(argv[4]);
  for (int i = 5; i < argc; ++i) {
    const std::filesystem::path path = argv[i];
    const std::string paper = path.parent_path().filename().string();
    const ClaimsFile file = read_claims(path);
    for (const Reading reading : {Reading::printed, Reading::repaired}) {
      const ClaimsFile read = as_read(file, reading);
      const std::string name =
          (output / fmt::format("{}.{}", paper, reading == Reading::printed ? "printed" : "repaired")).string();
      const std::uint64_t own = 1000 * seed + (reading == Reading::printed ? 0 : 500);
      Run(read, name, samples, own);
      std::seed_seq of_paper(paper.begin(), paper.end());  // its mutants do not depend on the other papers
      std::array<std::uint32_t, 1> mixed{};
      of_paper.generate(mixed.begin(), mixed.end());
      Random random(own + mixed[0]);
      for (std::size_t round = 0; round < rounds; ++round) {
        Run(mutated(read, random), fmt::format("{}.mutated{}", name, round), samples / 4 + 1, own + round + 1);
      }
    }
  }
}
