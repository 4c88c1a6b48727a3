#include "mechanics/scene/narrow.hpp"

#include "base/expression/logic.hpp"
#include "base/expression/parser.hpp"
#include "mechanics/mechanism/extraction.hpp"
#include "mechanics/mechanism/forms.hpp"
#include "mechanics/reading/reader.hpp"

namespace slipproof {

namespace {

/// What is joined by `and`.
void split(const Expression& condition, std::vector<Expression>& parts) {
  if (condition->operation != Operation::logical_and) {
    parts.push_back(condition);
    return;
  }
  for (const Expression& operand : condition->operands) split(operand, parts);
}

}  // namespace

Mechanism narrowed(const Mechanism& mechanism, std::string_view condition, const std::string& source) {
  Mechanism result = mechanism;
  Mistakes mistakes(source);
  const PlacedText text(std::string(condition), {1, 1});
  try {
    std::vector<Expression> parts, others;
    split(parse_expression(condition, Sort::truth), parts);
    const mechanism_forms::Extraction extraction(mechanism);
    for (const Expression& part : parts) {
      if (extraction.has_load(part)) {
        result.load->domain.push_back({part, text});
      } else {
        others.push_back(part);
      }
    }
    if (!others.empty()) result.assume.push_back({"condition", {all_of(others), text}});
  } catch (const ExpressionError& error) {
    mistakes.add(text.at(error.column() - 1), error.what());
  }
  mechanism_reader::Context context(result, mistakes);
  mechanism_reader::check_uses(context);
  mistakes.refuse_if_any();
  load_bounds(result, mistakes);
  mistakes.refuse_if_any();
  return result;
}

}  // namespace slipproof
