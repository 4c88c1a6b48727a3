#include "support/bicycle/contact_mode.hpp"

#include <algorithm>

namespace slipproof {

namespace {
constexpr std::array<std::string_view, quantity_count> quantity_names{
    "a", "a_y", "phi", "eps2", "eps3", "S2", "S3", "N2", "N3", "gap2", "gap3", "slip2", "slip3"};

}  // namespace

std::string name(ContactMode mode) {
  return std::string(name(mode.rear)) + '/' + std::string(name(mode.front));
}

std::string_view name(Quantity quantity) {
  return quantity_names[static_cast<std::size_t>(quantity)];
}

}  // namespace slipproof
