#include "claims/paper/setting.hpp"

namespace slipproof {

bool Definition::is_nowhere(Reading reading) const {
  const Expression& e = value(reading);
  return e->operation == Operation::divide && e->operands[1]->operation == Operation::number &&
         e->operands[1]->number == 0;
}

std::string id(const Definition& definition) {
  return (definition.equation.empty() ? "" : definition.equation + ".") + definition.symbol;
}

}  // namespace slipproof
