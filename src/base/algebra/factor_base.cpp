#include "base/algebra/factor_base.hpp"

#include <flint/fmpz_poly_factor.h>
#include <flint/nmod_poly.h>

#include <array>
#include <utility>

namespace slipproof {

namespace {

/// The possible degrees of factors of a polynomial as a bit set, from its factors modulo a prime.
std::uint64_t factor_degrees(const IntegerPolynomial& p, ulong prime) {
  std::uint64_t possible = ~std::uint64_t{0};
  if (fmpz_fdiv_ui(fmpz_poly_lead(p.flint()), prime) == 0) return possible;
  nmod_poly_t reduced;
  nmod_poly_init(reduced, prime);
  fmpz_poly_get_nmod_poly(reduced, p.flint());
  if (nmod_poly_is_squarefree(reduced) != 0) {
    nmod_poly_make_monic(reduced, reduced);
    std::vector<slong> degrees(static_cast<std::size_t>(p.degree()));
    slong* const first = degrees.data();
    nmod_poly_factor_t products;  // of the factors of one degree
    nmod_poly_factor_init(products);
    nmod_poly_factor_distinct_deg(products, reduced, &first);
    possible = 1;
    for (slong i = 0; i < products->num; ++i) {
      const slong degree = degrees[static_cast<std::size_t>(i)];
      for (slong left = nmod_poly_degree(products->p + i); left > 0; left -= degree) possible |= possible << degree;
    }
    nmod_poly_factor_clear(products);
  }
  nmod_poly_clear(reduced);
  return possible;
}

/// Nearly all that come are irreducible, and a few primes show it: no degree of a factor is possible modulo all of
/// them.
bool surely_irreducible(const IntegerPolynomial& p) {
  constexpr std::array<ulong, 6> primes{101, 103, 107, 109, 113, 127};
  const long degree = p.degree();
  if (degree < 4 || degree > 63) return false;  // FLINT solves those of low degree
  std::uint64_t possible = (std::uint64_t{1} << degree) - 2;
  for (const ulong prime : primes) {
    possible &= factor_degrees(p, prime);
    if (possible == 0) return true;
  }
  return false;
}

}  // namespace

/// Monic, so that remainders of it need no inverse.
class FactorBase::Residue {
 public:
  explicit Residue(const IntegerPolynomial& p) {
    constexpr ulong prime = (ulong{1} << (FLINT_BITS == 64 ? 61 : 31)) - 1;
    nmod_poly_init(value_, prime);
    fmpz_poly_get_nmod_poly(value_, p.flint());
    if (nmod_poly_is_zero(value_) == 0) nmod_poly_make_monic(value_, value_);
  }
  Residue(const Residue&) = delete;
  Residue& operator=(const Residue&) = delete;
  ~Residue() { nmod_poly_clear(value_); }

  bool divides(const Residue& other) const {
    if (nmod_poly_is_zero(value_) != 0) return nmod_poly_is_zero(other.value_) != 0;
    if (nmod_poly_degree(value_) == 1) {
      const ulong root = nmod_neg(nmod_poly_get_coeff_ui(value_, 0), value_->mod);
      return nmod_poly_evaluate_nmod(other.value_, root) == 0;
    }
    Residue remainder;
    nmod_poly_rem(remainder.value_, other.value_, value_);
    return nmod_poly_is_zero(remainder.value_) != 0;
  }

 private:
  Residue() : Residue(IntegerPolynomial()) {}
  nmod_poly_t value_;
};

FactorBase::FactorBase() = default;
FactorBase::~FactorBase() = default;

IntegerPolynomial FactorBase::without_known(IntegerPolynomial p) {
  auto residue = std::make_unique<Residue>(p);
  IntegerPolynomial quotient;
  for (Known& known : known_) {
    ++known.tried;
    while (known.factor->degree() <= p.degree()) {
      ++remainders_;
      if (!known.residue->divides(*residue)) break;
      ++divisions_;
      if (fmpz_poly_divides(quotient.flint(), p.flint(), known.factor->flint()) == 0) break;
      ++known.divided;
      std::swap(p, quotient);
      residue = std::make_unique<Residue>(p);
    }
  }
  constexpr std::uint64_t patience = 64, patience_for_each = 512;
  std::erase_if(known_, [](const Known& known) { return known.tried > patience + patience_for_each * known.divided; });
  return p;
}

void FactorBase::insert(IntegerPolynomial factor) {
  const auto [place, is_new] = factors_.insert(std::move(factor));
  // One that is not new was given up, and divided a polynomial nevertheless.
  known_.push_back({&*place, std::make_unique<Residue>(*place), 0, is_new ? 0U : 1U});
}

void FactorBase::add(const IntegerPolynomial& p, const std::function<bool(const IntegerPolynomial&)>& matters) {
  const IntegerPolynomial rest = without_known(p);
  if (rest.degree() < 1 || !matters(rest)) return;
  if (rest.degree() == 1 || surely_irreducible(rest)) {
    insert(rest.primitive());
    return;
  }
  ++factored_;
  fmpz_poly_factor_t factored;
  fmpz_poly_factor_init(factored);
  fmpz_poly_factor(factored, rest.flint());
  for (slong i = 0; i < factored->num; ++i) {
    IntegerPolynomial factor;
    fmpz_poly_set(factor.flint(), factored->p + i);
    insert(factor.primitive());
  }
  fmpz_poly_factor_clear(factored);
}

}  // namespace slipproof
