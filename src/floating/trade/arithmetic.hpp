// The number types, each as a solver of scenes behind one face. Each has a source file of its own: over one number
// type the modes are much code already.
#pragma once

#include <memory>

#include "floating/trade/trade.hpp"
#include "floating/trade/truth.hpp"

namespace slipproof {

class Arithmetic {
 public:
  struct Answer {
    std::uint16_t consistent = 0;
    std::optional<std::uint16_t> strict;  ///< where the type tells it
    bool decided = true;                  ///< by the first tier, where there are several
    std::optional<Tier> tier;             ///< where there are several
  };

  explicit Arithmetic(TradeType type) : type_(std::move(type)) {}
  virtual ~Arithmetic() = default;
  Arithmetic(const Arithmetic&) = delete;
  Arithmetic& operator=(const Arithmetic&) = delete;

  const TradeType& type() const { return type_; }
  /// Brings the scenes into the type, in place of those from before. They must outlive their use.
  virtual void load(const std::vector<ForcedScene<Rational>>& scenes) = 0;
  virtual Answer answer(std::size_t scene) const = 0;
  /// The motion of a mode, exactly as computed; no value where NaN or an infinity came out.
  virtual JudgedValues<std::optional<Rational>> motion(std::size_t scene, ContactMode mode) const = 0;
  /// What is timed: the consistent modes of every scene, once. The sum keeps it from being left out.
  virtual unsigned run() const = 0;

 private:
  TradeType type_;
};

std::unique_ptr<Arithmetic> binary32_arithmetic();
std::unique_ptr<Arithmetic> binary64_arithmetic();
std::unique_ptr<Arithmetic> long_double_arithmetic();
std::unique_ptr<Arithmetic> binary128_arithmetic();
std::unique_ptr<Arithmetic> mpfr50_arithmetic();
std::unique_ptr<Arithmetic> mpfr100_arithmetic();
std::unique_ptr<Arithmetic> mpfr200_arithmetic();
std::unique_ptr<Arithmetic> filter_arithmetic();
std::unique_ptr<Arithmetic> exact_arithmetic();

/// All of them, in this order.
std::vector<std::unique_ptr<Arithmetic>> all_arithmetics();

}  // namespace slipproof
