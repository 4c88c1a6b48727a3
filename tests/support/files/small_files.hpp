// Files that a test writes, and what the readers say of them.
#pragma once

#include <doctest/doctest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "base/input/diagnostic.hpp"
#include "contact/formats/read_files.hpp"

namespace slipproof::test {

/// A folder that is gone at the end.
class Folder {
 public:
  Folder() {
    std::string name = std::filesystem::temp_directory_path() / "slipproof-test-XXXXXX";
    REQUIRE(mkdtemp(name.data()) != nullptr);
    path_ = name;
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() { std::filesystem::remove_all(path_); }

  std::string path(const std::string& name) const { return path_ / name; }
  std::string write(const std::string& name, const std::string& content) const {
    std::ofstream(path(name), std::ios::binary) << content;
    return path(name);
  }

 private:
  std::filesystem::path path_;
};

/// What a call refuses, with `path` as FILE; "" if nothing.
inline std::string refusal(const std::function<void()>& call, const std::string& path) {
  try {
    call();
  } catch (const InputError& error) {
    std::string text = error.what();
    for (std::size_t at = 0; (at = text.find(path)) != std::string::npos;) text.replace(at, path.size(), "FILE");
    return text;
  }
  return "";
}

inline std::string problem_refusal(const std::string& path) {
  return refusal([&] { read_problem_file(path); }, path);
}

inline std::string answer_refusal(const std::string& path) {
  return refusal([&] { read_answer_file(path); }, path);
}

/// A malformed file and the start of what is said of it.
struct Malformed {
  std::string content, message;
};

inline void check_refusals(const std::vector<Malformed>& files, const std::string& name,
                           std::string (*refusal_of)(const std::string&)) {
  const Folder folder;
  for (const Malformed& file : files) {
    CAPTURE(file.content);
    const std::string said = refusal_of(folder.write(name, file.content));
    CHECK_MESSAGE(said.starts_with(file.message), said);
    CHECK_FALSE(said.empty());
  }
}

using Entries = std::map<std::pair<std::size_t, std::size_t>, double>;

/// Those that are not 0.
inline Entries entries_of(const SparseMatrix& matrix) {
  Entries result;
  for (std::size_t i = 0; i < matrix.rows; ++i) {
    for (std::size_t k = matrix.starts[i]; k < matrix.starts[i + 1]; ++k) {
      if (matrix.value[k] != 0) result[{i, matrix.column[k]}] = matrix.value[k];
    }
  }
  return result;
}

/// Rows one after the other.
inline std::vector<double> dense(const SparseMatrix& matrix) {
  std::vector<double> result(matrix.rows * matrix.columns);
  for (const auto& [place, value] : entries_of(matrix)) result[place.first * matrix.columns + place.second] = value;
  return result;
}

using Numbers = std::vector<double>;

}  // namespace slipproof::test
