#include "proofs/statement/theorems.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <string_view>

#include "base/input/diagnostic.hpp"
#include "base/input/text_file.hpp"

namespace slipproof {

namespace {

constexpr std::string_view theorem_extension = ".theorems";
constexpr std::size_t max_file = std::size_t{1} << 28U;

enum class PartKind { claims, statement, certificate };

std::optional<PartKind> begun_by(std::string_view line) {
  if (line == "slipproof-claims 1") return PartKind::claims;
  if (line == "slipproof-statement 1") return PartKind::statement;
  if (line == "slipproof-certificate 1" || line == "slipproof-undecided 1") return PartKind::certificate;
  return std::nullopt;
}

class TheoremReader {
 public:
  TheoremReader(const std::filesystem::path& file, std::string_view text) : file_(file), text_(text) {}

  TheoremFile read() {
    while (place_ < text_.size()) {
      const std::string_view line = line_at(place_);
      ++number_;
      if (const auto kind = begun_by(line)) begin(*kind, line_at(std::min(place_ + line.size() + 1, text_.size())));
      if (part_ == nullptr) refuse("found another text, expected `slipproof-claims 1` or `slipproof-statement 1`");
      const std::size_t size = std::min(line.size() + 1, text_.size() - place_);
      part_->append(text_.substr(place_, size));
      place_ += size;
    }
    return std::move(result_);
  }

 private:
  [[noreturn]] void refuse(const std::string& message) const {
    throw InputError({{file_.string(), number_, 0, message}});
  }

  std::string_view line_at(std::size_t place) const {
    return text_.substr(place, std::min(text_.find('\n', place), text_.size()) - place);
  }

  void begin(PartKind kind, std::string_view next_line) {
    std::vector<Theorem>& theorems = result_.theorems;
    if (kind == PartKind::claims) {
      if (part_ != nullptr) refuse("found claims, expected them at the beginning of the file");
      part_ = &result_.claims;
    } else if (kind == PartKind::statement) {
      constexpr std::string_view before_name = "theorem ";
      if (!next_line.starts_with(before_name)) refuse("found another next line, expected `theorem NAME`");
      std::string name(next_line.substr(before_name.size()));
      if (!names_.insert(name).second) refuse("found a second statement " + in_quotes(name) + ", expected one");
      theorems.push_back({.name = std::move(name), .statement = {}, .certificate = {}, .line = number_});
      part_ = &theorems.back().statement;
    } else {
      if (theorems.empty() || !theorems.back().certificate.empty())
        refuse("found a certificate, expected the statement that it proves before it");
      part_ = &theorems.back().certificate;
    }
  }

  const std::filesystem::path& file_;
  std::string_view text_;
  TheoremFile result_;
  std::set<std::string> names_;
  std::string* part_ = nullptr;  ///< the one that is read
  std::size_t place_ = 0, number_ = 0;
};

std::optional<std::string> part_of(const TheoremFile& file, const std::filesystem::path& name) {
  if (name == canonical_name) return file.claims.empty() ? std::nullopt : std::optional(file.claims);
  const Theorem* const theorem = file.find(name.stem().string());
  if (theorem == nullptr) return std::nullopt;
  if (name.extension() == ".statement") return theorem->statement;
  if (name.extension() != ".cert" || theorem->certificate.empty()) return std::nullopt;
  return theorem->certificate;
}

}  // namespace

const Theorem* TheoremFile::find(const std::string& name) const {
  const auto found = std::find_if(theorems.begin(), theorems.end(), [&](const Theorem& t) { return t.name == name; });
  return found == theorems.end() ? nullptr : &*found;
}

std::string TheoremFile::text() const {
  std::string all = claims;
  for (const Theorem& theorem : theorems) {
    for (const std::string* part : {&theorem.statement, &theorem.certificate}) {
      all += *part;
      if (!all.empty() && all.back() != '\n') all += '\n';  // the last of a file that was written by hand
    }
  }
  return all;
}

TheoremFile read_theorems(const std::filesystem::path& file) {
  const std::string text = read_found_file(file, max_file);
  return TheoremReader(file, text).read();
}

bool is_theorem_file(const std::filesystem::path& path) {
  std::error_code error;
  return path.extension() == theorem_extension && !std::filesystem::is_directory(path, error);
}

std::filesystem::path file_of(const std::filesystem::path& path) {
  return is_theorem_file(path.parent_path()) ? path.parent_path() : path;
}

const TheoremFile* TheoremTexts::read_once(const std::filesystem::path& file) {
  const auto [place, is_new] = files_.try_emplace(file);
  if (is_new) {
    try {
      place->second = read_theorems(file);
    } catch (const InputError&) {
      // The checker says what is wrong with the file.
    }
  }
  return place->second ? &*place->second : nullptr;
}

std::optional<std::string> TheoremTexts::at(const std::filesystem::path& path) {
  const std::filesystem::path file = file_of(path);
  if (file != path) {
    const std::scoped_lock lock(mutex_);
    const TheoremFile* const found = read_once(file);
    return found == nullptr ? std::nullopt : part_of(*found, path.filename());
  }
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return std::nullopt;  // a pipe is not even opened: that waits
  try {
    return read_text_file(path, max_file);
  } catch (const InputError&) {
    return std::nullopt;
  }
}

std::size_t TheoremTexts::line_of(const std::filesystem::path& statement) {
  const std::filesystem::path file = file_of(statement);
  if (file == statement) return 1;
  const std::scoped_lock lock(mutex_);
  const TheoremFile* const found = read_once(file);
  const Theorem* const theorem = found == nullptr ? nullptr : found->find(statement.stem().string());
  return theorem == nullptr ? 1 : theorem->line;
}

}  // namespace slipproof
