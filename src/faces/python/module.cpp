#include "faces/python/bind.hpp"

PYBIND11_MODULE(_core, module) {
  using namespace slipproof::python;
  module.doc() = "What the package slipproof calls; its functions are not meant to be called from elsewhere.";
  module.attr("version") = SLIPPROOF_VERSION;
  bind_errors(module);
  bind_calls(module);
  bind_scenes(module);
  bind_bicycles(module);
  bind_contacts(module);
  bind_exact_problems(module);
  bind_records(module);
  bind_papers(module);
  bind_pictures(module);
}
