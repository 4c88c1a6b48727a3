#include "claims/reading/paper_folder.hpp"

#include <algorithm>
#include <fstream>
#include <string_view>

#include "proofs/statement/theorems.hpp"

namespace slipproof {

namespace {

constexpr std::string_view main_file = "claims.toml", generated_name = "certificates";

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

/// Whether a folder or file is made from claims: old_certificates(), or the theorem file of a claims file.
bool is_generated(const std::filesystem::path& path) {
  const std::filesystem::path name = path.filename();
  if (name == generated_name || name.extension() == "." + std::string(generated_name)) return true;
  return is_theorem_file(path) && is_claims_file(std::filesystem::path(path).replace_extension(".toml"));
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

std::filesystem::path PaperFolder::old_certificates() const {
  return folder / (is_main ? std::string(generated_name) : name + "." + std::string(generated_name));
}

std::filesystem::path PaperFolder::generated() const {
  std::error_code error;
  const bool is_old =
      !std::filesystem::exists(theorems(), error) && std::filesystem::is_directory(old_certificates(), error);
  return is_old ? old_certificates() : theorems();
}

bool PaperFolder::owns(const std::filesystem::path& file) const {
  const std::filesystem::path inside = file.lexically_normal().lexically_relative(folder.lexically_normal());
  const std::filesystem::path own = generated();
  std::filesystem::path below = folder;
  for (const std::filesystem::path& name : is_theorem_file(file) ? inside : inside.parent_path()) {
    below /= name;
    if (below == own) continue;
    if (is_generated(below) || (!is_theorem_file(below) && has_claims_file(below))) return false;
  }
  return true;
}

PaperFolder paper_folder(const std::filesystem::path& claims) {
  PaperFolder result{.folder = claims.has_parent_path() ? claims.parent_path() : ".", .name = claims.stem().string()};
  const auto others = claims_files_in(result.folder);
  const auto is_another = [&](const std::filesystem::path& file) { return file.filename() != claims.filename(); };
  result.is_main = claims.filename() == main_file || std::none_of(others.begin(), others.end(), is_another);
  return result;
}

}  // namespace slipproof
