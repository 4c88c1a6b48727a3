// One of many pieces of work may fail without the others.
#pragma once

#include <exception>
#include <new>
#include <string>

#include "base/parallel/stop.hpp"

namespace slipproof {

/// A program's message about its own failure, after its name.
inline std::string failure_text(const std::string& what, const std::string& version) {
  return "the program failed: " + what +
         "\nThis is its own mistake. Please report this line, the command, its files, and the version, " + version;
}

/// Does the work, and returns what went wrong in it: empty, if nothing did. Not for what concerns all pieces: it
/// throws Stopped, and std::bad_alloc.
template <class Work>
std::string failure_of(const Work& work) {
  try {
    work();
  } catch (const Stopped&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    const std::string why = error.what();
    return why.empty() ? "failed" : why;
  }
  return {};
}

}  // namespace slipproof
