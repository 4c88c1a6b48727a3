#include "proofs/check_contact/files.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <optional>

namespace slipproof::check_contact {

namespace {

using Kind = ContactVerdict::Kind;

constexpr std::array<std::string_view, 4> kKinds{"accepted", "rejected", "missing", "unreadable"};
constexpr std::string_view kHeader = "slipproof-contact 1";  ///< the line that a certificate begins with

ContactVerdict too_long() {
  return {Kind::unreadable, "it has more than " + std::to_string(kMaxFile) + " bytes"};
}

/// The bytes of a file, or why there are none.
struct Loaded {
  std::string text;
  std::optional<ContactVerdict> problem;
};

Loaded load_stream(std::istream& stream) {
  std::string text;
  for (std::array<char, 1 << 16> block; text.size() <= kMaxFile && stream;) {
    stream.read(block.data(), block.size());
    text.append(block.data(), static_cast<std::size_t>(stream.gcount()));
  }
  if (stream.bad()) return {"", ContactVerdict{Kind::unreadable, "it cannot be read"}};
  if (text.size() > kMaxFile) return {"", too_long()};
  return {std::move(text), {}};
}

Loaded load(const std::string& path) {
  const auto without = [](Kind kind, const std::string& why) { return Loaded{"", ContactVerdict{kind, why}}; };
  if (path == "-") return load_stream(std::cin);
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (status.type() == std::filesystem::file_type::not_found) {
    if (std::filesystem::is_symlink(path, error)) return without(Kind::unreadable, "it is a link to nothing");
    return without(Kind::missing, "there is no such file");
  }
  if (error) return without(Kind::unreadable, error.message());
  if (!std::filesystem::is_regular_file(status)) return without(Kind::unreadable, "it is not a regular file");
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (!error && size > kMaxFile) return {"", too_long()};
  std::ifstream file(path, std::ios::binary);
  if (!file) return without(Kind::unreadable, "the file cannot be opened");
  return load_stream(file);
}

/// A certificate in a file, and its first line there.
struct Part {
  std::string_view text;
  std::size_t line = 1;
};

/// Splits before each line that begins a certificate, but for the first of them: what is before it belongs to it.
std::vector<Part> parts_of(std::string_view text) {
  std::vector<Part> parts{{text.substr(0, 0), 1}};
  bool any = false;
  std::size_t start = 0, line = 1;
  for (std::size_t place = 0; place < text.size(); ++line) {
    const std::size_t end = std::min(text.find('\n', place), text.size());
    if (text.substr(place, end - place) == kHeader) {
      if (any) parts.push_back({{}, line});
      if (any) start = place;
      any = true;
    }
    place = std::min(end + 1, text.size());
    parts.back().text = text.substr(start, place - start);
  }
  return parts;
}

/// The name of a file, in which a byte that is not printable ASCII is \xHH: otherwise it could pass for other lines.
std::string printable(const std::string& path) {
  constexpr std::string_view digits = "0123456789abcdef";
  std::string result;
  for (const char c : path) {
    const auto byte = static_cast<unsigned char>(c);
    if (c >= ' ' && c <= '~') {
      result += c;
    } else {
      ((result += "\\x") += digits[byte / 16]) += digits[byte % 16];
    }
  }
  return result;
}

std::string in_words(const ContactVerdict& verdict, const std::string& name) {
  const std::string kind(to_string(verdict.kind));
  const std::string after = verdict.kind == Kind::accepted ? "\n" + name : ": ";
  return name + kind + after + verdict.message + "\n";
}

}  // namespace

std::string_view to_string(Kind kind) {
  return kKinds.at(static_cast<std::size_t>(kind));
}

ContactVerdict check_contact_file(const std::string& path, std::string_view required_name) {
  const Loaded loaded = load(path);
  return loaded.problem ? *loaded.problem : check_contact_certificate(loaded.text, required_name);
}

ContactReport check_contact_files(const std::vector<std::string>& paths, std::string_view required_name) {
  ContactReport report;
  std::array<std::size_t, kKinds.size()> count{};
  const auto add = [&](const ContactVerdict& verdict, const std::string& name) {
    report.verdicts.push_back(verdict);
    report.text += in_words(verdict, name.empty() ? "" : name + ": ");
    ++count.at(static_cast<std::size_t>(verdict.kind));
  };
  for (const std::string& path : paths) {
    const std::string name = paths.size() > 1 ? printable(path) : "";
    const Loaded loaded = load(path);
    if (loaded.problem) add(*loaded.problem, name);
    if (loaded.problem) continue;
    const std::vector<Part> parts = parts_of(loaded.text);
    for (const Part& part : parts) {
      const std::string place = parts.size() > 1 ? printable(path) + ":" + std::to_string(part.line) : name;
      add(check_contact_certificate(std::string(part.text), required_name), place);
    }
  }
  const auto [accepted, rejected, missing, unreadable] = count;
  report.exit_code = rejected > 0 ? 5 : unreadable + missing > 0 ? 3 : 0;
  const char* word = rejected > 0 ? "REJECTED" : unreadable > 0 ? "UNREADABLE" : missing > 0 ? "MISSING" : "ACCEPTED";
  const auto counted = [](std::size_t number, const char* what) { return std::to_string(number) + what; };
  // A search that ends without a certificate leaves no file: none is undecided.
  report.summary = std::string("s ") + word + " " + counted(accepted, " accepted, ") +
                   counted(rejected, " rejected, ") + counted(missing, " missing, 0 undecided, ") +
                   counted(unreadable, " unreadable\n");
  return report;
}

}  // namespace slipproof::check_contact
