#include "report/html/headline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>
#include <vector>

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

void add_worst_motions(const Element& parent, const ClaimResult& worst) {
  const Counterexample& e = *worst.counterexample;
  const CommonLook look = common_look(e.scene, e.motions->motions);
  const Element row = parent.add("div", "motions");
  for (const MotionAtLoad& motion : e.motions->motions) {
    const std::string modes = modes_text(motion);
    const Element box = row.add("div", "motion").set("tabindex", 0).set("role", "group").set("aria-label", modes);
    box.add("p", "motion-name").add("b").text(modes);
    LabelBox seen;
    add_mechanism(box, e.scene, &motion, "The motion " + modes + ", with its forces", look, &seen)
        .set("style", fmt::format("--natural-width:{:.0f}px", seen.right - seen.left));
  }
}

std::string worst_motions_svg(const ClaimResult& worst) {
  return motions_svg_file(worst.counterexample->scene, *worst.counterexample->motions);
}

void add_reference(const Element& parent, std::string_view reference) {
  struct Place {
    std::string_view before, address;
  };
  constexpr std::array<Place, 2> places{{{"arXiv:", "https://arxiv.org/abs/"}, {"doi:", "https://doi.org/"}}};
  while (!reference.empty()) {
    std::size_t first = reference.npos;
    const Place* place = nullptr;
    for (const Place& one : places) {
      const std::size_t at = reference.find(one.before);
      if (at < first) first = at, place = &one;
    }
    parent.text(reference.substr(0, first));
    if (place == nullptr) return;
    const std::string_view from = reference.substr(first);
    const std::size_t length = name_length(from.substr(place->before.size()));
    const std::string name(from.substr(place->before.size(), length));
    const std::string_view shown = from.substr(0, place->before.size() + length);
    if (length == 0) {
      parent.text(shown);
    } else {
      parent.add("a").set("href", std::string(place->address) + name).text(shown);
      if (place == places.begin()) {
        parent.text(" (");
        parent.add("a").set("href", "https://doi.org/10.48550/arXiv." + name).text("DOI");
        parent.text(")");
      }
    }
    reference = from.substr(shown.size());
  }
}

std::string_view kind_of_source(const ClaimsFile& file) {
  return file.paper.reference.empty() ? "source" : "paper";
}

}  // namespace slipproof
