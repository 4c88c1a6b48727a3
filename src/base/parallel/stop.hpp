// Lets a long call be stopped: by a signal, by the user of a window, by a time limit.
#pragma once

#include <exception>
#include <stop_token>
#include <utility>

namespace slipproof {

/// Thrown by a call of the library after a stop was requested. Files written so far are complete; the call has no
/// result.
class Stopped : public std::exception {
 public:
  const char* what() const noexcept override { return "stopped, as was asked"; }
};

/// While a scope lives, calls of the library on this thread, and their work on other threads, check the token every few
/// milliseconds and throw Stopped after a stop was requested. Scopes nest; the innermost one counts.
///   std::stop_source source;             // shared with the code that may ask: source.request_stop()
///   const StopScope scope(source.get_token());
///   verify(file, options);               // throws Stopped
/// A single call of FLINT or Eigen is not interrupted: with matrices of more than 600 unknowns it may take seconds.
class StopScope {
 public:
  explicit StopScope(std::stop_token token) : token_(std::move(token)), outer_(std::exchange(here(), &token_)) {}
  ~StopScope() { here() = outer_; }
  StopScope(const StopScope&) = delete;
  StopScope& operator=(const StopScope&) = delete;

  /// The token of this thread, to pass to threads that work for it. Without a scope, a token that never requests a
  /// stop.
  static std::stop_token token() { return here() ? *here() : std::stop_token(); }
  static bool asked() { return here() && here()->stop_requested(); }

 private:
  static const std::stop_token*& here() {
    static constinit thread_local const std::stop_token* innermost = nullptr;
    return innermost;
  }

  std::stop_token token_;
  const std::stop_token* outer_;
};

/// Throws Stopped if a stop was requested. For long loops; takes a few nanoseconds.
inline void stop_if_asked() {
  if (StopScope::asked()) throw Stopped();
}

}  // namespace slipproof
