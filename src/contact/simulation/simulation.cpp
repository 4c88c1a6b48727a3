#include "contact/simulation/simulation.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

#include "base/parallel/in_parallel.hpp"

namespace slipproof {

namespace {

double distance(const std::vector<double>& x, const std::vector<double>& y) {
  double sum = 0;
  for (std::size_t i = 0; i < x.size(); ++i) sum += (x[i] - y[i]) * (x[i] - y[i]);
  return std::sqrt(sum);
}

/// How many steps were in which mode.
class ModeCounts {
 public:
  void add(const ProblemMode& mode) {
    if (!last_ || last_->first != mode) last_ = &*counts_.try_emplace(mode).first;
    ++last_->second;
  }
  const std::pair<const ProblemMode, std::size_t>& most() const {
    return *std::max_element(counts_.begin(), counts_.end(),
                             [](const auto& x, const auto& y) { return x.second < y.second; });
  }

 private:
  std::map<ProblemMode, std::size_t> counts_;
  std::pair<const ProblemMode, std::size_t>* last_ = nullptr;
};

/// From now on until `end` periods.
SeenMotion watch(CompliantMotion& motion, double end) {
  SeenMotion seen;
  const double from = motion.time();
  const std::vector<double> before = motion.velocity();
  seen.forces.resize(before.size());
  ModeCounts counts;
  std::size_t steps = 0;
  for (; motion.periods() < end; ++steps) {
    motion.advance();
    counts.add(motion.mode());
    for (std::size_t i = 0; i < before.size(); ++i) seen.forces[i] += motion.forces()[i];
  }
  for (std::size_t i = 0; i < before.size(); ++i) {
    seen.forces[i] /= static_cast<double>(steps);
    seen.accelerations.push_back((motion.velocity()[i] - before[i]) / (motion.time() - from));
  }
  seen.mode = counts.most().first;
  seen.share = static_cast<double>(counts.most().second) / static_cast<double>(steps);
  return seen;
}

SimulatedRun run(const LoadedContacts& contacts, const ContactSolutions& exact, const Compliance& compliance) {
  SimulatedRun result{compliance, {}};
  CompliantMotion motion(contacts, compliance);
  for (const double horizon : horizons) {
    while (motion.periods() < compliance.rise + horizon / 2) motion.advance();
    SeenMotion& seen = result.seen.emplace_back(watch(motion, compliance.rise + horizon));
    seen.periods = horizon;
    seen.motion = motion_close_to(seen.accelerations, contacts.problem, exact);
  }
  return result;
}

}  // namespace

std::optional<std::size_t> motion_close_to(const std::vector<double>& accelerations, const ContactProblem& problem,
                                           const ContactSolutions& exact) {
  std::vector<std::vector<double>> motions;
  for (const ContactSolution& solution : exact.solutions) motions.push_back(rounded(solution.w));
  for (std::size_t i = 0; i < motions.size(); ++i) {
    double scale = distance(rounded(problem.q), std::vector<double>(problem.size()));
    for (std::size_t j = 0; j < motions.size(); ++j) {
      if (j != i) scale = std::min(scale, distance(motions[i], motions[j]));
    }
    if (distance(accelerations, motions[i]) <= scale / 100) return i;
  }
  return std::nullopt;
}

Simulation simulate(LoadedContacts contacts, const std::vector<Compliance>& compliances, unsigned threads) {
  const std::string mistake = mistake_in(contacts.problem);
  if (!mistake.empty()) throw std::invalid_argument(mistake);
  auto exact = ContactSolver(contacts.problem).all();
  if (!exact) throw std::invalid_argument("found more contact modes than are tried, expected fewer contacts");
  Simulation result{std::move(contacts), std::move(*exact), std::vector<SimulatedRun>(compliances.size())};
  on_threads(threads, [&] {
    each_in_parallel(0, compliances.size(),
                     [&](std::size_t i) { result.runs[i] = run(result.contacts, result.exact, compliances[i]); });
  });
  return result;
}

}  // namespace slipproof
