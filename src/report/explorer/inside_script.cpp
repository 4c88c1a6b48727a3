#include "report/explorer/inside_script.hpp"

namespace slipproof {

std::string inside_script(const std::string& json) {
  std::string text;
  for (const char c : json) {
    if (c == '<') {
      text += "\\u003c";
    } else {
      text += c;
    }
  }
  return text;
}

}  // namespace slipproof
