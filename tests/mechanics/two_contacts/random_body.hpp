// Random bodies on two contacts, exact: of small and of long numbers, of very different sizes, close to where a mode's
// determinant vanishes, close to the listed ones, and with loads close to the border of a mode.
#pragma once

#include <cstdint>
#include <vector>

#include "base/number/dice.hpp"
#include "mechanics/two_contacts/sets.hpp"

namespace slipproof::test::two_contacts {

class RandomBodies {
 public:
  explicit RandomBodies(std::vector<Example> listed) : listed_(std::move(listed)) {}
  /// That of a number; not all are generic.
  Body body(std::uint64_t number) const;

 private:
  std::vector<Example> listed_;
};

}  // namespace slipproof::test::two_contacts
