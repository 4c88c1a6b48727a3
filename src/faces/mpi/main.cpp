// The program as one of many ranks.
#include <fcntl.h>
#include <unistd.h>

#include <exception>
#include <iostream>

#include "faces/cli/command.hpp"
#include "faces/cli/program.hpp"
#include "faces/mpi/mpi_transport.hpp"

namespace {

/// Ranks other than 0 print nothing.
void be_silent() {
  const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
  if (nowhere < 0) return;
  dup2(nowhere, STDOUT_FILENO);
  dup2(nowhere, STDERR_FILENO);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    slipproof::MpiTransport transport(argc, argv);
    if (transport.rank() != 0) be_silent();
    return slipproof::cli::run_program(argc, argv, transport);
  } catch (const std::exception& error) {
    std::cerr << "slipproof-mpi: " << error.what() << '\n';
    return slipproof::cli::failed;
  }
}
