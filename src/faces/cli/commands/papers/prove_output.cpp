#include "faces/cli/commands/papers/prove_output.hpp"

#include <algorithm>

#include "base/output/output_file.hpp"

namespace slipproof::cli {

namespace {

constexpr std::chrono::seconds between_saves{20};

Theorem& theorem_named(TheoremFile& file, const std::string& name) {
  const auto is_it = [&](const Theorem& theorem) { return theorem.name == name; };
  const auto found = std::find_if(file.theorems.begin(), file.theorems.end(), is_it);
  if (found != file.theorems.end()) return *found;
  return file.theorems.emplace_back(Theorem{.name = name, .statement = {}, .certificate = {}});
}

TheoremChanges compared(const std::filesystem::path& path, const TheoremFile& before, const TheoremFile& now) {
  TheoremChanges result{.file = path.lexically_normal()};
  for (const Theorem& theorem : now.theorems) {
    const Theorem* const old = before.find(theorem.name);
    const bool same = old != nullptr && old->statement == theorem.statement && old->certificate == theorem.certificate;
    ++(old == nullptr ? result.added : same ? result.as_before : result.changed);
  }
  for (const Theorem& theorem : before.theorems) {
    if (now.find(theorem.name) == nullptr) result.removed.push_back(theorem.name);
  }
  return result;
}

}  // namespace

ProveOutput::Target& ProveOutput::target(const std::filesystem::path& file) {
  const auto [place, is_new] = targets_.try_emplace(file);
  if (is_new) {
    OutputFile(file, inputs_, Targets::files);
    if (std::filesystem::exists(file)) place->second.before = read_theorems(file);
    place->second.now = place->second.before;
  }
  return place->second;
}

void ProveOutput::prepare(const std::vector<StatementSource>& statements) {
  for (const StatementSource& statement : statements) {
    if (file_of(statement.path) == statement.path) inputs_.add(statement.path);
  }
  for (const StatementSource& statement : statements) {
    const std::filesystem::path file = file_of(statement.path);
    if (file == statement.path) {
      OutputFile(certificate_of(statement.path), inputs_, Targets::files);
    } else {
      target(file);
    }
  }
}

void ProveOutput::contain(const std::filesystem::path& file, TheoremFile contents) {
  Target& its = target(file);
  its.now = std::move(contents);
  its.written = its.now.text() == its.before.text();
}

void ProveOutput::put(const std::filesystem::path& statement, const std::string& certificate) {
  const std::filesystem::path file = file_of(statement);
  if (file == statement) return write_file(certificate_of(statement), certificate, inputs_, Targets::files);
  Target& its = target(file);
  std::string& old = theorem_named(its.now, statement.stem().string()).certificate;
  its.written = its.written && old == certificate;
  old = certificate;
  if (std::chrono::steady_clock::now() - saved_ > between_saves) save();
}

void ProveOutput::save() {
  for (auto& [file, its] : targets_) {
    if (its.written) continue;
    const std::string text = its.now.text();
    if (text.empty()) std::filesystem::remove(file);
    if (!text.empty()) write_file(file, text, inputs_, Targets::files);
    its.written = true;
  }
  saved_ = std::chrono::steady_clock::now();
}

std::vector<TheoremChanges> ProveOutput::changes() const {
  std::vector<TheoremChanges> result;
  for (const auto& [file, its] : targets_) {
    if (its.now.text() != its.before.text()) result.push_back(compared(file, its.before, its.now));
  }
  return result;
}

}  // namespace slipproof::cli
