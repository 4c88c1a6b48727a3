// The report on a scene at rest: whether it can, whether it must, up to where; as text and as `slipproof/rest/1`.
#pragma once

#include <string>

#include "contact/rest/rest_answer.hpp"
#include "report/document/document.hpp"

namespace slipproof {

/// `RESTS`, `CAN REST`, `CANNOT REST`, `UNDECIDED`.
std::string rest_verdict(const RestAnswer& answer);
/// For people; `digits` is the number of significant digits of decimals.
Document rest_document(const RestAnswer& answer, int digits);
/// The document slipproof/rest/1.
std::string rest_json(const RestAnswer& answer);

}  // namespace slipproof
