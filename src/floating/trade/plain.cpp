#include <algorithm>
#include <array>
#include <boost/multiprecision/mpfr.hpp>

#include "base/number/binary64.hpp"
#include "floating/trade/arithmetic.hpp"
#include "floating/trade/tape_run.hpp"

namespace slipproof {

namespace {

constexpr std::size_t most_conditions = 6;  // of a mode with two contacts

__extension__ typedef __float128 Binary128;
template <unsigned digits>
using Mpfr =
    boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<digits>, boost::multiprecision::et_off>;

/// The nearest number of a type with so many bits, except that ties and numbers near a tie may be rounded otherwise. x
/// has the range of binary64.
template <class T>
T rounded(Rational x, int bits) {
  T sum = 0;
  for (int found = 0; found <= bits && !x.is_zero(); found += 52) {
    const double part = nearest_binary64(x);
    sum += static_cast<T>(part);
    x -= to_rational(part);
  }
  return sum;
}

/// Nothing for NaN and infinities.
template <class T>
std::optional<Rational> exactly(T x) {
  if (!(x - x == 0)) return std::nullopt;
  constexpr double large = 0x1p900, small = 0x1p-900;
  Rational sum, unit = 1;
  while (x != 0) {
    for (; x > large || x < -large; x *= static_cast<T>(small)) unit *= to_rational(large);
    for (; x < small && x > -small; x *= static_cast<T>(large)) unit *= to_rational(small);
    const auto part = static_cast<double>(x);
    sum += unit * to_rational(part);
    x -= static_cast<T>(part);
  }
  return sum;
}

/// Numbers of several scenes side by side, in vector registers.
template <class T, std::size_t count>
struct Pack {
  typedef T Vector __attribute__((vector_size(sizeof(T) * count)));
  static T get(const Vector& x, std::size_t lane) { return x[lane]; }
  static void set(Vector& x, std::size_t lane, const T& value) { x[lane] = value; }
};
template <class T>
struct Pack<T, 1> {
  using Vector = T;
  static const T& get(const T& x, std::size_t) { return x; }
  static void set(T& x, std::size_t, const T& value) { x = value; }
};

/// `lanes`: the number of scenes that are computed side by side.
template <class T, std::size_t lanes>
class PlainArithmetic : public Arithmetic {
  using Lane = Pack<T, lanes>;
  using N = typename Lane::Vector;

 public:
  using Arithmetic::Arithmetic;

  void load(const Workload& workload) override {
    mechanism_ = workload.mechanism;
    run_.emplace(mechanism_->code(), [&](const Rational& x) { return N{} + rounded<T>(x, type().bits); });
    groups_.clear();
    for (std::size_t i = 0; i < workload.scenes.size(); ++i) {
      const TradeScene& scene = workload.scenes[i];
      if (i % lanes == 0) groups_.emplace_back(scene.size());
      for (std::size_t k = 0; k < scene.size(); ++k) {
        const T value = rounded<T>(scene[k], type().bits);
        for (std::size_t lane = i % lanes; lane < lanes; ++lane) Lane::set(groups_.back()[k], lane, value);
      }
    }
  }

  std::vector<ModeAt> decide() override {
    std::vector<ModeAt> found(groups_.size() * lanes * mechanism_->modes());
    for (std::size_t group = 0; group < groups_.size(); ++group) {
      decide(group, &found[group * lanes * mechanism_->modes()]);
    }
    return found;
  }

  std::optional<JudgedValues<Rational>> motion(std::size_t scene, std::size_t mode) override {
    run_->decide(groups_[scene / lanes]);
    run_->compute_values(mode);
    const auto solution = run_->solution(mode);
    JudgedValues<Rational> values;
    for (std::size_t i = 0; i < values.size(); ++i) {
      const N value = run_->on(solution, mechanism_->judged(i, run_->program(mode))) / solution.divisor();
      const auto exact = exactly<T>(Lane::get(value, scene % lanes));
      if (!exact) return std::nullopt;
      values[i] = *exact;
    }
    return values;
  }

 private:
  /// Counts every number that is not negative as positive, so that boundary motions are found.
  void decide(std::size_t group, ModeAt* found) {
    run_->decide(groups_[group]);
    std::array<N, most_conditions> sides;
    for (std::size_t mode = 0; mode < mechanism_->modes(); ++mode) {
      const ModeProgram& program = run_->program(mode);
      const auto solution = run_->solution(mode);
      for (std::size_t i = 0; i < program.conditions.size(); ++i) sides[i] = run_->on(solution, program.conditions[i]);
      for (std::size_t lane = 0; lane < lanes; ++lane) {
        const bool flipped = Lane::get(solution.divisor(), lane) < 0;
        bool holds = true, certain = true;
        for (std::size_t i = 0; i < program.conditions.size(); ++i) {
          const T& side = Lane::get(sides[i], lane);
          holds = holds && !(flipped ? side > 0 : side < 0);
          certain = certain && side == side;
        }
        const auto divides = [&](const N& divisor) {
          const T& x = Lane::get(divisor, lane);
          return x != 0 && x - x == 0;
        };
        certain = certain && holds && divides(solution.divisor()) &&
                  std::ranges::all_of(program.pivots, [&](TapeRef pivot) { return divides(run_->at(pivot)); });
        found[lane * mechanism_->modes() + mode] = !holds    ? ModeAt::inconsistent
                                                   : certain ? ModeAt::strict
                                                             : ModeAt::unsure;
      }
    }
  }

  const TradedMechanism* mechanism_ = nullptr;
  std::optional<TapeRun<N>> run_;
  /// Inputs of scenes side by side; the last group is filled up with copies of the last scene.
  std::vector<std::vector<N>> groups_;
};

}  // namespace

void add_plain_arithmetics(Arithmetics& all) {
  const auto add = [&]<class T, std::size_t lanes>(const char* name, int bits, const Pack<T, lanes>&) {
    all.push_back(std::make_unique<PlainArithmetic<T, lanes>>(TradeType{name, bits}));
  };
  add("binary32", 24, Pack<float, 16>{});
  add("binary64", 53, Pack<double, 8>{});
  add("long double", std::numeric_limits<long double>::digits, Pack<long double, 1>{});
  add("binary128", 113, Pack<Binary128, 1>{});
  add("MPFR 50 digits", std::numeric_limits<Mpfr<50>>::digits, Pack<Mpfr<50>, 1>{});
  add("MPFR 100 digits", std::numeric_limits<Mpfr<100>>::digits, Pack<Mpfr<100>, 1>{});
  add("MPFR 200 digits", std::numeric_limits<Mpfr<200>>::digits, Pack<Mpfr<200>, 1>{});
}

}  // namespace slipproof
