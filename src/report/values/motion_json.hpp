// Motions, continua and rejected modes as JSON.
#pragma once

#include "mechanics/bicycle/chain.hpp"
#include "mechanics/bicycle_modes/motions.hpp"
#include "report/values/exact_json.hpp"

namespace slipproof {

Json mode_names(const std::vector<ContactMode>& modes);
Json continuum_json(const Continuum& continuum);

/// "motions", "continua" and "rejected" of a scene at its force; with `chain`, also eps1 and T of each motion.
void put_motions(Json& document, const MotionsAtForce& found, const Scene& scene, bool chain = false);

/// V is Rational at one force, Affine<Rational> over a cell.
template <class V>
Json motion_json(const FoundMotion<V>& found, const Bicycle<Rational>& bicycle, const V& F, bool chain) {
  Json object;
  object["modes"] = mode_names(found.modes);
  object["status"] = found.strict ? "strict" : "boundary";
  for (const Quantity q : all_quantities()) object[std::string(name(q))] = to_json(found.values[q]);
  if (chain) {
    const Chain<V> values = chain_of(bicycle, found.values, F);
    object["eps1"] = to_json(values.eps1);
    object["T"] = to_json(values.T);
  }
  return object;
}

}  // namespace slipproof
