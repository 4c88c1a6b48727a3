#include "base/output/percent.hpp"

#include <fmt/format.h>

namespace slipproof {

std::string percent_encoded(std::string_view text, std::string_view also) {
  const auto plain = [&](char c) {
    return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') ||
           std::string_view("-_.~").find(c) != std::string_view::npos || also.find(c) != std::string_view::npos;
  };
  std::string encoded;
  for (const char c : text) {
    encoded += plain(c) ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  return encoded;
}

}  // namespace slipproof
