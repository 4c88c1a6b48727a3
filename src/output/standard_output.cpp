#include "output/standard_output.hpp"

#include <unistd.h>

#include "output/output_error.hpp"
#include "system/descriptor.hpp"

namespace slipproof {

void write_standard_output(std::string_view text) {
  if (const int error = write_all(STDOUT_FILENO, text)) throw OutputError("standard output", error);
}

}  // namespace slipproof
