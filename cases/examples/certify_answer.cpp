// Is a solver's answer the one motion? Numbers as a physics engine has them, doubles, each taken exactly as it is.
#include <iostream>
#include <slipproof/slipproof.hpp>

int main() {
  using namespace slipproof;
  const ForcedScene<double> scene{.bicycle = {.M = 94,
                                              .R = 0.3,
                                              .h = 0.56,
                                              .b2 = 0.34,
                                              .b3 = 0.68,
                                              .I1 = 0.01,
                                              .I2 = 0.12,
                                              .I3 = 0.2,
                                              .r1 = 0.09,
                                              .r2 = 0.036,
                                              .L = 0.17,
                                              .J = 15.7},
                                  .road = {.f = 0.8, .g = 9.81},
                                  .F = 300};
  const Motion<Rational> motion = motions_at(scene).motions.at(0).values;
  const auto nearest = [&](Quantity quantity) { return motion[quantity].to_double(); };
  SolverOutput answer{.a = nearest(Quantity::a),
                      .S2 = nearest(Quantity::S2),
                      .S3 = nearest(Quantity::S3),
                      .N2 = nearest(Quantity::N2),
                      .N3 = nearest(Quantity::N3)};
  std::cout << "the exact motion, rounded: " << name(judge(scene, answer).verdict) << '\n';
  answer.a = answer.a * 1.0001;
  std::cout << "a, off by 1e-4: " << name(judge(scene, answer).verdict) << '\n';
  answer.N3 = -answer.N3;
  std::cout << "the front wheel pulled down: " << name(judge(scene, answer).verdict) << '\n';
}
