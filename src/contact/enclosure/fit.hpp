// The nearest way in which one contact could obey its law, exactly.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/number/binary64.hpp"
#include "base/number/rational.hpp"
#include "contact/formats/law.hpp"

namespace slipproof {

/// An upper bound on |x|.
inline double upper_size(const Rational& x) {
  return enclose(abs(x)).upper;
}

/// The case of its law that a contact is in. For mu = 0, and in dimension 1, a closed contact sticks.
enum class ContactFit : std::uint8_t { open, stick, slide };

struct FittedContact {
  ContactFit fit = ContactFit::open;
  std::vector<Rational> r, u;  ///< obey the law exactly; `dimension` numbers each
  double moved = 0;            ///< upper bound on |r - the answer's|, the largest component
  double change = 0;           ///< the same of u - the answer's
};

/// A contact as its law sees it.
struct ContactAnswer {
  double mu = 0, scale = 1;        ///< size of the change of u with r (contact_scales())
  std::span<const double> r;       ///< `dimension` components, the normal one first
  std::span<const Rational> u;     ///< the same of A x + c
  std::span<const double> bounds;  ///< bounds of its tangential components; for fixed bounds only
};

/// The fit that changes least: velocities by themselves, forces by the velocities that they give. Among the fits that
/// are tried, which always include the law's projections. r is finite.
FittedContact fit_contact(const ContactLaw& law, const ContactAnswer& answer);

/// Names of the conditions of a fit, on u (`u_n >= 0`, ...) and on the force, for messages about violations.
std::pair<std::string_view, std::string_view> conditions_of(FrictionLaw law, ContactFit fit, std::size_t dimension);

/// A rational point of the unit circle within 1e-15 of the direction (x, y), which is not (0, 0).
std::pair<Rational, Rational> unit_direction(double x, double y);

}  // namespace slipproof
