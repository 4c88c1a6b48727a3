// The parts of the extension module slipproof._core. They are thin: the Python files in this folder define the public
// interface, and the library computes.
#pragma once

#include <pybind11/pybind11.h>

#include <optional>
#include <string>

#include "mechanics/mechanism/mechanism.hpp"

namespace slipproof::python {

/// The mechanism of a text, which messages call `name`, or without one that of a file or a shipped one. Throws
/// InputError, also for one in other dimensions, or without bodies for an impact.
Mechanism mechanism_of(const std::string& name, const std::optional<std::string>& text,
                       const MechanismRequest& request = Dimensions::plane);

void bind_errors(pybind11::module_& module);
void bind_calls(pybind11::module_& module);
void bind_scenes(pybind11::module_& module);
void bind_bicycles(pybind11::module_& module);
void bind_contacts(pybind11::module_& module);
void bind_exact_problems(pybind11::module_& module);
void bind_records(pybind11::module_& module);
void bind_papers(pybind11::module_& module);
void bind_pictures(pybind11::module_& module);

}  // namespace slipproof::python
