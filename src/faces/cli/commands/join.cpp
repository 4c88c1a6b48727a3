#include <iostream>
#include <memory>
#include <string>

#include "base/crew/parts.hpp"
#include "base/output/output_file.hpp"
#include "faces/cli/command.hpp"

namespace slipproof::cli {

namespace {

struct JoinArguments {
  std::string prefix, out;
};

/// Writes what the run would have printed without parts.
void put_together(const JoinArguments& options, const PartsEnd& end, const OutputFile::Sink& sink) {
  read_parts(options.prefix, end, sink);
  sink(end.out);
}

int run_join(const JoinArguments& options) {
  const PartsEnd end = read_end(options.prefix);
  if (options.out.empty()) {
    put_together(options, end, [](std::string_view) {});  // checks that everything exists before any output is written
    put_together(options, end, print);
  } else {
    Inputs inputs{parts_index(options.prefix)};
    for (const PartRange& range : end.ranges) inputs.add(options.prefix + range.part);
    OutputFile(options.out, inputs).write_by([&](const OutputFile::Sink& sink) { put_together(options, end, sink); });
  }
  std::cerr << end.err;
  return end.exit_code;
}

}  // namespace

void add_join(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<JoinArguments>();
  CLI::App& command =
      *app.add_subcommand("join", "Check the parts that certify --parts wrote, and print them as one output");
  command.add_option("PREFIX", options->prefix, "Beginning of the parts' names")->required();
  command.add_option("-o,--out", options->out, "The file to write; default: standard output");
  command.callback([options, &exit_code] { exit_code = run_join(*options); });
}

}  // namespace slipproof::cli
