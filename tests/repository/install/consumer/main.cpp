#include <iostream>
#include <slipproof/slipproof.hpp>

int main() {
  using slipproof::Rational;
  const Rational R(1, 3), r1(2), r2(1), L(1, 6);
  const std::string sigma = Rational(r2 * L / (r1 * R)).str();
  std::cout << to_string(slipproof::Diagnostic{"scene.toml", 3, 7, "sigma is " + sigma}) << '\n';
}
