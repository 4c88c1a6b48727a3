// The program: a thin shell around the library.
#include "faces/cli/program.hpp"

int main(int argc, char** argv) {
  return slipproof::cli::run_program(argc, argv);
}
