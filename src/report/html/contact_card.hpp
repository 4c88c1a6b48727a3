// One judged answer to a contact problem, as a section of a page.
#pragma once

#include "records/problems/contact_file.hpp"
#include "report/markup/element.hpp"

namespace slipproof {

/// Adds the section; its ids begin with `answer-1`, counted from 1.
void add_contact_card(const Element& main, const JudgedProblem& problem, std::size_t answer);

/// Adds the verdict's name as a label.
Element add_contact_chip(const Element& parent, ContactVerdict verdict);

}  // namespace slipproof
