// What certify says of records.
#pragma once

#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "records/certify/certify.hpp"

namespace slipproof::test {

struct Certified {
  std::string text;
  CertifySummary summary;

  std::vector<nlohmann::json> lines() const {
    std::istringstream in(text);
    std::vector<nlohmann::json> result;
    for (std::string line; std::getline(in, line);) result.push_back(nlohmann::json::parse(line));
    return result;
  }
};

inline Certified certified(const std::string& records, const CertifyOptions& options = {}) {
  std::istringstream input(records);
  Certified result;
  result.summary = certify(
      input, [&result](std::string_view out) { result.text += out; }, options);
  return result;
}

}  // namespace slipproof::test
