// Runs the program as a user would, and keeps what it says.
#pragma once

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <mutex>
#include <sstream>
#include <string>
#include <vector>

namespace slipproof::test {

inline const std::string city_bicycle = SLIPPROOF_SOURCE_DIR "/cases/city-bicycle.toml";
inline const std::string rear_drive = SLIPPROOF_SOURCE_DIR "/proofs/rear-drive/claims.toml";

struct ProgramEnd {
  int exit_code = -1;  ///< -1: ended by a signal
  std::string out, err;
};

/// Of a theorem file's text the part NAME.statement, NAME.cert or claims.canonical; empty if there is none.
inline std::string part_of(const std::string& text, const std::filesystem::path& part) {
  const std::string begin = "slipproof-", statement = "slipproof-statement 1\ntheorem " + part.stem().string() + "\n";
  const auto next = [&](std::size_t place) { return std::min(text.find("\n" + begin, place), text.size() - 1) + 1; };
  if (part == "claims.canonical") return text.starts_with("slipproof-claims ") ? text.substr(0, next(0)) : "";
  const std::size_t place = text.starts_with(statement) ? 0 : text.find("\n" + statement) + 1;
  if (place == 0 && !text.starts_with(statement)) return "";
  const std::size_t end = next(place);
  if (part.extension() == ".statement") return text.substr(place, end - place);
  const bool has_certificate = end < text.size() && text.compare(end, 21, "slipproof-statement 1") != 0;
  return has_certificate ? text.substr(end, next(end) - end) : "";
}

/// The bytes of a file, or of a part of a theorem file, FILE.theorems/NAME.cert; empty if there is none.
inline std::string read_file(const std::filesystem::path& path) {
  static std::map<std::filesystem::path, std::string> shipped;  // theorem files, which are long
  const std::filesystem::path whole = path.parent_path();
  if (whole.extension() == ".theorems" && std::filesystem::is_regular_file(whole)) {
    if (!whole.string().starts_with(SLIPPROOF_SOURCE_DIR "/proofs/")) return part_of(read_file(whole), path.filename());
    static std::mutex mutex;
    const std::scoped_lock lock(mutex);
    const auto [place, is_new] = shipped.try_emplace(whole);
    if (is_new) place->second = read_file(whole);
    return part_of(place->second, path.filename());
  }
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/// A folder of this process's own, removed at its end.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "slipproof-test-XXXXXX").string();
    if (mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("no temporary folder");
    path_ = pattern;
  }
  ~TemporaryFolder() { std::filesystem::remove_all(path_); }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path write(const std::string& name, const std::string& text) const {
    std::ofstream(path_ / name, std::ios::binary) << text;
    return path_ / name;
  }

 private:
  std::filesystem::path path_;
};

inline std::string quoted(const std::string& word) {
  std::string result = "'";
  for (const char c : word) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return result + "'";
}

/// Runs build/PROGRAM with arguments as a shell reads them, and a text on standard input.
inline ProgramEnd run_shell(const std::string& arguments, const std::string& program = "slipproof",
                            const std::string& input = "") {
  const TemporaryFolder folder;
  const std::filesystem::path in = folder.write("in", input);
  std::string command = quoted(std::string(SLIPPROOF_BINARY_DIR) + "/" + program) + " " + arguments;
  command += " <" + quoted(in.string()) + " >" + quoted((folder.path() / "out").string()) + " 2>" +
             quoted((folder.path() / "err").string());
  const int status = std::system(command.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read_file(folder.path() / "out"),
          read_file(folder.path() / "err")};
}

inline ProgramEnd run(const std::vector<std::string>& arguments, const std::string& program = "slipproof",
                      const std::string& input = "") {
  std::string words;
  for (const std::string& argument : arguments) words += quoted(argument) + " ";
  return run_shell(words, program, input);
}

inline std::string last_line(const std::string& out) {
  return out.substr(out.rfind('\n', out.size() - 2) + 1);
}

}  // namespace slipproof::test
