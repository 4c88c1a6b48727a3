#include "floating/trade/arithmetic.hpp"

namespace slipproof {

namespace {

class ExactArithmetic : public Arithmetic {
 public:
  ExactArithmetic() : Arithmetic({"exact", 0}) {}

  void load(const std::vector<ForcedScene<Rational>>& scenes) override { scenes_ = &scenes; }

  Answer answer(std::size_t scene) const override {
    const ConsistentModes found = exact_modes((*scenes_)[scene]);
    return {found.consistent, found.strict, true, Tier::exact};
  }

  JudgedValues<std::optional<Rational>> motion(std::size_t scene, ContactMode mode) const override {
    const auto exact = exact_values((*scenes_)[scene], mode);
    JudgedValues<std::optional<Rational>> values;
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = exact[i];
    return values;
  }

  unsigned run() const override {
    unsigned seen = 0;
    for (const auto& s : *scenes_) seen += exact_modes(s).consistent;
    return seen;
  }

 private:
  const std::vector<ForcedScene<Rational>>* scenes_ = nullptr;
};

}  // namespace

std::unique_ptr<Arithmetic> exact_arithmetic() {
  return std::make_unique<ExactArithmetic>();
}

}  // namespace slipproof
