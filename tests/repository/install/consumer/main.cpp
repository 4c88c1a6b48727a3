#include <iostream>
#include <slipproof/slipproof.hpp>

int main() {
  slipproof::Bicycle<slipproof::Rational> bicycle;
  bicycle.R = slipproof::Rational(1, 3);
  bicycle.r1 = 2;
  bicycle.r2 = 1;
  bicycle.L = slipproof::Rational(1, 6);
  std::cout << to_string(slipproof::Diagnostic{"scene.toml", 3, 7, "sigma is " + sigma(bicycle).str()}) << '\n';
}
