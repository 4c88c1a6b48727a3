// What a reader sees first of a paper: the worst finding with its picture, and where the paper can be read.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "claims/verify/verify.hpp"
#include "report/markup/element.hpp"
#include "report/picture/mechanism_svg.hpp"

namespace slipproof {

/// The claim that shows the worst finding: of the claims that are refuted before any repair, with motions that can be
/// drawn, the one with the worst grade, then with the most motions, then the first. Null if there is none.
const ClaimResult* worst_refuted(const ClaimsFile& file, const VerifyResult& result);

/// Adds a motion with its forces, if the mechanism has a picture, at the size at which all letters can be read.
void add_motion(const Element& row, const MechanismScene& scene, const MotionAtLoad& motion, const CommonLook& look);

/// Draws the motions of its counterexample side by side. Needs picture_style() in the page.
void add_worst_motions(const Element& parent, const ClaimResult& worst);

/// The same as an SVG file of its own.
std::string worst_motions_svg(const ClaimResult& worst);

/// A reference in a text, as `arXiv:2105.00851` or `doi:10.1000/182`, where it begins, and its address.
struct Reference {
  std::size_t begin = 0;
  std::string_view text;
  std::string address;
};

/// The first reference; if there is none, its text and address are empty, and it begins at the end.
Reference find_reference(std::string_view text);

/// Adds a reference; `arXiv:2105.00851` and `doi:10.1000/182` in it are links, the first with its DOI.
void add_reference(const Element& parent, std::string_view reference);

/// `paper` where the file names where it was published, otherwise `source`: what textbooks share.
std::string_view kind_of_source(const ClaimsFile& file);

}  // namespace slipproof
