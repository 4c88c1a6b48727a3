// The program: a thin shell around the library.
#include <CLI/CLI.hpp>

namespace {

constexpr int exit_usage = 2;

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Exact, provable answers about dry friction", "slipproof");
  app.set_version_flag("--version", "slipproof " SLIPPROOF_VERSION);
  app.require_subcommand(1);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : exit_usage;
  }
  return 0;
}
