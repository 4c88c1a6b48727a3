// The library as the explorer's page calls it. Each function is one call of the library.
#include <exception>
#include <fstream>
#include <optional>
#include <string>

#include "base/output/json.hpp"
#include "base/parallel/failure.hpp"
#include "faces/explorer/explorer.hpp"

namespace {

/// The page has one scene, and a text that it is reading.
std::optional<slipproof::Explorer> explorer;
std::string text;

slipproof::PortableScene read(const char* given) {
  const auto json = slipproof::Json::parse(given);
  return {json.at("scene"), json.at("mechanism"), json.at("along"), json.at("file")};
}

}  // namespace

extern "C" {

/// Opens the scene that explorer_page() wrote; its mechanism's file goes into the page's own files, in memory. Returns
/// what is wrong, or an empty text. A text is there until the next call.
const char* slipproof_open(const char* given, const char* mechanism) {
  text.clear();
  try {
    std::ofstream("mechanism.toml") << mechanism;
    explorer.emplace(read(given));
  } catch (const std::exception& error) {
    text = error.what();
  }
  return text.c_str();
}

/// Explorer::answer(), after slipproof_open().
const char* slipproof_answer(const char* request) {
  try {
    text = explorer->answer(request);
  } catch (const std::exception& error) {
    text = slipproof::json_text({{"mistakes", {slipproof::failure_text(error.what(), SLIPPROOF_VERSION)}}});
  }
  return text.c_str();
}
}
