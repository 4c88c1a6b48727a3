#include "claims/reading/paper_folder.hpp"

#include <algorithm>
#include <fstream>
#include <string_view>

namespace slipproof {

namespace {

constexpr std::string_view main_file = "claims.toml", generated = "certificates";

/// Finds the quoted value after `key =` if a line has one; reads nothing else of TOML.
bool has_schema(std::string_view line) {
  const auto skip = [&](std::string_view what) {
    const std::size_t begin = std::min(line.find_first_not_of(" \t"), line.size());
    line.remove_prefix(begin);
    if (!line.starts_with(what)) return false;
    line.remove_prefix(what.size());
    return true;
  };
  return skip("schema") && skip("=") && (skip("\"slipproof/claims/") || skip("'slipproof/claims/"));
}

bool has_claims_file(const std::filesystem::path& folder) {
  std::error_code error;
  return std::filesystem::exists(folder / main_file, error) || !claims_files_in(folder).empty();
}

bool holds_certificates(const std::filesystem::path& folder) {
  return folder == generated || folder.extension() == "." + std::string(generated);
}

}  // namespace

bool is_claims_file(const std::filesystem::path& file) {
  constexpr int most_lines = 200;  // the schema comes before the first table
  std::error_code error;
  if (file.extension() != ".toml" || !std::filesystem::is_regular_file(file, error)) return false;
  std::ifstream lines(file);
  std::string line;
  for (int i = 0; i < most_lines && std::getline(lines, line) && !line.starts_with('['); ++i) {
    if (has_schema(line)) return true;
  }
  return false;
}

std::vector<std::filesystem::path> claims_files_in(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
    if (is_claims_file(entry.path())) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  std::stable_partition(files.begin(), files.end(), [](const auto& file) { return file.filename() == main_file; });
  return files;
}

bool PaperFolder::owns(const std::filesystem::path& file) const {
  const std::filesystem::path inside = file.lexically_normal().lexically_relative(folder.lexically_normal());
  std::filesystem::path below = folder;
  for (const std::filesystem::path& name : inside.parent_path()) {
    below /= name;
    if (below == generated()) continue;
    if (holds_certificates(name) || has_claims_file(below)) return false;
  }
  return true;
}

PaperFolder paper_folder(const std::filesystem::path& claims) {
  PaperFolder result{.folder = claims.has_parent_path() ? claims.parent_path() : "."};
  const auto others = claims_files_in(result.folder);
  const auto is_another = [&](const std::filesystem::path& file) { return file.filename() != claims.filename(); };
  const bool stands_beside = std::any_of(others.begin(), others.end(), is_another);
  if (claims.filename() != main_file && stands_beside)
    result.certificates = claims.stem().string() + "." + std::string(generated);
  return result;
}

}  // namespace slipproof
