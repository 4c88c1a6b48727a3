#include "proofs/check/theorem_file.hpp"

#include <algorithm>

#include "proofs/check/reader.hpp"

namespace slipproof::check {

namespace {

/// Takes the first line off the text, without its line feed.
std::string_view take_line(std::string_view& text) {
  const std::size_t size = std::min(text.find('\n'), text.size());
  const std::string_view line = text.substr(0, size);
  text.remove_prefix(std::min(size + 1, text.size()));
  return line;
}

class Splitter {
 public:
  /// Throws Rejection.
  void split(std::string_view text) {
    while (!text.empty()) {
      const std::string_view before = text, line = take_line(text);
      ++number_;
      if (line == "slipproof-claims 1") begin_claims();
      if (line == "slipproof-statement 1") begin_statement(text);
      if (line == "slipproof-certificate 1" || line == "slipproof-undecided 1") begin_certificate();
      require(part_ != nullptr, "expected 'slipproof-claims 1' or 'slipproof-statement 1'");
      part_->text += before.substr(0, before.size() - text.size());
    }
    require(part_ != nullptr, "the file is empty");
  }

  TheoremFile result;
  std::size_t line() const { return std::max<std::size_t>(number_, 1); }

 private:
  void begin(Part& part) {
    part.line = number_;
    part_ = &part;
  }

  void begin_claims() {
    require(part_ == nullptr, "the claims do not come first");
    begin(result.claims);
  }

  void begin_statement(std::string_view rest) {
    Reader next{std::string(take_line(rest))};
    const auto [place, is_new] = result.theorems.try_emplace(next.theorem());
    if (!is_new) throw Rejection("a second statement of " + place->first);
    theorem_ = &place->second;
    begin(theorem_->statement);
  }

  void begin_certificate() {
    require(theorem_ != nullptr, "a certificate without a statement before it");
    require(theorem_->certificate.line == 0, "a second certificate of one statement");
    begin(theorem_->certificate);
  }

  Part* part_ = nullptr;              ///< the one that is read
  StatedTheorem* theorem_ = nullptr;  ///< the one that is read
  std::size_t number_ = 0;            ///< of the line
};

}  // namespace

TheoremFile split_theorems(std::string_view text) {
  const Work work;
  Splitter splitter;
  try {
    splitter.split(text);
  } catch (const Rejection& rejection) {
    splitter.result.problem = std::to_string(splitter.line()) + ": parts: " + rejection.what();
  }
  return splitter.result;
}

}  // namespace slipproof::check
