// What certify says of the recorded answers of real solvers is what cases/solvers/README.md tells.
#include <doctest/doctest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "records/certify/certify.hpp"

using namespace slipproof;

TEST_CASE("the verdicts on recorded solvers are those of the table") {
  const std::string folder = std::string(SLIPPROOF_SOURCE_DIR) + "/cases/solvers/";
  std::ifstream readme(folder + "README.md");
  REQUIRE(readme);
  std::string row;
  int files = 0;
  while (std::getline(readme, row)) {
    if (row.find(".csv | ") == std::string::npos) continue;
    std::istringstream cells(row);
    std::string bar, name;
    cells >> bar >> name;
    CAPTURE(name);
    std::array<std::uint64_t, record_verdict_count> expected{};
    std::uint64_t unfounded = 0;
    for (std::size_t i = 0; i < expected.size() - 1; ++i) cells >> bar >> expected[i];  // none is undecided
    cells >> bar >> unfounded;

    std::ifstream file(folder + name);
    REQUIRE(file);
    CertifyOptions options;
    options.ignore_unknown = true;
    options.threads = 1;
    std::string lines, line, record;
    const auto summary = certify(
        file, [&](std::string_view out) { lines += out; }, options);
    CHECK(summary.verdicts == expected);
    CHECK(summary.records == 172);

    file.clear();
    file.seekg(0);
    std::getline(file, record);
    std::istringstream verdicts(lines);
    std::uint64_t found = 0;
    while (std::getline(file, record) && std::getline(verdicts, line)) {
      const std::string verdict = nlohmann::json::parse(line).at("verdict");
      if (record.ends_with(",0") && (verdict == "wrong" || verdict == "invalid")) ++found;
    }
    CHECK(found == unfounded);
    ++files;
  }
  CHECK(files == 12);
}
