#include "proofs/check_contact/check_contact.hpp"

#include <optional>

#include "proofs/check_contact/all_solutions.hpp"
#include "proofs/check_contact/ball.hpp"
#include "proofs/check_contact/claims.hpp"
#include "proofs/check_contact/every_solution.hpp"

namespace slipproof::check_contact {

namespace {

std::string claim(const Problem& problem, Reader& reader, const char* expected) {
  if (reader.accept("eps")) return eps(problem, reader);
  if (reader.accept("none-within")) return none_within(problem, reader);
  if (reader.accept("no-solution")) return no_solution(problem, reader);
  if (reader.accept("rest")) return rest(problem, reader);
  if (reader.accept("no-rest")) return no_rest(problem, reader);
  if (reader.accept("enclosure")) return near_answer<Enclosure>(problem, reader);
  if (reader.accept("ball")) return near_answer<Ball>(problem, reader);
  if (reader.accept("unique")) return unique(problem, reader);
  if (reader.accept("every-solution")) return EverySolution(problem, reader).check();
  if (reader.accept("all-solutions")) return AllSolutions(problem, reader).established();
  reader.refuse(expected);
}

/// Checks all claims of the file, one after the other, and returns what is established. A file that cannot be read to
/// its end is reported as such first; a rejection waits.
std::string established(Reader& reader, std::string_view required_name) {
  const Problem problem(reader);
  std::string result;
  std::optional<Rejected> rejected;
  do {
    try {
      const std::string found = claim(problem, reader, result.empty() && !rejected ? "a claim" : "a claim or 'end'");
      result += (result.empty() ? "" : "; ") + found;
    } catch (const Rejected& reason) {
      if (!rejected) rejected = reason;
    }
  } while (!reader.at("end"));
  reader.finish();
  const std::string name = problem.check_name(required_name);
  if (rejected) throw Rejected(*rejected);
  problem.check_mu();
  problem.check_law_numbers();
  return result + ", " + problem.in_words() + ", " + name;
}

}  // namespace

ContactVerdict check_contact_certificate(std::string_view text, std::string_view required_name) {
  using Kind = ContactVerdict::Kind;
  try {
    Reader reader(text);
    return {Kind::accepted, established(reader, required_name)};
  } catch (const Rejected& rejected) {
    return {Kind::rejected, rejected.what()};
  } catch (const Unreadable& unreadable) {
    return {Kind::unreadable, unreadable.what()};
  }
}

}  // namespace slipproof::check_contact
