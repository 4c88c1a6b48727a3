// A small problem in FCLIB's form, as it is and changed.
#pragma once

#include <functional>

#include "support/files/hdf5_writer.hpp"

#ifdef SLIPPROOF_HDF5

namespace slipproof::test {

/// W = ((4, 3), (0, 5)), as rows.
inline void write_local(const Hdf5Writer& out) {
  out.group("/fclib_local");
  out.integers("/fclib_local/spacedim", {2});
  out.matrix("/fclib_local/W", 2, 2, -2, {0, 1, 1}, {0, 2, 3}, {4, 3, 5});
  out.group("/fclib_local/vectors");
  out.reals("/fclib_local/vectors/q", {-1, 2});
  out.reals("/fclib_local/vectors/mu", {0.5});
}

using Write = std::function<void(const Hdf5Writer&)>;

inline std::string written(
    const Folder& folder, const Write& write, const Write& change = [](const Hdf5Writer&) {}) {
  const Hdf5Writer out(folder.path("p.hdf5"));
  write(out);
  change(out);
  return folder.path("p.hdf5");
}

inline void write_solution(const Hdf5Writer& out, const Numbers& r, const Numbers& u) {
  out.group("/solution");
  out.reals("/solution/r", r);
  out.reals("/solution/u", u);
}

}  // namespace slipproof::test

#endif
