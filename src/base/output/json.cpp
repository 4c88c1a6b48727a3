#include "base/output/json.hpp"

#include "base/number/format.hpp"

namespace slipproof {

std::string json_text(const Json& json, int indent) {
  return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

std::string inner_json_text(const Json& json) {
  const std::string text = json_text(json);
  return text.substr(1, text.size() - 2);
}

Json exact_texts(const std::vector<Rational>& values) {
  Json list = Json::array();
  for (const Rational& x : values) list.push_back(exact_text(x));
  return list;
}

}  // namespace slipproof
