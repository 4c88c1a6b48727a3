#include "mechanics/search/search.hpp"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

#include "base/crew/crew.hpp"
#include "base/input/diagnostic.hpp"
#include "base/parallel/in_parallel.hpp"
#include "mechanics/search/search_bytes.hpp"

namespace slipproof {

std::string_view name(SearchFor what) {
  return search_words[static_cast<std::size_t>(what)];
}

std::optional<SearchFor> parse_search_for(std::string_view text) {
  const auto found = std::ranges::find(search_words, text);
  if (found == search_words.end()) return std::nullopt;
  return static_cast<SearchFor>(found - search_words.begin());
}

std::uint64_t default_samples(const Mechanism& mechanism) {
  if (mechanism.dimension == 3) return 30;
  const double modes = mode_count(element_kinds(mechanism));
  return static_cast<std::uint64_t>(std::clamp(500'000 / (modes * modes), 30.0, 2'000.0));
}

namespace {

enum class SearchQuestion : std::uint64_t { sample, simplify };

bool is(const FoundMotions& found, SearchFor what) {
  switch (what) {
    case SearchFor::none:
      return found.count == MotionCount::none;
    case SearchFor::several:
      return found.count == MotionCount::several;
    case SearchFor::continuum:
      return found.count == MotionCount::continuum;
    case SearchFor::gain:
      break;
  }
  return found.energy == EnergyBalance::gained;
}

}  // namespace

class MotionSearch::Run {
 public:
  Run(const Mechanism& mechanism, const SearchOptions& options)
      : options_(options),
        finder_(mechanism, !options.hysteresis, options.in_space),
        points_(mechanism, finder_.maker(), options.seed),
        samples_(options.samples.value_or(default_samples(mechanism))) {}

  SearchResult result(Crew* crew) {
    on_threads(options_.threads, [&] {
      sample(crew);
      conclude(crew);
    });
    return std::move(result_);
  }

  std::string answer(std::string_view request) const {
    ByteReader bytes(request);
    if (static_cast<SearchQuestion>(bytes.number()) == SearchQuestion::sample) return shown_bytes(show(bytes.number()));
    const std::uint64_t budget = bytes.number();
    return cell_bytes(simplified(read_cell(bytes.rest()), budget));
  }

 private:
  /// The simplest of some places, the first of equals.
  struct SimplestPlace {
    std::optional<SearchPlace> place;
    Complexity its_complexity;

    void keep(const SearchPlace& other) {
      Complexity c = complexity(other);
      if (place && !(c < its_complexity)) return;
      place = other;
      its_complexity = std::move(c);
    }
  };

  struct Kept {
    std::uint64_t samples = 0;
    SimplestPlace simplest, realisable;
  };

  Service service() const {
    return [this](std::string_view request) { return answer(request); };
  }

  /// The number of samples drawn at once, and counted in their order. Many ranks wait for each other after each batch,
  /// so larger batches are better, except for a search that may end with any sample.
  std::uint64_t batch(const Crew* crew) const { return crew != nullptr && !options_.wanted ? 4096 : 64; }

  void sample(Crew* crew) {
    for (std::uint64_t first = 0; first < samples_ && !ended_; first += batch(crew)) {
      std::vector<Shown> shown(std::min(batch(crew), samples_ - first));
      const auto request = [&](std::uint64_t i) {
        return ByteWriter().number(static_cast<std::uint64_t>(SearchQuestion::sample)).number(first + i).take();
      };
      share(crew, service(), shown.size(), request,
            [&](std::uint64_t i, const std::string& result) { shown[i] = read_shown(result); });
      for (std::size_t i = 0; i < shown.size() && !ended_; ++i) count(shown[i]);
      if (options_.progress) options_.progress(ended_ ? samples_ : first + shown.size(), samples_);
    }
  }

  Shown show(std::uint64_t i) const {
    Shown shown;
    const auto values = points_.at(i);
    if (!values) return shown;
    try {
      const auto all = finder_.at(*values);
      if (all.empty()) return shown;
      shown.end = Shown::End::found;
      shown.realisable = points_.realisable().contains(*values);
      for (const FoundOverLoads& one : all) add(one.found, all, *values, shown);
    } catch (const NoValue&) {
      shown.end = Shown::End::no_value;
    }
    return shown;
  }

  void add(const FoundMotions& found, const std::vector<FoundOverLoads>& all, const MechanismValues& values,
           Shown& shown) const {
    shown.counts.insert(found.count);
    shown.energy = std::max(shown.energy, found.energy);
    if (found.count == MotionCount::hysteresis) return;
    shown.one_everywhere = shown.one_everywhere && found.count == MotionCount::one;
    if (found.count == MotionCount::undecided && found.energy != EnergyBalance::gained) return;
    if (options_.wanted && (!is(found, *options_.wanted) || !shown.places.empty())) return;
    const auto same = [&](const auto& place) { return place.first == found; };
    if (std::any_of(shown.places.begin(), shown.places.end(), same)) return;
    shown.places.emplace_back(found, *finder_.place_of(found, all, values));
  }

  void count(const Shown& shown) {
    ++result_.tried;
    if (shown.end == Shown::End::no_value) ++result_.without_value;
    if (shown.end != Shown::End::found) return;
    ++result_.samples;
    if (shown.one_everywhere) ++result_.one_everywhere;
    ++result_.energies[static_cast<std::size_t>(shown.energy)];
    for (const MotionCount what : shown.counts) ++result_.with[static_cast<std::size_t>(what)];
    for (const auto& [found, place] : shown.places) {
      Kept& kept = kept_[found];
      ++kept.samples;
      kept.simplest.keep(place);
      if (shown.realisable) kept.realisable.keep(place);
    }
    ended_ = options_.wanted && !shown.places.empty();
  }

  /// Finds simpler places for the cells, in the order in which they are reported.
  void conclude(Crew* crew) {
    const auto rank = [](MotionCount count) {
      constexpr std::array<int, motion_counts> ranks{5, 0, 3, 1, 2, 4, 6};
      return ranks[static_cast<std::size_t>(count)];
    };
    for (auto& [found, kept] : kept_) {
      result_.cells.push_back({found, kept.samples, *kept.simplest.place, kept.realisable.place});
    }
    std::stable_sort(result_.cells.begin(), result_.cells.end(), [&](const SearchCell& x, const SearchCell& y) {
      return std::tuple(rank(x.found.count), y.found.energy, y.samples) <
             std::tuple(rank(y.found.count), x.found.energy, x.samples);
    });
    const std::vector<SearchCell> found = result_.cells;
    const auto request = [&](std::uint64_t i) {
      const auto question = static_cast<std::uint64_t>(SearchQuestion::simplify);
      return ByteWriter().number(question).number(tries(found[i].found.count)).take() + cell_bytes(found[i]);
    };
    share(crew, service(), found.size(), request,
          [&](std::uint64_t i, const std::string& result) { result_.cells[i] = read_cell(result); });
  }

  /// So often something simpler is tried for a cell: for all together about as often as there are samples, and for
  /// those where it is undecided what happens more than for the others.
  std::size_t tries(MotionCount count) const {
    const auto decided = [](MotionCount c) { return c == MotionCount::one || c == MotionCount::none_modelled; };
    const auto alike = std::ranges::count_if(
        result_.cells, [&](const SearchCell& cell) { return decided(cell.found.count) == decided(count); });
    const std::size_t share = static_cast<std::size_t>(samples_) / static_cast<std::size_t>(alike);
    const auto least = std::clamp<std::size_t>(static_cast<std::size_t>(samples_) / 100, 2, 15);
    return decided(count) ? std::clamp<std::size_t>(share / 4, 2, 100) : std::clamp<std::size_t>(share, least, 500);
  }

  SearchCell simplified(SearchCell cell, std::size_t budget) const {
    cell.simplest = simpler(std::move(cell.simplest), cell.found, finder_, points_.domain(), budget);
    if (points_.realisable().contains(cell.simplest.values)) {
      cell.realisable = cell.simplest;
    } else if (cell.realisable) {
      cell.realisable = simpler(std::move(*cell.realisable), cell.found, finder_, points_.realisable(), budget);
    }
    return cell;
  }

  const SearchOptions& options_;
  MotionFinder finder_;
  PointSampler points_;
  std::uint64_t samples_;
  bool ended_ = false;
  std::map<FoundMotions, Kept> kept_;
  SearchResult result_;
};

MotionSearch::MotionSearch(const Mechanism& mechanism, const SearchOptions& options) {
  if (options.wanted == SearchFor::gain && !mechanism.impact) {
    throw InputError({{mechanism.file, 0, 0,
                       "found no impact, which alone may gain energy, expected bodies, read with a law of impact"}});
  }
  run_ = std::make_unique<Run>(mechanism, options);
}

MotionSearch::~MotionSearch() = default;

std::string MotionSearch::answer(std::string_view request) const {
  return run_->answer(request);
}

SearchResult MotionSearch::result(Crew* crew) {
  return run_->result(crew);
}

SearchResult search_motions(const Mechanism& mechanism, const SearchOptions& options) {
  return MotionSearch(mechanism, options).result();
}

}  // namespace slipproof
