// Runs the program as a user would, and keeps what it says.
#pragma once

#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
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

inline std::string read_file(const std::filesystem::path& path) {
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
