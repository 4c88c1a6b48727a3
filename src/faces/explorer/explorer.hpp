// What the explorer's page asks of the library: requests and answers in JSON.
#pragma once

#include <string>
#include <string_view>

#include "mechanics/scene/scene.hpp"
#include "report/explorer/portable_scene.hpp"

namespace slipproof {

/// One scene whose values are changed.
class Explorer {
 public:
  /// A relative path of the mechanism counts from the working directory. Throws InputError.
  explicit Explorer(PortableScene given);

  /// The answer to a request, a JSON object:
  ///
  /// - `set`: optional. Values that replace the scene's, as texts of numbers, by symbol: of a parameter, of an angle
  ///   (its tan(angle/2)), of the load; null removes the load's value.
  /// - `map`: optional. The parameter or angle of a phase diagram, or "" for the usual one; `columns`: its evenly
  ///   spaced values, 48 without it.
  /// - `every_q`: optional, false: `solve` has no `every_q`, which may take most of the time.
  /// - `pasted`: optional, a text. The answer is `judged`: a list of what judge_pasted() says of its answers.
  /// - `ranges`: optional, true: also the range of each value in the explorer.
  ///
  /// Without `map` and `pasted` the answer has `scene`, the text of a scene file with the values, `values`, `solve`,
  /// the document slipproof/solve/2, and `pictures`, one of each motion and continuum as SVG; with `map`, the picture,
  /// and the axes of its `frames`: the diagram, then what is enlarged. For bad input it has only `mistakes`, one text
  /// each. Any bytes are safe.
  std::string answer(std::string_view request) const;

 private:
  PortableScene given_;
  MechanismScene scene_;
};

}  // namespace slipproof
