#include "report/planes/cone_disc.hpp"

#include <algorithm>
#include <cmath>

namespace slipproof {

namespace {

std::vector<std::size_t> worst_contacts(const Residual& residual) {
  std::vector<std::size_t> contacts;
  for (const Violation& violation : residual.worst) {
    if (violation.contact) contacts.push_back(*violation.contact);
  }
  std::sort(contacts.begin(), contacts.end());
  contacts.erase(std::unique(contacts.begin(), contacts.end()), contacts.end());
  return contacts;
}

/// The marked points and at most `most` others, evenly spaced in the list.
std::vector<ConePoint> thinned(const std::vector<ConePoint>& points, std::size_t most) {
  if (points.size() <= most) return points;
  std::vector<ConePoint> kept;
  std::size_t taken = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool in_turn = (i + 1) * most / points.size() > taken;
    if (in_turn) ++taken;
    if (in_turn || points[i].marked) kept.push_back(points[i]);
  }
  return kept;
}

}  // namespace

double in_cone(double tangential, double mu, double normal) {
  constexpr double far = 1e100;
  return std::clamp(tangential / normal / mu, -far, far);
}

ConeDisc cone_disc(const MixedProblem& problem, const ContactJudgement& judgement, std::size_t most) {
  // The forces of the other laws are in the cone.
  const bool pyramid = judgement.law == FrictionLaw::box || judgement.law == FrictionLaw::diamond;
  ConeDisc disc{problem.dimension,
                problem.contacts(),
                pyramid ? judgement.law : FrictionLaw::cone,
                judgement.right_for,
                {},
                0,
                {},
                {}};
  const std::vector<std::size_t> worst = worst_contacts(*judgement.residual);
  const auto& x = judgement.x;
  std::vector<ConePoint> points;
  double largest = 0;
  for (std::size_t k = 0; k < problem.contacts(); ++k) {
    const ContactFit fit = judgement.residual->contacts[k].fit;
    const std::size_t first = problem.normal(k);
    const bool open = fit == ContactFit::open || !(x[first] > 0);
    const bool smooth = !open && (problem.dimension == 1 || problem.mu[k] == 0);
    const bool marked = std::binary_search(worst.begin(), worst.end(), k);
    ++(open                       ? disc.counts.open
       : smooth                   ? disc.counts.smooth
       : fit == ContactFit::slide ? disc.counts.slide
                                  : disc.counts.stick);
    if (open || smooth) {
      if (marked) disc.unplaced.push_back(k);
      continue;
    }
    ConePoint point{k, {}, x[first], fit == ContactFit::slide, marked};
    for (std::size_t i = 1; i < problem.dimension; ++i)
      point.at[i - 1] = in_cone(x[first + i], problem.mu[k], x[first]);
    largest = std::max(largest, point.size);
    points.push_back(point);
  }
  disc.placed = points.size();
  disc.points = thinned(points, most);
  for (ConePoint& point : disc.points) point.size /= largest;
  return disc;
}

}  // namespace slipproof
