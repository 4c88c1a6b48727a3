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

/// The way in which a contact obeys its law. Where mu = 0, and in dimension 1, what is closed sticks.
enum class ContactFit : std::uint8_t { open, stick, slide };

struct FittedContact {
  ContactFit fit = ContactFit::open;
  std::vector<Rational> r, u;  ///< which obey the law exactly, `dimension` of each
  double moved = 0;            ///< upper bound on |r - the answer's|, the largest component
  double change = 0;           ///< the same of u - the answer's
};

/// A contact as its law sees it.
struct ContactAnswer {
  double mu = 0, scale = 1;        ///< how much u changes with r (contact_scales())
  std::span<const double> r;       ///< `dimension` components, the normal one first
  std::span<const Rational> u;     ///< the same of what A x + c is there
  std::span<const double> bounds;  ///< of its tangential components; for fixed bounds only
};

/// The fit that changes least: velocities by themselves, forces by the velocities that they give. Among the fits that
/// are tried, which always include the law's projections. r is finite.
FittedContact fit_contact(const ContactLaw& law, const ContactAnswer& answer);

/// What a contact of this law violates where it is not as the fit says: `u_n >= 0`, ...; and with its force.
std::pair<std::string_view, std::string_view> conditions_of(FrictionLaw law, ContactFit fit, std::size_t dimension);

/// A rational point of the unit circle within 1e-15 of the direction (x, y), which is not (0, 0).
std::pair<Rational, Rational> unit_direction(double x, double y);

}  // namespace slipproof
