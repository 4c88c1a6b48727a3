#include "check_contact/files.hpp"

#include <array>
#include <filesystem>
#include <fstream>
#include <iostream>

namespace slipproof::check_contact {

namespace {

using Kind = ContactVerdict::Kind;

ContactVerdict check_stream(std::istream& stream) {
  std::string text;
  for (std::array<char, 1 << 16> block; text.size() <= kMaxFile && stream;) {
    stream.read(block.data(), block.size());
    text.append(block.data(), static_cast<std::size_t>(stream.gcount()));
  }
  if (stream.bad()) return {Kind::unreadable, "it cannot be read"};
  if (text.size() > kMaxFile) return {Kind::unreadable, "it has more than " + std::to_string(kMaxFile) + " bytes"};
  return check_contact_certificate(text);
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
  const char* kind = verdict.kind == Kind::accepted   ? "accepted\n"
                     : verdict.kind == Kind::rejected ? "rejected: "
                                                      : "unreadable: ";
  return name + kind + (verdict.kind == Kind::accepted ? name : "") + verdict.message + "\n";
}

}  // namespace

ContactVerdict check_contact_file(const std::string& path) {
  if (path == "-") return check_stream(std::cin);
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (status.type() == std::filesystem::file_type::not_found) return {Kind::unreadable, "there is no such file"};
  if (error) return {Kind::unreadable, error.message()};
  if (!std::filesystem::is_regular_file(status)) return {Kind::unreadable, "it is not a regular file"};
  std::ifstream file(path, std::ios::binary);
  if (!file) return {Kind::unreadable, "the file cannot be opened"};
  return check_stream(file);
}

ContactReport check_contact_files(const std::vector<std::string>& paths) {
  ContactReport report;
  for (const std::string& path : paths) {
    const ContactVerdict verdict = check_contact_file(path);
    report.text += in_words(verdict, paths.size() > 1 ? printable(path) + ": " : "");
    if (verdict.kind == Kind::rejected) report.exit_code = 5;
    if (verdict.kind == Kind::unreadable && report.exit_code == 0) report.exit_code = 3;
  }
  return report;
}

}  // namespace slipproof::check_contact
