// The conditions of a contact mode on a motion: the contact states of proofs/MODEL.md.
#pragma once

#include <vector>

#include "support/bicycle/contact_mode.hpp"

namespace slipproof {

/// The conditions of one wheel, then of the other, in the order of the table of states.
inline std::vector<Condition> conditions(ContactMode mode) {
  std::vector<Condition> result;
  for (const Wheel wheel : {Wheel::rear, Wheel::front}) {
    for (const StateCondition c : conditions(ElementKind{}, mode[wheel])) result.push_back({wheel, c});
  }
  return result;
}

/// The left-hand side of a condition on a motion; f is the Coulomb coefficient. V is a number or affine in F.
template <class T, class V>
V condition_value(const Condition& condition, const Motion<V>& m, const T& f) {
  const bool rear = condition.wheel == Wheel::rear;
  const V& N = m[rear ? Quantity::N2 : Quantity::N3];
  const V& S = m[rear ? Quantity::S2 : Quantity::S3];
  const V& slip = m[rear ? Quantity::slip2 : Quantity::slip3];
  switch (condition.kind) {
    case StateCondition::pushes:
      return N;
    case StateCondition::holds_forward:
      return f * N - S;
    case StateCondition::holds_backward:
      return f * N + S;
    case StateCondition::slips_forward:
      return slip;
    case StateCondition::slips_backward:
      return -slip;
    default:
      return m[rear ? Quantity::gap2 : Quantity::gap3];
  }
}

}  // namespace slipproof
