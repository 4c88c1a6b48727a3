#include "report/html/headline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>
#include <vector>

#include "mechanics/mechanism/words.hpp"
#include "report/papers/explain.hpp"
#include "report/picture/motions_svg.hpp"

namespace slipproof {

namespace {

/// Smaller is worse: what is false comes first.
int order(const Claim& claim) {
  constexpr std::array<int, 4> of_grade{3, 1, 2, 0};  // misprint, gap, boundary, wrong
  return claim.grade ? of_grade.at(static_cast<std::size_t>(*claim.grade)) : 0;
}

bool can_be_drawn(const Claim& claim, const ClaimResult& result) {
  const auto& e = result.counterexample;
  return e && is_about_motions(claim) && e->motions && !e->motions->motions.empty() && has_picture(e->scene.mechanism);
}

constexpr std::string_view arxiv = "arXiv:";

/// How long the name is that a link of this kind begins with, as `2105.00851`.
std::size_t name_length(std::string_view text) {
  std::size_t length = 0;
  const auto part_of_it = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '.' || c == '/' || c == '-';
  };
  while (length < text.size() && part_of_it(text[length])) ++length;
  while (length > 0 && text[length - 1] == '.') --length;  // the end of the sentence
  return length;
}

}  // namespace

const ClaimResult* worst_refuted(const ClaimsFile& file, const VerifyResult& result) {
  const ClaimResult* worst = nullptr;
  std::pair<int, int> least;
  for (const ClaimResult& claim : result.claims) {
    const Claim& stated = file.claims[claim.claim];
    if (claim.reading != Reading::printed || claim.verdict != Verdict::refuted || !can_be_drawn(stated, claim))
      continue;
    const std::pair here{order(stated), -static_cast<int>(claim.counterexample->motions->motions.size())};
    if (worst == nullptr || here < least) worst = &claim, least = here;
  }
  return worst;
}

void add_motion(const Element& row, const MechanismScene& scene, const MotionAtLoad& motion, const CommonLook& look) {
  const std::string modes = equal_modes(motion.all_modes());
  const Element box = row.add("div", "motion");
  const Element heading = box.add("p", "motion-name");
  heading.add("b").text(modes);
  if (!motion.strict()) heading.text(" (boundary)");
  if (!has_picture(scene.mechanism)) return;
  box.set("tabindex", 0).set("role", "group").set("aria-label", modes);  // it scrolls where the page is narrow
  LabelBox seen;
  add_mechanism(box, scene, &motion, "The motion " + modes + ", with its forces", look, &seen)
      .set("style", fmt::format("--natural-width:{:.0f}px", seen.right - seen.left));
}

void add_worst_motions(const Element& parent, const ClaimResult& worst) {
  const Counterexample& e = *worst.counterexample;
  const CommonLook look = common_look(e.scene, e.motions->motions);
  const Element row = parent.add("div", "motions");
  for (const MotionAtLoad& motion : e.motions->motions) add_motion(row, e.scene, motion, look);
}

std::string worst_motions_svg(const ClaimResult& worst) {
  return motions_svg_file(worst.counterexample->scene, *worst.counterexample->motions);
}

Reference find_reference(std::string_view text) {
  constexpr std::array<std::array<std::string_view, 2>, 2> places{
      {{arxiv, "https://arxiv.org/abs/"}, {"doi:", "https://doi.org/"}}};
  Reference first{text.size(), {}, {}};
  for (const auto& [before, site] : places) {
    for (std::size_t at = text.find(before); at < first.begin; at = text.find(before, at + 1)) {
      const std::size_t from = at + before.size(), length = name_length(text.substr(from));
      if (length == 0) continue;
      first = {at, text.substr(at, before.size() + length), std::string(site).append(text.substr(from, length))};
    }
  }
  return first;
}

void add_reference(const Element& parent, std::string_view reference) {
  while (!reference.empty()) {
    const Reference found = find_reference(reference);
    parent.text(reference.substr(0, found.begin));
    reference.remove_prefix(found.begin + found.text.size());
    if (found.text.empty()) continue;
    parent.add("a").set("href", found.address).text(found.text);
    if (!found.text.starts_with(arxiv)) continue;
    const std::string name(found.text.substr(arxiv.size()));
    parent.text(" (");
    parent.add("a").set("href", "https://doi.org/10.48550/arXiv." + name).text("DOI");
    parent.text(")");
  }
}

std::string_view kind_of_source(const ClaimsFile& file) {
  return file.paper.reference.empty() ? "source" : "paper";
}

}  // namespace slipproof
