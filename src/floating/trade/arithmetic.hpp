// The number types, each as a solver of scenes with the same interface.
#pragma once

#include <memory>
#include <utility>

#include "floating/trade/workload.hpp"

namespace slipproof {

/// For one thread only.
class Arithmetic {
 public:
  explicit Arithmetic(TradeType type) : type_(std::move(type)) {}
  virtual ~Arithmetic() = default;
  Arithmetic(const Arithmetic&) = delete;
  Arithmetic& operator=(const Arithmetic&) = delete;

  const TradeType& type() const { return type_; }
  /// Converts the scenes to the type; they replace earlier ones. The workload must outlive their use.
  virtual void load(const Workload& workload) = 0;
  /// The timed part: decides all modes of each scene. Unsure: NaN or a division by 0 occurred.
  virtual std::vector<ModeAt> decide() = 0;
  /// The tier that decided a scene last, if the type has several tiers. A type without tiers does not report strict
  /// modes.
  virtual std::optional<Tier> tier(std::size_t) const { return std::nullopt; }
  /// The quantities in the only consistent mode, exactly as computed; nothing if NaN or an infinity occurred.
  virtual std::optional<JudgedValues<Rational>> motion(std::size_t scene, std::size_t mode) = 0;

 private:
  TradeType type_;
};

using Arithmetics = std::vector<std::unique_ptr<Arithmetic>>;

/// Floating point as it is commonly used: every result is trusted.
void add_plain_arithmetics(Arithmetics& all);
/// The filter and the exact kernel: both are never wrong.
void add_sound_arithmetics(Arithmetics& all);

/// All number types, in this order.
inline Arithmetics all_arithmetics() {
  Arithmetics all;
  add_plain_arithmetics(all);
  add_sound_arithmetics(all);
  return all;
}

}  // namespace slipproof
