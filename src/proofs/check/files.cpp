#include "proofs/check/files.hpp"

#include <array>
#include <fstream>
#include <optional>
#include <set>

#include "proofs/check/judge.hpp"
#include "proofs/check/theorem.hpp"

namespace slipproof::check {

namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 5> kVerdicts{"accepted", "rejected", "missing", "undecided", "unreadable"};

/// How many bytes at the beginning are one character that can be shown: none for control characters, for those that
/// turn the direction of the text or end a line in Unicode, and for what is no UTF-8.
std::size_t shown_character(std::string_view text) {
  const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U; };
  const unsigned first = byte(0), second = byte(1);
  if (first < 0x80) return first >= 0x20 && first != 0x7f ? 1 : 0;
  const std::size_t size = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
  for (std::size_t i = 1; i < size; ++i) {
    if (byte(i) < 0x80 || byte(i) >= 0xc0) return 0;
  }
  const bool control = first < 0xc2 || (first == 0xc2 && second < 0xa0) || first > 0xf4;
  const bool direction = first == 0xe2 && (second == 0x80 || second == 0x81);
  return control || direction ? 0 : size;
}

/// The bytes of a file, or why there are none.
struct File {
  std::optional<std::string> text;
  std::string problem;
};

/// Of a longer file one byte more than `limit`, which is then refused.
File load(const fs::path& path, std::size_t limit) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (status.type() == fs::file_type::not_found) {
    return {{}, fs::is_symlink(path, error) ? "a link to nothing" : "there is no such file"};
  }
  if (error) return {{}, error.message()};
  if (!fs::is_regular_file(status)) return {{}, "not a regular file"};
  std::ifstream file(path, std::ios::binary);
  if (!file) return {{}, "the file cannot be opened"};
  std::string text;
  for (std::array<char, 1 << 16> block; text.size() <= limit && file;) {
    file.read(block.data(), static_cast<std::streamsize>(std::min(block.size(), limit + 1 - text.size())));
    text.append(block.data(), static_cast<std::size_t>(file.gcount()));
  }
  if (file.bad()) return {{}, "the file cannot be read"};
  return {std::move(text), ""};
}

bool is_below(const fs::path& path, const fs::path& folder) {
  std::error_code error;
  const fs::path inside = fs::canonical(path, error).lexically_relative(fs::canonical(folder, error));
  return !error && !inside.empty() && *inside.begin() != "..";
}

constexpr std::size_t kMaxTheoremFile = std::size_t{1} << 28;  ///< bytes

bool is_theorem_file(const fs::path& path) {
  std::error_code error;
  return path.extension() == kTheorems && !fs::is_directory(path, error);
}

TheoremFile load_theorems(const fs::path& file) {
  const File whole = load(file, kMaxTheoremFile);
  TheoremFile result;
  if (whole.text && whole.text->size() <= kMaxTheoremFile) return split_theorems(*whole.text);
  result.problem = whole.text ? " the file is too long" : " " + whole.problem;
  return result;
}

/// The certificates of a theorem file; the file itself if it cannot be split.
void find_parts(const fs::path& file, std::set<fs::path>& found) {
  const TheoremFile parts = load_theorems(file);
  if (!parts.problem.empty()) found.insert(file);
  if (!parts.problem.empty()) return;
  for (const auto& [name, theorem] : parts.theorems) found.insert(file / (name + ".cert"));
}

/// `LINE[:COLUMN]: what is wrong` in a part, for its whole file and with the name of the theorem.
std::string in_whole_file(const std::string& message, const Part& part, const std::string& name) {
  const std::size_t digits = message.find(':'), text = message.find(": ");
  const std::size_t line = std::stoul(message.substr(0, digits)) + part.line - 1;
  return std::to_string(line) + message.substr(digits, text - digits) + ": " + name + message.substr(text);
}

/// Each folder is read to its end before those in it are opened: nesting costs no open files.
void find_certificates(const fs::path& folder, const fs::path& root, std::set<fs::path>& found) {
  std::error_code error, ignored;
  std::vector<fs::path> below;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    fs::path path = entry->path();
    const fs::file_type type = entry->symlink_status(ignored).type();
    if (type == fs::file_type::directory) {
      below.push_back(std::move(path));
    } else if (is_theorem_file(path)) {
      find_parts(path, found);
    } else if (path.extension() == ".statement" || path.extension() == ".cert") {
      found.insert(path.replace_extension(".cert"));
    } else if (type == fs::file_type::none || (fs::is_directory(path, ignored) && !is_below(path, root))) {
      found.insert(path);
    }
  }
  if (error) found.insert(folder);
  for (const fs::path& path : below) find_certificates(path, root, found);
}

}  // namespace

std::string printable(const fs::path& path) {
  constexpr std::string_view digits = "0123456789abcdef";
  const std::string text = path.string();
  std::string result;
  for (std::string_view rest = text; !rest.empty();) {
    const std::size_t size = shown_character(rest);
    const auto byte = static_cast<unsigned char>(rest.front());
    if (size == 0) ((result += "\\x") += digits[byte / 16]) += digits[byte % 16];
    result += rest.substr(0, size);
    rest.remove_prefix(std::max<std::size_t>(size, 1));
  }
  return result;
}

std::string_view to_string(Verdict verdict) {
  return kVerdicts.at(static_cast<std::size_t>(verdict));
}

std::shared_ptr<const TheoremFile> Checker::parts_of(const fs::path& file) {
  const std::scoped_lock lock(mutex_);
  if (!parts_ || last_ != file) parts_ = std::make_shared<const TheoremFile>(load_theorems(file));
  last_ = file;
  return parts_;
}

FileResult Checker::check_part(const fs::path& certificate) {
  FileResult result{certificate, Verdict::unreadable, "", ""};
  const fs::path file = certificate.parent_path();
  const std::shared_ptr<const TheoremFile> parts = parts_of(file);
  const auto say = [&](Verdict verdict, const std::string& message) {
    result.verdict = verdict;
    result.message = printable(file) + ":" + message;
    return result;
  };
  if (!parts->problem.empty()) return say(Verdict::unreadable, parts->problem);
  const std::string name = certificate.stem().string(), shown = printable(name);
  const auto found = parts->theorems.find(name);
  if (certificate.extension() != ".cert" || found == parts->theorems.end())
    return say(Verdict::unreadable, " there is no theorem " + shown);
  const auto& [statement, proof] = found->second;
  const Judgement judgement = judge(statement.text, proof.text);
  result.theorem = judgement.theorem;
  const std::string place = std::to_string((proof.line > 0 ? proof : statement).line) + ": " + shown + ": ";
  if (judgement.verdict == Verdict::unreadable)
    return say(judgement.verdict, in_whole_file(judgement.message, statement, shown));
  if (proof.line == 0) return say(Verdict::missing, place + "there is no certificate");
  if (judgement.verdict == Verdict::undecided)
    return say(judgement.verdict, place + "the search ended without a certificate" + judgement.message);
  if (judgement.verdict == Verdict::rejected)
    return say(judgement.verdict, in_whole_file(judgement.message, proof, shown));
  result.verdict = Verdict::accepted;
  return result;
}

FileResult Checker::check(const fs::path& certificate) {
  if (is_theorem_file(certificate.parent_path())) return check_part(certificate);
  FileResult result{certificate, Verdict::unreadable, "", ""};
  const auto say = [&](Verdict verdict, const fs::path& file, const std::string& message) {
    result.verdict = verdict;
    result.message = printable(file) + ":" + message;
    return result;
  };
  if (is_theorem_file(certificate)) {
    const TheoremFile parts = load_theorems(certificate);
    return say(Verdict::unreadable, certificate, parts.problem.empty() ? " no statements here" : parts.problem);
  }
  if (certificate.extension() != ".cert") {
    std::error_code error, ignored;
    const bool folder = fs::is_directory(certificate, ignored);
    const bool link = fs::symlink_status(certificate, error).type() == fs::file_type::symlink;
    const bool exists_unseen = error && error != std::errc::no_such_file_or_directory;
    return say(Verdict::unreadable, certificate,
               exists_unseen ? " " + error.message()
               : !folder     ? " expected NAME.cert, NAME.statement, NAME.theorems or a folder"
               : link        ? " a link to a folder elsewhere, which is not followed"
                             : " the folder cannot be listed");
  }
  const fs::path statement = fs::path(certificate).replace_extension(".statement");
  const File stated = load(statement, kMaxStatement);
  if (!stated.text) return say(Verdict::unreadable, statement, " " + stated.problem);
  std::error_code ignored;
  const bool is_missing = fs::symlink_status(certificate, ignored).type() == fs::file_type::not_found;
  File proof = load(certificate, kMaxWork);
  const Judgement judgement = judge(*stated.text, proof.text.value_or(""));
  result.theorem = judgement.theorem;
  if (judgement.verdict == Verdict::unreadable) return say(Verdict::unreadable, statement, judgement.message);
  if (is_missing) return say(Verdict::missing, certificate, " there is no certificate");
  if (!proof.text) return say(Verdict::unreadable, certificate, " " + proof.problem);
  if (judgement.verdict == Verdict::undecided) {
    return say(Verdict::undecided, certificate, " the search ended without a certificate" + judgement.message);
  }
  if (judgement.verdict == Verdict::rejected) return say(judgement.verdict, certificate, judgement.message);
  result.verdict = Verdict::accepted;
  return result;
}

FileResult check_file(const fs::path& certificate) {
  return Checker().check(certificate);
}

Shown show_part(const std::string& name, const fs::path& file) {
  const TheoremFile parts = load_theorems(file);
  if (!parts.problem.empty()) return {"", printable(file) + ":" + parts.problem};
  if (name == "claims.canonical" && parts.claims.line > 0) return {parts.claims.text, ""};
  const auto named = [&](std::string_view ending) {
    const bool ends = name.ends_with(ending);
    return ends ? parts.theorems.find(name.substr(0, name.size() - ending.size())) : parts.theorems.end();
  };
  const auto statement = named(".statement"), proof = named(".cert"), both = named(""), none = parts.theorems.end();
  if (both != none) return {both->second.statement.text + both->second.certificate.text, ""};
  if (statement != none) return {statement->second.statement.text, ""};
  if (proof != none && proof->second.certificate.line > 0) return {proof->second.certificate.text, ""};
  return {"", printable(file) + ": there is no " + printable(name)};
}

std::vector<fs::path> certificates_in(const fs::path& argument) {
  std::error_code error;
  std::set<fs::path> result;
  if (is_theorem_file(argument)) {
    find_parts(argument, result);
  } else if (fs::is_directory(argument, error)) {
    find_certificates(argument, argument, result);
  } else {
    return {argument.extension() == ".statement" ? fs::path(argument).replace_extension(".cert") : argument};
  }
  return {result.begin(), result.end()};
}

Report check_files(const std::vector<std::string>& arguments) {
  Report report;
  Checker checker;
  for (const std::string& argument : arguments) {
    const auto certificates = certificates_in(argument);
    if (certificates.empty()) {
      report.results.push_back({argument, Verdict::unreadable, {}, printable(argument) + ": no statements here"});
    }
    for (const auto& certificate : certificates) report.results.push_back(checker.check(certificate));
  }
  std::array<std::size_t, kVerdicts.size()> count{};
  for (const FileResult& result : report.results) {
    ++count.at(static_cast<std::size_t>(result.verdict));
    report.text.append(to_string(result.verdict)).append(" ");
    report.text += result.verdict == Verdict::accepted ? result.theorem : result.message;
    const bool is_called_otherwise = result.verdict == Verdict::accepted && result.certificate.stem() != result.theorem;
    report.text += is_called_otherwise ? " in " + printable(result.certificate) + "\n" : "\n";
  }
  const auto some = [&](Verdict verdict) { return count.at(static_cast<std::size_t>(verdict)) > 0; };
  report.summary = some(Verdict::rejected)     ? "s REJECTED"
                   : some(Verdict::unreadable) ? "s UNREADABLE"
                   : some(Verdict::missing)    ? "s MISSING"
                   : some(Verdict::undecided)  ? "s UNDECIDED"
                                               : "s ACCEPTED";
  for (std::size_t i = 0; i < count.size(); ++i) {
    report.summary += (i == 0 ? " " : ", ") + std::to_string(count.at(i)) + " ";
    report.summary += kVerdicts.at(i);
  }
  report.summary += '\n';
  report.exit_code = some(Verdict::rejected)                               ? 5
                     : some(Verdict::unreadable) || some(Verdict::missing) ? 3
                     : some(Verdict::undecided)                            ? 4
                                                                           : 0;
  return report;
}

}  // namespace slipproof::check
