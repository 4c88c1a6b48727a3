// Lets a long call be stopped: by a signal, by the user of a window, by a time limit.
#pragma once

#include <exception>
#include <stop_token>
#include <utility>

namespace slipproof {

/// Thrown out of a call that was asked to end. What it wrote so far is whole; its result is not there.
class Stopped : public std::exception {
 public:
  const char* what() const noexcept override { return "stopped, as was asked"; }
};

/// While it lives, calls of the library on this thread, and their work on other threads, look at the token every few
/// milliseconds and end with Stopped once it is asked for. Scopes nest; the innermost counts.
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

  /// The token of this thread, to pass to the threads that work for it; without a scope, one that is never asked to
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

/// Long loops call this; it takes a few nanoseconds unless a stop was asked for.
inline void stop_if_asked() {
  if (StopScope::asked()) throw Stopped();
}

}  // namespace slipproof
