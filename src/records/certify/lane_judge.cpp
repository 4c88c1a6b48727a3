#include "records/certify/lane_judge.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

#include "floating/filter/batch.hpp"
#include "floating/filter/lanes.hpp"
#include "floating/filter/vector_kernel.hpp"
#include "records/certify/answer_error.hpp"

namespace slipproof {

namespace {

/// The answers of records side by side.
using LaneAnswerNumbers = std::array<LaneNumbers, answer_count>;

struct BoundErrors {
  template <int width>
  static void run(const ForcedScene<LaneNumbers>& scenes, const LaneAnswerNumbers& answers, ContactMode mode,
                  std::uint32_t present, LaneNumbers& errors) {
    using V = typename LaneTypes<width>::Numbers;
    using N = TrackedLanes<V>;
    for (std::size_t lane = 0; lane < lane_count; lane += width) {
      const auto at = [lane](const LaneNumbers& numbers) { return load<V>(&numbers.of[lane]); };
      const auto s = convert<LaneNumbers, N>(scenes, [&](const LaneNumbers& numbers) { return N::input(at(numbers)); });
      const auto dynamics = reduce<N, N>(s.bicycle, s.road, s.force_kind, s.F, N(1));
      const auto number = [&](Field f) { return at(answers[index(f) - parameter_count]); };
      const V error = largest_error<V>(dynamics, mode, present, number, zero_scales<V>(scenes, at));
      std::memcpy(&errors.of[lane], &error, sizeof error);
    }
  }
};

/// Certainly in the domain, and small enough in sum for the filter, whichever way the sum is rounded: not negative.
/// What stands behind the last record is looked at, too.
struct SurelyInside {
  template <int width>
  static void run(const LaneRecords& r, std::uint32_t present, bool exact, LaneMarks& marks) {
    using V = typename LaneTypes<width>::Numbers;
    constexpr double largest = std::numeric_limits<double>::max();
    for (std::size_t row = 0; row < r.count; row += width) {
      const auto at = [&](Field f) { return load<V>(&r.numbers[index(f)][row]); };
      BitsOf<V> outside{};
      V sum{};
      for (auto rest = present; rest != 0; rest &= rest - 1) {
        const auto f = static_cast<Field>(std::countr_zero(rest));
        const V x = at(f);
        outside |= beyond(x, largest);
        if (lowest_inside(f) > -largest) outside |= bits(V(x - lowest_inside(f)));
        if (index(f) < parameter_count) sum += absolute(x);
      }
      outside |= bits(V(input_limit / 4 - sum));  // b, mu and h0 stand for up to two numbers each
      const auto above = [&](Field f, Field other) {
        if ((present & bit(f)) == 0) return;
        outside |= exact ? ~bits(V(-at(other) - at(f))) : ~(bits(V(V{} - at(f))) & bits(V(V{} - at(other))));
      };
      above(Field::h, Field::R);
      above(Field::b2, Field::b3);
      std::memcpy(&marks[row], &outside, sizeof outside);
    }
  }
};

}  // namespace

bool CertifiedLanes::certified(std::size_t i, double tolerance, RecordJudgement& judgement) const {
  if (modes[i] == no_mode || !(errors[i] <= tolerance)) return false;
  judgement.verdict = RecordVerdict::certified;
  judgement.tier = Tier::filter;
  judgement.modes = static_cast<std::uint16_t>(1U << modes[i]);
  judgement.motions = 1;
  judgement.continuum = judgement.contact_problem = false;
  judgement.max_error = errors[i];
  judgement.rho = 0;
  judgement.mode_names.clear();
  judgement.details.clear();
  judgement.members.clear();
  return true;
}

LaneJudge::LaneJudge(std::uint32_t present, std::uint32_t own, const Record& base) : present_(present) {
  std::uint32_t rounded = 0;
  bool vanishes = false;  // what rounds to 0 may be on either side of it
  for (const auto& [field, value] : base.exact) {
    if ((present & ~own & bit(field)) == 0) continue;
    rounded |= bit(field);
    vanishes |= base[field] == 0;
  }
  exact_ = rounded == 0;
  able_ = !vanishes && !has(Field::M2) && !has(Field::P) && (exact_ || !has(Field::h0));
}

void LaneJudge::inside(const LaneRecords& r, LaneMarks& marks) const {
  VectorKernel<SurelyInside>::run(widest_registers(), r, present_, exact_, marks);
}

/// As rounded_scene() makes each; the last one again where there are no more.
ForcedScene<LaneNumbers> LaneJudge::scenes(const LaneRecords& r, const std::uint16_t* rows, std::size_t count,
                                           ForceKind kind) const {
  const auto of = [&](Field f) {
    const auto& column = r.numbers[index(f)];
    LaneNumbers x;
    for (std::size_t lane = 0; lane < lane_count; ++lane) x.of[lane] = column[rows[std::min(lane, count - 1)]];
    return x;
  };
  const auto minus = [](const LaneNumbers& from, const LaneNumbers& y) {
    LaneNumbers x = from;
    for (std::size_t lane = 0; lane < lane_count; ++lane) x.of[lane] -= y.of[lane];
    return x;
  };
  const auto one = [] {
    LaneNumbers x;
    x.of.fill(1);
    return x;
  };
  const bool ratio = has(Field::mu), equal = has(Field::b);
  const LaneNumbers R = of(Field::R);
  ForcedScene<LaneNumbers> s{{.M = of(Field::M),
                              .R = R,
                              .h = has(Field::h) ? of(Field::h) : minus(of(Field::h0), R),
                              .b2 = of(equal ? Field::b : Field::b2),
                              .b3 = of(equal ? Field::b : Field::b3),
                              .I1 = of(Field::I1),
                              .I2 = of(Field::I2),
                              .I3 = of(Field::I3),
                              .r1 = ratio ? one() : of(Field::r1),
                              .r2 = of(ratio ? Field::mu : Field::r2),
                              .L = of(Field::L),
                              .J = std::nullopt},
                             {of(Field::f), of(Field::g)},
                             kind,
                             of(Field::F)};
  if (has(Field::J)) s.bicycle.J = of(Field::J);
  return s;
}

/// `rows` are of one kind of force.
void LaneJudge::find_modes(const LaneRecords& r, const Rows& rows, std::size_t count, ForceKind kind,
                           CertifiedLanes& found) const {
  std::array<ModeSets, lane_count> sets;
  for (std::size_t first = 0; first < count; first += lane_count) {
    const std::size_t here = std::min<std::size_t>(lane_count, count - first);
    filter_lanes(scenes(r, rows.data() + first, here, kind), sets);
    for (std::size_t lane = 0; lane < here; ++lane) {
      const std::uint16_t row = rows[first + lane];
      const auto consistent = sets[lane].consistent;
      // std::has_single_bit() counts all bits, by a call where that instruction may be missing.
      const bool one = consistent != 0 && (consistent & (consistent - 1)) == 0;
      if (sets[lane].undecided != 0 || !one) continue;
      const auto mode = static_cast<std::uint8_t>(std::countr_zero(consistent));
      if (r.modes[row] == no_mode || r.modes[row] == mode) found.modes[row] = mode;
    }
  }
}

/// `rows` are of one kind of force and of one mode.
void LaneJudge::bound_errors(const LaneRecords& r, const Rows& rows, std::size_t count, ForceKind kind, unsigned mode,
                             CertifiedLanes& found) const {
  LaneAnswerNumbers answers;
  LaneNumbers errors;
  for (std::size_t first = 0; first < count; first += lane_count) {
    const std::size_t here = std::min<std::size_t>(lane_count, count - first);
    const std::uint16_t* const at = rows.data() + first;
    for (std::size_t k = 0; k < answer_count; ++k) {
      const auto& column = r.numbers[parameter_count + k];
      if (!has(static_cast<Field>(parameter_count + k))) continue;
      for (std::size_t lane = 0; lane < lane_count; ++lane) answers[k].of[lane] = column[at[std::min(lane, here - 1)]];
    }
    const auto here_scenes = scenes(r, at, here, kind);
    VectorKernel<BoundErrors>::run(widest_registers(), here_scenes, answers, all_modes()[mode], present_, errors);
    for (std::size_t lane = 0; lane < here; ++lane) found.errors[at[lane]] = errors.of[lane];
  }
}

void LaneJudge::answers(const LaneRecords& r, CertifiedLanes& found) const {
  LaneMarks marks;
  inside(r, marks);
  std::fill_n(found.modes.begin(), r.count, no_mode);
  Rows rows;
  for (const ForceKind kind : {ForceKind::internal, ForceKind::external}) {
    if (std::find(r.kinds.begin(), r.kinds.begin() + r.count, kind) == r.kinds.begin() + r.count) continue;
    const auto select = [&](const auto& wanted) {
      std::size_t count = 0;
      for (std::size_t i = 0; i < r.count; ++i) {  // no branch: which records are wanted is anyone's guess
        rows[count] = static_cast<std::uint16_t>(i);
        count += static_cast<std::size_t>(r.kinds[i] == kind) & static_cast<std::size_t>(wanted(i));
      }
      return count;
    };
    find_modes(r, rows, select([&](std::size_t i) { return marks[i] >= 0; }), kind, found);
    unsigned occur = 0;
    for (std::size_t i = 0; i < r.count; ++i) {
      if (found.modes[i] != no_mode) occur |= 1U << found.modes[i];
    }
    for (; occur != 0; occur &= occur - 1) {
      const auto mode = static_cast<unsigned>(std::countr_zero(occur));
      bound_errors(r, rows, select([&](std::size_t i) { return found.modes[i] == mode; }), kind, mode, found);
    }
  }
}

}  // namespace slipproof
