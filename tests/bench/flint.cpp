// The raw systems of all 16 modes by FLINT's fmpq_mat_solve: what the exact solver must not be slower than.
#include <benchmark/benchmark.h>
#include <flint/fmpq_mat.h>

#include "bench/examples.hpp"
#include "mechanics/bicycle_modes/mode_table.hpp"
#include "support/raw_solver.hpp"

namespace {

using namespace slipproof;

/// The equations of a mode, their right-hand sides for 1 and F, and the solution.
class System {
 public:
  System(const test::Example& e, ContactMode mode) {
    constexpr slong n = static_cast<slong>(unknown_count);
    fmpq_mat_init(matrix_, n, n);
    fmpq_mat_init(right_, n, 2);
    fmpq_mat_init(solution_, n, 2);
    const auto set = [](fmpq* entry, const Rational& x) {
      const fmpq value = x.flint();
      fmpq_set(entry, &value);
    };
    const auto rows = raw_system(e.bicycle, e.road, ForceKind::internal, mode);
    for (slong i = 0; i < n; ++i) {
      const auto& form = rows[static_cast<std::size_t>(i)];
      for (slong j = 0; j < n; ++j) {
        set(fmpq_mat_entry(matrix_, i, j), form.coefficients[static_cast<std::size_t>(j)]);
      }
      set(fmpq_mat_entry(right_, i, 0), Rational(-form.constant));
      set(fmpq_mat_entry(right_, i, 1), Rational(-form.coefficients[unknown_count]));
    }
  }
  System(const System&) = delete;
  System& operator=(const System&) = delete;
  ~System() {
    fmpq_mat_clear(matrix_);
    fmpq_mat_clear(right_);
    fmpq_mat_clear(solution_);
  }

  bool solve() { return fmpq_mat_solve(solution_, matrix_, right_) != 0; }
  /// The unknown with this index in Unknowns, as a function of F.
  Affine<Rational> unknown(slong index) const {
    const auto get = [&](slong column) { return Rational(fmpq_mat_entry(solution_, index, column)); };
    return {get(0), get(1)};
  }

 private:
  fmpq_mat_t matrix_, right_, solution_;
};

/// The 11 unknowns of each mode as functions of F: 22 fractions in lowest terms. Making the matrices does not count.
void flint_raw_all_modes(benchmark::State& state) {
  std::vector<std::unique_ptr<System>> systems;
  for (const test::Example& e : test::examples()) {
    const ModeTable table(e.bicycle, e.road, ForceKind::internal);
    for (const ModeSolution& s : table.solutions()) {
      systems.push_back(std::make_unique<System>(e, s.mode()));
      if (!systems.back()->solve() || systems.back()->unknown(0) != s.quantity(Quantity::a) ||
          systems.back()->unknown(10) != s.quantity(Quantity::N3)) {
        state.SkipWithError("the two solvers disagree");
        return;
      }
    }
  }
  std::size_t i = 0;
  for (auto _ : state) {
    for (int mode = 0; mode < 16; ++mode) benchmark::DoNotOptimize(systems[i++ % systems.size()]->solve());
  }
}
BENCHMARK(flint_raw_all_modes)->Unit(benchmark::kMicrosecond);

}  // namespace
