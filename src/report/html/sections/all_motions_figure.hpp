// The picture of all motions of a contact problem in space.
#pragma once

#include <string>

#include "records/problems/contact_file.hpp"
#include "report/markup/element.hpp"

namespace slipproof {

/// With its legend, and its data as a table; adds nothing where `motion_cones` has nothing. `id` is that of the answer.
void add_all_motions_figure(const Element& parent, const JudgedProblem& problem, std::size_t answer,
                            const std::string& id);

}  // namespace slipproof
