// Whose claim each is: what the claims file says, and that it agrees with the sources of the shipped papers.
#include <cctype>
#include <filesystem>
#include <sstream>

#include "claims/reading/small_paper.hpp"
#include "support/run_program.hpp"

using namespace slipproof;
using namespace slipproof::test;

namespace {

const std::filesystem::path proofs_folder = SLIPPROOF_SOURCE_DIR "/proofs";

std::string in_paper(const std::string& key) {
  return replaced(small, "source = \"paper.tex\"\n", "source = \"paper.tex\"\n" + key);
}
std::string in_claim(const std::string& text, const std::string& key) {
  return replaced(text, "id = \"A1\"\n", "id = \"A1\"\n" + key);
}
Origin origin(const std::string& text) {
  return parse_claims(text, "small.toml").find("A1")->origin;
}

/// Whether a line of sources.txt, without its number, begins with `Ours` or `Our own`.
bool is_marked(std::string_view line) {
  while (!line.empty() && (std::isdigit(static_cast<unsigned char>(line.front())) != 0 || line.front() == '.')) {
    line.remove_prefix(1);
  }
  return line.starts_with(" Ours:") || line.starts_with(" Our own:");
}

}  // namespace

TEST_CASE("a claim is printed unless it, or the paper for all of its claims, says that it is ours") {
  CHECK(origin(small) == Origin::printed);
  CHECK(origin(in_claim(small, "origin = \"ours\"\n")) == Origin::ours);
  CHECK(origin(in_paper("origin = \"ours\"\n")) == Origin::ours);
  CHECK(origin(in_claim(in_paper("origin = \"ours\"\n"), "origin = \"printed\"\n")) == Origin::printed);
}

TEST_CASE("another origin is refused at its place") {
  for (const std::string& text : {in_paper("origin = \"our\"\n"), in_claim(small, "origin = \"our\"\n")}) {
    CHECK_THROWS_WITH_AS(parse_claims(text, "small.toml"),
                         doctest::Contains("origin: unknown origin 'our', did you mean 'ours'?"), InputError);
  }
  CHECK_THROWS_WITH_AS(parse_claims(in_claim(small, "origin = true\n"), "small.toml"), doctest::Contains("origin: "),
                       InputError);
}

TEST_CASE("the claims of the shipped papers and their sources agree on what is ours") {
  std::size_t printed = 0, ours = 0;
  for (const auto& entry : std::filesystem::directory_iterator(proofs_folder)) {
    if (!std::filesystem::exists(entry.path() / "claims.toml")) continue;
    const ClaimsFile file = read_claims(entry.path() / "claims.toml");
    const std::filesystem::path path = entry.path() / "sources.txt";
    const std::string sources = std::filesystem::exists(path) ? read_file(path) : "";
    std::vector<std::string> lines;
    std::istringstream all(sources);
    for (std::string line; std::getline(all, line);) lines.push_back(line);
    const bool beyond = sources.find("claimed beyond these lines is our own") != sources.npos;
    const bool whole = sources.find("All of it is our own") != sources.npos;
    for (const Claim& claim : file.claims) {
      CAPTURE(path.string());
      CAPTURE(claim.id);
      ++(claim.origin == Origin::ours ? ours : printed);
      const bool marked = claim.line <= lines.size() && is_marked(lines[claim.line - 1]);
      if (marked || whole) CHECK(claim.origin == Origin::ours);
      if (claim.origin == Origin::ours) CHECK((marked || whole || beyond));
      CHECK_FALSE(claim.statement.starts_with("our"));  // the words belong to `origin`
    }
  }
  const std::string counts = std::to_string(printed) + " claims as printed, " + std::to_string(ours) + " of our own";
  for (const auto& page : {proofs_folder / "README.md", proofs_folder / "../README.md"}) {
    CAPTURE(page.string());
    CHECK(read_file(page).find(counts) != std::string::npos);
  }
}
