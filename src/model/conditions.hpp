// The conditions of a contact mode on a motion: the table of contact states in proofs/MODEL.md.
#pragma once

#include <vector>

#include "model/contact_mode.hpp"

namespace slipproof {

/// The conditions of one wheel, in the order in which condition_values() gives them.
inline std::vector<Condition> conditions(Wheel wheel, ContactState state) {
  switch (state) {
    case ContactState::stick:
      return {{wheel, ConditionKind::normal, state},
              {wheel, ConditionKind::friction_up, state},
              {wheel, ConditionKind::friction_dn, state}};
    case ContactState::slip_forward:
    case ContactState::slip_backward:
      return {{wheel, ConditionKind::normal, state}, {wheel, ConditionKind::slip, state}};
    case ContactState::lift:
      break;
  }
  return {{wheel, ConditionKind::gap, state}};
}

inline std::vector<Condition> conditions(ContactMode mode) {
  std::vector<Condition> result = conditions(Wheel::rear, mode.rear);
  for (const Condition& c : conditions(Wheel::front, mode.front)) result.push_back(c);
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
    case ConditionKind::normal:
      return N;
    case ConditionKind::friction_up:
      return f * N - S;
    case ConditionKind::friction_dn:
      return f * N + S;
    case ConditionKind::slip:
      return condition.state == ContactState::slip_forward ? slip : V(-slip);
    case ConditionKind::gap:
      break;
  }
  return m[rear ? Quantity::gap2 : Quantity::gap3];
}

}  // namespace slipproof
