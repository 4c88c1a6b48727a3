// What every call of the C interface does: no exception leaves it, and what went wrong becomes a status and an error.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "base/input/diagnostic.hpp"
#include "faces/c_interface/slipproof.h"

namespace slipproof::c {

/// An argument that cannot be used: SLIPPROOF_BAD_ARGUMENT.
class BadArgument : public InputError {
 public:
  BadArgument(std::string argument, std::string message)
      : InputError({{std::move(argument), 0, 0, std::move(message)}}) {}
};

/// Throws BadArgument for a null pointer.
void need(const void* pointer, const char* argument);

/// The status for the exception in flight; `error`, where there is a place for one, is set to what it says.
slipproof_status status_of_exception(slipproof_error** error) noexcept;

/// Runs `body`, and turns every exception into an error.
template <class Body>
slipproof_status call(slipproof_error** error, const Body& body) noexcept {
  if (error != nullptr) *error = nullptr;
  try {
    body();
    return SLIPPROOF_OK;
  } catch (...) {
    return status_of_exception(error);
  }
}

}  // namespace slipproof::c
