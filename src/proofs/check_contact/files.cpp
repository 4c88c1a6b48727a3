#include "proofs/check_contact/files.hpp"

#include <array>
#include <filesystem>
#include <fstream>
#include <iostream>

namespace slipproof::check_contact {

namespace {

using Kind = ContactVerdict::Kind;

constexpr std::array<std::string_view, 4> kKinds{"accepted", "rejected", "missing", "unreadable"};

ContactVerdict too_long() {
  return {Kind::unreadable, "it has more than " + std::to_string(kMaxFile) + " bytes"};
}

ContactVerdict check_stream(std::istream& stream, std::string_view asked) {
  std::string text;
  for (std::array<char, 1 << 16> block; text.size() <= kMaxFile && stream;) {
    stream.read(block.data(), block.size());
    text.append(block.data(), static_cast<std::size_t>(stream.gcount()));
  }
  if (stream.bad()) return {Kind::unreadable, "it cannot be read"};
  if (text.size() > kMaxFile) return too_long();
  return check_contact_certificate(text, asked);
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

ContactVerdict check_contact_file(const std::string& path, std::string_view asked) {
  if (path == "-") return check_stream(std::cin, asked);
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (status.type() == std::filesystem::file_type::not_found) {
    if (std::filesystem::is_symlink(path, error)) return {Kind::unreadable, "it is a link to nothing"};
    return {Kind::missing, "there is no such file"};
  }
  if (error) return {Kind::unreadable, error.message()};
  if (!std::filesystem::is_regular_file(status)) return {Kind::unreadable, "it is not a regular file"};
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (!error && size > kMaxFile) return too_long();
  std::ifstream file(path, std::ios::binary);
  if (!file) return {Kind::unreadable, "the file cannot be opened"};
  return check_stream(file, asked);
}

ContactReport check_contact_files(const std::vector<std::string>& paths, std::string_view asked) {
  ContactReport report;
  std::array<std::size_t, kKinds.size()> count{};
  for (const std::string& path : paths) {
    const ContactVerdict& verdict = report.verdicts.emplace_back(check_contact_file(path, asked));
    report.text += in_words(verdict, paths.size() > 1 ? printable(path) + ": " : "");
    ++count.at(static_cast<std::size_t>(verdict.kind));
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
