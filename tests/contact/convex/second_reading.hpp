// Certificates about contact problems read a second time, from FORMAT.md alone: another program than the checker, with
// other formulas where there are some. It knows `eps`, `enclosure`, `ball` and
// `every-solution`.
#pragma once

#include <string>

namespace slipproof::test {

/// `accepted`, or why not. What it does not know, and what is no certificate, is `unreadable`.
std::string second_reading(const std::string& certificate);

}  // namespace slipproof::test
