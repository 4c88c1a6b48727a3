// What other programs say about the statements that the certificates prove: a table that is measured once and kept in
// their folder, because asking takes hours.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace slipproof {

/// The opinion of one program about one statement. There is no value for a contradiction, because such a table is
/// refused.
enum class Opinion : std::uint8_t {
  not_asked,  ///< `-`
  agrees,     ///< `unsat` of the negated statement (z3, cvc5), `accepted` (Coq)
  timeout,    ///< `timeout`
  unknown,    ///< `unknown`
};

/// The programs, in the order of the table's columns.
inline constexpr std::array<std::string_view, 3> opinion_programs{"z3", "cvc5", "Coq"};

using Opinions = std::array<Opinion, opinion_programs.size()>;
using SecondOpinions = std::map<std::string, Opinions, std::less<>>;

/// Reads CSV with the header `statement,z3,cvc5,coq`. A statement is given by the path of its file below the table's
/// folder, without the extension, as in `theorems/A5.order.1`. Each must be one of `statements`; the table need not
/// contain all of them. Throws InputError with all mistakes.
SecondOpinions read_second_opinions(const std::filesystem::path& path, const std::vector<std::string>& statements);

}  // namespace slipproof
