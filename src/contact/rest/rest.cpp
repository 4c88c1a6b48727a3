#include "contact/rest/rest.hpp"

#include <utility>

namespace slipproof {

namespace {

/// At the scene's load, or at any.
void decide(RestAnswer& answer, RestSolver& solver) {
  if (answer.push) {
    answer.decision = solver.decide(*answer.push);
  } else if (answer.loads && answer.loads->decided) {
    answer.decision.can = !answer.loads->none;
  }
}

}  // namespace

RestAnswer find_rest(MechanismScene scene, const RestQuestions& questions) {
  const RestProblemMaker maker(scene.mechanism);
  RestAnswer answer;
  answer.problem = maker.problem(scene);
  if (!answer.problem.load || scene.load) {
    answer.push = push_at(answer.problem, scene.load ? *scene.load : Rational(0));
  }
  const auto with_effort = [&](const auto& ask) {
    Effort effort(questions.effort);
    try {
      ask(effort);
    } catch (const TooMuchWork&) {
      return false;
    }
    return true;
  };
  with_effort([&](Effort& effort) {
    RestSolver solver(answer.problem, effort);
    if (!answer.push) {
      answer.loads = solver.loads(push_at(answer.problem, Rational(0)), push_at(answer.problem, std::nullopt), false);
    }
    decide(answer, solver);
    answer.programs += solver.programs();
  });
  if (questions.only_whether) {
    answer.scene = std::move(scene);
    return answer;
  }
  if (answer.push && answer.problem.load) {
    with_effort([&](Effort& effort) {
      RestSolver solver(answer.problem, effort);
      answer.loads = solver.loads(push_at(answer.problem, Rational(0)), push_at(answer.problem, std::nullopt), false);
      answer.programs += solver.programs();
    });
  }
  if (questions.tilt) {
    with_effort([&](Effort& effort) {
      answer.tilt = rest_under_tilt(scene, maker, answer.problem, *questions.tilt, effort, answer.programs);
    });
  }
  if (!questions.parameter.empty()) {
    with_effort([&](Effort& effort) {
      answer.parameter = rest_along(scene, maker, questions.parameter, effort, answer.programs);
    });
  }
  if (questions.map) {
    with_effort([&](Effort& effort) { answer.map = rest_map(scene, *questions.map, effort, answer.programs); });
  }
  if (answer.push) {
    const bool ended = with_effort([&](Effort& effort) {
      answer.must = must_rest(scene, answer.problem, *answer.push, answer.decision, effort, answer.programs);
    });
    if (!ended) answer.must = {std::nullopt, "the effort was not enough", nullptr, nullptr};
  } else {
    answer.must.because = "the load has no value";
  }
  answer.scene = std::move(scene);
  return answer;
}

}  // namespace slipproof
