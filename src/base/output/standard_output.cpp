#include "base/output/standard_output.hpp"

#include <unistd.h>

#include "base/os/descriptor.hpp"
#include "base/output/output_error.hpp"

namespace slipproof {

void write_standard_output(std::string_view text) {
  if (const int error = write_all(STDOUT_FILENO, text)) throw OutputError("standard output", error);
}

}  // namespace slipproof
