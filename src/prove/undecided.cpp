#include "prove/undecided.hpp"

#include <algorithm>

namespace slipproof {

std::string undecided_text(const std::string& theorem, const std::vector<std::string>& reasons) {
  std::string text = "slipproof-undecided 1\ntheorem " + theorem + '\n';
  for (std::string reason : reasons) {
    std::replace(reason.begin(), reason.end(), '\n', ' ');
    text += "because " + reason + '\n';
  }
  return text;
}

}  // namespace slipproof
