#include "claims/mutation/mutation.hpp"

#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <memory>
#include <mutex>
#include <numeric>
#include <utility>

#include "base/parallel/failure.hpp"
#include "base/parallel/in_parallel.hpp"
#include "claims/lines/claim_lines.hpp"
#include "claims/mutation/baselines.hpp"
#include "claims/mutation/settle.hpp"
#include "claims/sampling/reach.hpp"

namespace slipproof {

std::string_view name(MutantEnd end) {
  constexpr std::array<std::string_view, 7> names{"refuted",    "no value", "another reach", "says nothing",
                                                  "equivalent", "theorem",  "survivor"};
  return names[static_cast<std::size_t>(end)];
}

std::uint64_t MutationResult::count(MutantEnd end) const {
  return static_cast<std::uint64_t>(
      std::count_if(mutants.begin(), mutants.end(), [&](const MutantResult& m) { return m.end == end; }));
}

namespace {

/// The data of one thread: claims that it may change, and its own samples, which keep computed values.
struct Workshop {
  Workshop(const ClaimsFile& file, const CompiledClaims& claims, LemmaBook& quick_proofs, LemmaBook& thorough_proofs)
      : compiled(claims),
        samples(file.settings.size()),
        quick(file, claims, quick_proofs),
        thorough(file, claims, thorough_proofs) {}
  CompiledClaims compiled;
  std::vector<Samples> samples;
  Settler quick, thorough;
};

/// A force that is in one of two sets and not in the other.
std::optional<Rational> some_force(const std::vector<ForceInterval>& x, const std::vector<ForceInterval>& y) {
  for (const auto& [a, b] : {std::pair(&x, &y), std::pair(&y, &x)}) {
    std::vector<ForceInterval> rest = *a;
    for (const ForceInterval& part : *b) rest = difference(rest, part);
    if (!rest.empty()) return rest.front().sample();
  }
  return std::nullopt;
}

bool is_failure(Outcome outcome) {
  return outcome == Outcome::refuted || outcome == Outcome::undecided;
}

/// Claims whose equations have to be solved take longest.
bool is_costly(const Claim& claim) {
  return claim.kind().is_linear();
}

class MutationRun {
 public:
  MutationRun(const ClaimsFile& file, const MutationOptions& options)
      : file_(as_read(file, Reading::repaired)),
        options_(options),
        compiled_(file_),
        baselines_(file_, compiled_, options_) {}

  MutationResult result() {
    MutationResult result;
    on_threads(options_.threads, [&] { judge_all(result); });
    result.samples = options_.samples;
    result.more_samples = options_.more_samples;
    result.lines = options_.lines;
    result.seed = options_.seed;
    result.file = std::move(file_);
    return result;
  }

 private:
  void judge_all(MutationResult& result) {
    std::vector<std::size_t> every_claim(file_.claims.size());
    std::iota(every_claim.begin(), every_claim.end(), std::size_t{0});
    for (std::size_t s = 0; s < file_.settings.size(); ++s) baselines_.solve(s, options_.samples, every_claim);
    collect(result);
    std::vector<MutantResult>& all = result.mutants;
    // One thread judges the mutants of a formula one after another: what refuted one is tried first on the next.
    constexpr std::size_t at_most = 64;
    std::vector<std::size_t> groups;
    for (std::size_t i = 0; i < all.size(); ++i) {
      // Two settings may share an inherited definition.
      const auto same = [&](const ClaimsMutant& x, const ClaimsMutant& y) {
        return x.where == y.where && x.setting == y.setting;
      };
      if (i == 0 || !same(all[i].mutant, all[i - 1].mutant) || i - groups.back() == at_most) groups.push_back(i);
    }
    groups.push_back(all.size());
    std::atomic<std::uint64_t> done = 0;
    in_parallel(0, groups.size() - 1, [&](std::size_t g) {
      judge_group(workshop(), all.data() + groups[g], all.data() + groups[g + 1]);
      done += groups[g + 1] - groups[g];
      if (!options_.progress) return;
      const std::scoped_lock lock(mutex_);
      options_.progress(done, all.size());
    });
    judge_again(all);
  }

  void collect(MutationResult& result) {
    std::vector<std::size_t>& left_out = result.not_mutated;
    for (std::size_t c = 0; c < file_.claims.size(); ++c) {
      const auto& here = baselines_.of(c);
      const auto has = [&](Outcome outcome) {
        return std::any_of(here.begin(), here.end(), [&](const Baseline& b) { return b.outcome == outcome; });
      };
      if (has(Outcome::refuted) || has(Outcome::undecided) || !has(Outcome::holds)) left_out.push_back(c);
    }
    Settler settler(file_, compiled_, quick_);
    for (std::size_t c = 0; c < file_.claims.size(); ++c) {
      bool vacuous = false;
      const bool failed = !failure_of([&] { vacuous = settler.is_vacuous(c); }).empty();
      if (vacuous && !failed) result.vacuous.push_back(c);
    }
    std::vector<ClaimsMutant> all = mutants(file_);
    std::erase_if(all, [&](const ClaimsMutant& m) {
      return m.part && std::binary_search(left_out.begin(), left_out.end(), m.index);
    });
    for (std::size_t i = 0; i < all.size(); i += options_.every) {
      std::stable_partition(all[i].claims.begin(), all[i].claims.end(),
                            [&](std::size_t c) { return !is_costly(file_.claims[c]); });
      result.mutants.emplace_back().mutant = std::move(all[i]);
    }
  }

  /// Judges the survivors again: at many more samples, along lines, and with more time for proofs.
  void judge_again(std::vector<MutantResult>& all) {
    std::vector<MutantResult*> rest;
    std::vector<std::vector<std::size_t>> claims(file_.settings.size());
    for (MutantResult& m : all) {
      if (m.end != MutantEnd::survivor) continue;
      rest.push_back(&m);
      std::vector<std::size_t>& needed = claims[m.mutant.setting];
      needed.insert(needed.end(), m.mutant.claims.begin(), m.mutant.claims.end());
    }
    for (std::size_t s = 0; s < file_.settings.size(); ++s) {
      std::sort(claims[s].begin(), claims[s].end());
      claims[s].erase(std::unique(claims[s].begin(), claims[s].end()), claims[s].end());
      if (!claims[s].empty()) baselines_.solve(s, options_.samples + options_.more_samples, claims[s]);
    }
    in_parallel(0, rest.size(), [&](std::size_t i) {
      MutantResult& m = *rest[i];
      Workshop& shop = workshop();
      std::vector<std::size_t> order = baselines_.samples_from(m.mutant.setting, options_.samples);
      with_change(shop, m, [&] {
        if (!caught(shop, m, order) && !caught_on_lines(shop, m)) settle(m, shop.thorough, shop.compiled);
      });
    });
  }

  /// Does the work with the mutant in place of the original. If it fails, the mutant survives, with the reason.
  template <class Work>
  void with_change(Workshop& shop, MutantResult& m, const Work& work) const {
    m.mutant.put(m.mutant.mutant.expression, shop.compiled);
    const std::string failure = failure_of(work);
    if (!failure.empty()) m.end = MutantEnd::survivor, m.argument = "judging it failed: " + failure;
    m.mutant.put(m.mutant.original(file_), shop.compiled);
  }

  Workshop& workshop() {
    std::unique_ptr<Workshop>& shop = workshops_.local();
    if (!shop) shop = std::make_unique<Workshop>(file_, compiled_, quick_, thorough_);
    return *shop;
  }

  void judge_group(Workshop& shop, MutantResult* first, MutantResult* last) {
    std::vector<std::size_t> order = baselines_.samples_from(first->mutant.setting, 0);
    for (MutantResult* m = first; m != last; ++m) {
      with_change(shop, *m, [&] {
        if (!caught(shop, *m, order)) settle(*m, shop.quick, shop.compiled);
      });
    }
  }

  /// The sample of a workshop whose claims are changed.
  SolvedSample& changed(Workshop& shop, const ClaimsMutant& m, std::size_t i) const {
    const Samples& all = baselines_.samples(m.setting);
    Samples& own = shop.samples[m.setting];
    if (own.size() < all.size()) own.resize(all.size());
    // A sample evaluates definitions once, so a changed definition needs a new sample.
    if (!m.part || !own[i]) {
      own[i] = all[i]->under(shop.compiled.settings[m.setting]);
    }
    return *own[i];
  }

  bool caught(Workshop& shop, MutantResult& m, std::vector<std::size_t>& order) const {
    const bool found = fails(shop, m, order) || reaches_elsewhere(shop, m, order);
    if (!m.mutant.part) {  // the samples keep values of the changed definition
      for (auto& sample : shop.samples[m.mutant.setting]) sample.reset();
    }
    return found;
  }

  /// Whether the changed claim fails at a sample; if so, the mutant records how.
  bool fails(const Workshop& shop, MutantResult& m, std::size_t c, SolvedSample& sample) const {
    const Judgement j = judge(file_, shop.compiled, c, Reading::printed, sample);
    if (!is_failure(j.outcome)) return false;
    m.end = j.outcome == Outcome::refuted ? MutantEnd::refuted : MutantEnd::no_value;
    m.claim = c;
    m.reason = j.reason;
    m.sample = sample.values();
    if (j.witnesses && !j.witnesses->empty()) m.force = j.witnesses->sample();
    return true;
  }

  /// Whether the changed claim says something about other forces at a sample than before; if so, the mutant records
  /// one.
  bool reaches_elsewhere(const Workshop& shop, MutantResult& m, std::size_t c, SolvedSample& sample,
                         const std::vector<ForceInterval>& before) const {
    const auto force = some_force(reach(file_, shop.compiled, c, sample), before);
    if (!force) return false;
    m.end = MutantEnd::reach;
    m.claim = c;
    m.sample = sample.values();
    m.force = force;
    return true;
  }

  bool fails(Workshop& shop, MutantResult& m, std::vector<std::size_t>& order) const {
    for (auto i = order.begin(); i != order.end(); ++i) {
      SolvedSample& sample = changed(shop, m.mutant, *i);
      for (const std::size_t c : m.mutant.claims) {
        if (file_.claims[c].setting != m.mutant.setting) continue;
        if (is_failure(baselines_.of(c)[*i].outcome)) continue;
        if (!fails(shop, m, c, sample)) continue;
        std::rotate(order.begin(), i, i + 1);
        return true;
      }
    }
    return false;
  }

  bool reaches_elsewhere(Workshop& shop, MutantResult& m, const std::vector<std::size_t>& order) const {
    for (const std::size_t i : order) {
      SolvedSample& sample = changed(shop, m.mutant, i);
      for (const std::size_t c : m.mutant.claims) {
        if (file_.claims[c].setting != m.mutant.setting) continue;
        if (reaches_elsewhere(shop, m, c, sample, baselines_.of(c)[i].reach)) return true;
      }
    }
    return false;
  }

  /// Looks along lines through bicycles that the claim says something about; such lines also cross thin cells.
  bool caught_on_lines(Workshop& shop, MutantResult& m) const {
    return std::any_of(m.mutant.claims.begin(), m.mutant.claims.end(), [&](std::size_t c) {
      return file_.claims[c].setting == m.mutant.setting && !is_costly(file_.claims[c]) && caught_on_lines(shop, m, c);
    });
  }

  bool caught_on_lines(Workshop& shop, MutantResult& m, std::size_t c) const {
    const auto bases = baselines_.speaks_at(c);
    const auto lines = claim_lines(file_, shop.compiled, c, Reading::printed);
    if (bases.empty() || !lines) return false;
    // A line that varies other parameters would leave the surface at once.
    const std::vector<bool> along = on_surface(file_, shop.compiled, c, Reading::printed, lines->matters);
    const bool some = std::find(along.begin(), along.end(), true) != along.end();
    bool found = false;
    for (std::uint64_t k = 0; k < options_.lines && !found; ++k) {
      const Line line = line_number(k, options_.seed + c, bases, some && k % 4 < 2 ? along : lines->matters);
      visit_line(line, compiled_.settings[m.mutant.setting], lines->parts, [&](SolvedSample& sample) {
        found = caught(shop, m, c, sample);
        return !found;
      });
    }
    return found;
  }

  /// Whether a sample of the unchanged claims catches the mutant.
  bool caught(Workshop& shop, MutantResult& m, std::size_t c, SolvedSample& sample) const {
    if (is_failure(judge(file_, compiled_, c, Reading::printed, sample).outcome)) return false;
    const auto changed = sample.under(shop.compiled.settings[m.mutant.setting]);
    return fails(shop, m, c, *changed) || reaches_elsewhere(shop, m, c, *changed, reach(file_, compiled_, c, sample));
  }

  static void settle(MutantResult& m, Settler& settler, const CompiledClaims& changed) {
    auto settlement = settler.settle(m.mutant, changed);
    if (!settlement) return;
    constexpr std::array ends{MutantEnd::equivalent, MutantEnd::theorem, MutantEnd::vacuous};
    m.end = ends[static_cast<std::size_t>(settlement->kind)];
    m.claim = settlement->claim;
    m.argument = std::move(settlement->argument);
    m.lemmas = std::move(settlement->lemmas);
  }

  ClaimsFile file_;
  const MutationOptions& options_;
  const CompiledClaims compiled_;
  Baselines baselines_;
  LemmaBook quick_{
      {.split_depth = 1, .slack_attempts = 100, .products = 0, .quick_samples = 0, .samples = 0, .steps = 2'000'000}},
      thorough_{{.split_depth = 2, .products = 0, .quick_samples = 0, .samples = 0, .steps = 40'000'000}};
  tbb::enumerable_thread_specific<std::unique_ptr<Workshop>> workshops_;
  std::mutex mutex_;
};

}  // namespace

MutationResult judge_mutants(const ClaimsFile& file, const MutationOptions& options) {
  return MutationRun(file, options).result();
}

}  // namespace slipproof
