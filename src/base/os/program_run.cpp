#include "base/os/program_run.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <system_error>

#include "base/os/descriptor.hpp"

extern char** environ;

namespace slipproof {

namespace {

void throw_unless_zero(int error) {
  if (error != 0) throw std::system_error(error, std::generic_category());
}

std::string read_all(int descriptor) {
  std::string text;
  std::array<char, 65536> buffer;
  for (;;) {
    const ssize_t read = ::read(descriptor, buffer.data(), buffer.size());
    if (read < 0 && errno == EINTR) continue;
    if (read <= 0) return text;
    text.append(buffer.data(), static_cast<std::size_t>(read));
  }
}

/// What the new process does with its descriptors before it becomes the program.
class Actions {
 public:
  Actions() { throw_unless_zero(posix_spawn_file_actions_init(&actions_)); }
  Actions(const Actions&) = delete;
  Actions& operator=(const Actions&) = delete;
  ~Actions() { posix_spawn_file_actions_destroy(&actions_); }

  void use(int descriptor, int as) { throw_unless_zero(posix_spawn_file_actions_adddup2(&actions_, descriptor, as)); }
  void open(const char* path, int as) {
    throw_unless_zero(posix_spawn_file_actions_addopen(&actions_, as, path, O_RDONLY, 0));
  }
  const posix_spawn_file_actions_t* get() const { return &actions_; }

 private:
  posix_spawn_file_actions_t actions_;
};

pid_t start(const std::vector<std::string>& arguments, int output) {
  Actions actions;
  actions.open("/dev/null", STDIN_FILENO);
  actions.use(output, STDOUT_FILENO);
  std::vector<std::string> copies = arguments;  // posix_spawn's arguments are not const
  std::vector<char*> pointers;
  for (std::string& argument : copies) pointers.push_back(argument.data());
  pointers.push_back(nullptr);
  pid_t process = 0;
  throw_unless_zero(posix_spawnp(&process, pointers.front(), actions.get(), nullptr, pointers.data(), environ));
  return process;
}

int exit_code_of(pid_t process) {
  int status = 0;
  while (::waitpid(process, &status, 0) < 0) {
    if (errno != EINTR) throw_unless_zero(errno);
  }
  return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
}

}  // namespace

ProgramRun run_program(const std::vector<std::string>& arguments) {
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) throw_unless_zero(errno);
  Descriptor from(ends[0]), to(ends[1]);
  const pid_t process = start(arguments, to.number());
  to = Descriptor(-1);  // or the end of what the program writes would never be seen
  ProgramRun run;
  run.output = read_all(from.number());
  run.exit_code = exit_code_of(process);
  return run;
}

}  // namespace slipproof
