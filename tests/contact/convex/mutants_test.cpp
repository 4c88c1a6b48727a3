// Certificates of every law, changed at random: the checker and the second reading judge them alike.
#include <doctest/doctest.h>

#include <map>
#include <sstream>

#include "contact/convex/lawful_problem.hpp"
#include "contact/convex/second_reading.hpp"
#include "contact/judge/certificate.hpp"
#include "contact/judge/judge.hpp"
#include "proofs/check_contact/all_solutions_examples.hpp"
#include "proofs/check_contact/frictionless_examples.hpp"
#include "proofs/check_contact/record.hpp"
#include "support/how_many.hpp"
#include "support/run_program.hpp"

using namespace slipproof;
using namespace slipproof::test;

namespace {

std::string first_reading(const std::string& text) {
  using Kind = check_contact::ContactVerdict::Kind;
  const Kind kind = check_contact::checked_on_record(text).kind;
  return kind == Kind::accepted ? "accepted" : kind == Kind::rejected ? "rejected" : "unreadable";
}

std::vector<std::string> words_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

/// A certificate without the name of its problem, of one kind of claim. Empty if it has none of it.
std::string certificate_of(const LawfulProblem& known, const std::vector<double>& answer, const std::string& kind) {
  ContactJudgeOptions options;
  if (kind == "ball") options.enclosure.sparse_from = 0;
  ContactJudgement judgement = judge_contacts(known.problem, answer, {}, options);
  if (kind == "velocities" && judgement.verdict != ContactVerdict::velocities_of_a_solution) return {};
  if (kind == "eps") judgement.verdict = ContactVerdict::eps_solution;
  if (kind == "enclosure" || kind == "ball") judgement.every.reset();
  if (kind == "every-solution") judgement.enclosure.reset();
  std::string text = contact_certificate(known.problem, judgement);
  if (text.find(kind) == std::string::npos) return {};
  const std::size_t name = text.find("problem ");
  return text.erase(name, text.find('\n', name) - name);
}

/// A problem with its solution; for `velocities` with forces elsewhere that move nothing else.
LawfulProblem problem_for(const std::string& claim, Dice& dice, const ContactLaw& law) {
  if (claim == " touch") {
    for (;;) {
      const LawfulProblem known = Lawful(dice, law).make(static_cast<std::size_t>(dice.number(1, 3)));
      if (auto touching = with_touching(known, dice)) return *touching;
    }
  }
  if (claim != "velocities") return Lawful(dice, law).make(static_cast<std::size_t>(dice.number(1, 3)));
  const double weight = 1 << dice.number(0, 6), share = weight * dice.number(1, 15) / 16;
  const double other = -weight * (1 + dice.number(1, 3) * 0x1p-52);
  return {one_place(2, {-weight, 0, 0, other, 0, 0}), {share, 0, 0, weight - share, 0, 0}};
}

/// One word changed, swapped, left out or doubled; numbers by a little, a lot, or their sign.
std::string changed(std::vector<std::string> words, Dice& dice) {
  const auto last = static_cast<int>(words.size()) - 1;
  const auto at = static_cast<std::size_t>(dice.number(0, last));
  std::string& word = words[at];
  switch (dice.number(0, 7)) {
    case 0:
      word = words[static_cast<std::size_t>(dice.number(0, last))];
      break;
    case 1:
      words.erase(words.begin() + static_cast<std::ptrdiff_t>(at));
      break;
    case 2:
      word = word.front() == '-' ? word.substr(1) : "-" + word;
      break;
    case 3:
      word = std::to_string(dice.number(0, 3));
      break;
    case 4:
      std::swap(word, words[static_cast<std::size_t>(dice.number(0, last))]);
      break;
    default: {  // a digit
      const std::size_t digit = word.find_last_of("0123456789abcdef");
      if (digit != std::string::npos) word[digit] = "0123456789abcdef"[dice.number(0, 15)];
      break;
    }
  }
  std::string text;
  for (const std::string& w : words) text += w + ' ';
  return text;
}

}  // namespace

TEST_CASE("mutants of certificates of every law are judged alike by two checkers") {
  struct Kind {
    FrictionLaw law;
    Regularisation function;
    std::string claim;
  };
  const std::vector<Kind> kinds{{FrictionLaw::box, Regularisation::linear, "eps"},
                                {FrictionLaw::diamond, Regularisation::linear, "eps"},
                                {FrictionLaw::fixed, Regularisation::linear, "eps"},
                                {FrictionLaw::associated, Regularisation::linear, "eps"},
                                {FrictionLaw::regularised, Regularisation::linear, "eps"},
                                {FrictionLaw::regularised, Regularisation::soft, "eps"},
                                {FrictionLaw::associated, Regularisation::linear, "enclosure"},
                                {FrictionLaw::box, Regularisation::linear, "enclosure"},
                                {FrictionLaw::associated, Regularisation::linear, "ball"},
                                {FrictionLaw::box, Regularisation::linear, "ball"},
                                {FrictionLaw::cone, Regularisation::linear, "ball"},
                                {FrictionLaw::cone, Regularisation::linear, "velocities"},
                                {FrictionLaw::cone, Regularisation::linear, " touch"},
                                {FrictionLaw::box, Regularisation::linear, " touch"},
                                {FrictionLaw::associated, Regularisation::linear, "every-solution"},
                                {FrictionLaw::fixed, Regularisation::linear, "every-solution"}};
  const int mutants = how_many("SLIPPROOF_LAW_MUTANTS", 150);
  std::map<std::string, int> count;
  for (std::size_t k = 0; k < kinds.size(); ++k) {
    for (int i = 0, made = 0; made < mutants; ++i) {
      Dice dice(31 + k, static_cast<std::uint64_t>(i));
      ContactLaw law;
      law.kind = kinds[k].law;
      law.function = kinds[k].function;
      const LawfulProblem known = problem_for(kinds[k].claim, dice, law);
      std::vector<double> answer = known.x;
      const double off = kinds[k].claim == "velocities" ? 0 : 1e-9;
      for (double& x : answer) x *= 1 + dice.number(-3, 3) * off;
      const std::string text = certificate_of(known, answer, kinds[k].claim);
      CAPTURE(kinds[k].claim);
      CAPTURE(name(kinds[k].law));
      REQUIRE(i < 2 * mutants);
      if (text.empty()) continue;  // all contacts are open, and there is nothing to enclose
      REQUIRE(first_reading(text) == "accepted");
      REQUIRE(second_reading(text) == "accepted");
      const std::vector<std::string> words = words_of(text);
      for (int m = 0; m < 50 && made < mutants; ++m, ++made) {
        const std::string mutant = changed(words, dice);
        const std::string first = first_reading(mutant), second = second_reading(mutant);
        CAPTURE(mutant);
        CAPTURE(second);
        CHECK(first == second.substr(0, first.size()));
        ++count[first];
      }
    }
  }
  CHECK(count["accepted"] > 0);
  CHECK(count["rejected"] > mutants);
  CHECK(count["unreadable"] > mutants);
}

TEST_CASE("a contact that touches has no force, by both readings") {
  // Two contacts of one point of mass 1 and weight 2: the first one sticks, the second one's floor moves along with 5.
  const auto certificate = [](const std::string& first, const std::string& second) {
    std::string text = "slipproof-contact 1 dimension 3 free 0 contacts 2 mu 1/2 1/2 matrix 12\n";
    for (int i = 0; i < 6; ++i) {
      for (const int j : {i % 3, i % 3 + 3}) text += std::to_string(i) + ' ' + std::to_string(j) + " 1\n";
    }
    text += "constant -2 0 0 -2 5 0 answer " + first + " 0 0 " + second + " 0 0\n";
    text +=
        "enclosure 1/1000 modes stick touch center " + first + " 0 0 " + second + " radius 1/1000 1/1000 1/1000 1\n";
    return text + "pinned 1 3 dropped 1 3 1 0 1 inverse 3 0 0 1 1 1 1 2 2 1 end\n";
  };
  CHECK(first_reading(certificate("2", "0")) == "accepted");
  CHECK(second_reading(certificate("2", "0")) == "accepted");
  CHECK(first_reading(certificate("1", "1")) == "rejected");  // it would rub
  CHECK(second_reading(certificate("1", "1")).substr(0, 8) == "rejected");
}

TEST_CASE("mutants of certificates of all solutions are judged alike by two checkers") {
  using namespace check_contact;
  const int mutants = how_many("SLIPPROOF_LAW_MUTANTS", 150) * 10;
  std::map<std::string, int> count;
  std::uint64_t seed = 0;
  std::string coupled =  // in space, to a free unknown
      read_file(SLIPPROOF_SOURCE_DIR "/tests/proofs/verified/all_solutions/with-free-unknown.cert");
  coupled.erase(coupled.find('#'), coupled.find("dimension") - coupled.find('#'));
  for (const std::string& text :
       {kRests, kRestsInBox, kRestsOrLifts, kTouches, kSharedWeight, kSlides, kSlidesInBox, kParadox, kSticks,
        kSlidesInSpace, kNearASlide, kNoMotion, kThreeContacts, kBlockRests, kGuided, kLiftsOff, kOnIce, coupled}) {
    CAPTURE(text);
    REQUIRE(first_reading(text) == "accepted");
    REQUIRE(second_reading(text) == "accepted");
    const std::vector<std::string> words = words_of(text);
    Dice dice(57, seed++);
    for (int m = 0; m < mutants; ++m) {
      std::string mutant = changed(words, dice);
      if (m % 4 == 0) mutant = changed(words_of(mutant), dice);
      const std::string first = first_reading(mutant), second = second_reading(mutant);
      CAPTURE(mutant);
      CAPTURE(second);
      CHECK(first == second.substr(0, first.size()));
      ++count[first];
    }
  }
  CHECK(count["accepted"] > mutants / 4);
  CHECK(count["rejected"] > mutants);
  CHECK(count["unreadable"] > mutants);
}
