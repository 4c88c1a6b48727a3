#include <memory>
#include <new>

#include "base/number/parse.hpp"
#include "base/parallel/failure.hpp"
#include "faces/c_interface/call.hpp"
#include "mechanics/points/problem.hpp"

/// Diagnostics, and the parts of their messages as separate texts.
struct slipproof_error {
  struct Mistake {
    std::string place, found, expected, message;
    std::size_t line, column;
  };
  std::vector<Mistake> mistakes;
  std::string message;
};

namespace slipproof::c {

namespace {

std::unique_ptr<slipproof_error> error_of(const std::vector<Diagnostic>& diagnostics) {
  auto error = std::make_unique<slipproof_error>();
  for (const Diagnostic& d : diagnostics) {
    const auto [found, expected] = found_and_expected(d.message);
    error->mistakes.push_back({d.file, std::string(found), std::string(expected), to_string(d), d.line, d.column});
    error->message += (error->message.empty() ? "" : "\n") + error->mistakes.back().message;
  }
  return error;
}

slipproof_status tell(slipproof_error** error, slipproof_status status, const std::vector<Diagnostic>& diagnostics) {
  if (error != nullptr) *error = error_of(diagnostics).release();
  return status;
}

slipproof_status tell_exception(slipproof_error** error) {
  try {
    throw;
  } catch (const BadArgument& bad) {
    return tell(error, SLIPPROOF_BAD_ARGUMENT, bad.diagnostics());
  } catch (const InputError& bad) {
    return tell(error, SLIPPROOF_BAD_INPUT, bad.diagnostics());
  } catch (const NumberError& bad) {
    return tell(error, SLIPPROOF_BAD_INPUT, {{"", 0, 0, bad.what()}});
  } catch (const std::bad_alloc&) {
    return SLIPPROOF_NO_MEMORY;
  } catch (const std::exception& other) {
    return tell(error, SLIPPROOF_FAILED, {{"", 0, 0, failure_text(other.what(), SLIPPROOF_VERSION)}});
  } catch (...) {
    return tell(error, SLIPPROOF_FAILED, {{"", 0, 0, failure_text("an unknown exception", SLIPPROOF_VERSION)}});
  }
}

}  // namespace

void need(const void* pointer, const char* argument) {
  if (pointer == nullptr) throw BadArgument(argument, "found NULL, expected a pointer");
}

slipproof_status status_of_exception(slipproof_error** error) noexcept {
  try {
    return tell_exception(error);
  } catch (...) {  // even the message could not be written
    return SLIPPROOF_NO_MEMORY;
  }
}

}  // namespace slipproof::c

const char* slipproof_version(void) {
  return SLIPPROOF_VERSION;
}

size_t slipproof_error_count(const slipproof_error* error) {
  return error == nullptr ? 0 : error->mistakes.size();
}

slipproof_mistake slipproof_error_mistake(const slipproof_error* error, size_t index) {
  if (index >= slipproof_error_count(error)) return {"", 0, 0, "", "", ""};
  const auto& m = error->mistakes[index];
  return {m.place.c_str(), m.line, m.column, m.found.c_str(), m.expected.c_str(), m.message.c_str()};
}

const char* slipproof_error_message(const slipproof_error* error) {
  return error == nullptr ? "" : error->message.c_str();
}

void slipproof_error_free(slipproof_error* error) {
  delete error;
}
