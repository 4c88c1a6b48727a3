// Why an answer is wrong or undecided: every reason is the true one.
#include <doctest/doctest.h>

#include "support/certified.hpp"

using namespace slipproof;
using namespace slipproof::test;

namespace {

using Json = nlohmann::json;

Json judged_record(const Json& record, const CertifyOptions& options = {}) {
  return certified(record.dump() + "\n", options).lines().at(0);
}

/// M = R = h = b = J = 1, f = 1, g = 10, wheels without inertia. The front wheel leaves the road from F = 5 on.
Json massless(double F, const std::string& mode) {
  return {{"M", 1},  {"R", 1},  {"h", 1},   {"b", 1},       {"I1", 0}, {"I2", 0}, {"I3", 0},
          {"mu", 1}, {"L", 1},  {"J", 1},   {"f", 1},       {"g", 10}, {"F", F},  {"a", 900},
          {"S2", 0}, {"S3", 0}, {"N2", 10}, {"mode", mode}, {"N3", 0}};
}

}  // namespace

TEST_CASE("a mode with a continuum of motions is modelled, and none of them may be near") {
  const Json line = judged_record(massless(20, "stick/lift"));
  CHECK(line["verdict"] == "wrong");
  CHECK(line["continua"] == Json{"stick/lift"});
  CHECK(line["reason"] == "the mode has a continuum of motions, and none of them is near");
}

TEST_CASE("a mode whose equations have many solutions is rejected by the condition that all of them break") {
  const Json line = judged_record(massless(2, "stick/lift"));
  CHECK(line["verdict"] == "wrong");
  CHECK(line["violated"] == "gap3 >= 0");
  CHECK(line["margin"].get<std::string>().starts_with("-"));
  CHECK_FALSE(line.contains("reason"));
}

TEST_CASE("the equations have no solution where they have none") {
  // A massless rear wheel in the air takes no moment from the chain.
  const Json line = judged_record(massless(20, "lift/stick"));
  CHECK(line["violated"].is_null());
  CHECK(line["reason"] == "its equations have no solution");
}

TEST_CASE("without J, and only then, a mode with a wheel off the road is not modelled") {
  Json record = massless(2, "stick/lift");
  record["I2"] = record["I3"] = 1;
  CHECK_FALSE(judged_record(record).contains("reason"));
  record.erase("J");
  CHECK(judged_record(record)["reason"] == "the mode is not modelled: front has no lift here without J");
  record["mode"] = "stick/stick";
  CHECK(judged_record(record)["reason"] == "the mode is right, its numbers are not");
}

TEST_CASE("beyond the effort a scene is undecided, and the reason says how much it takes") {
  Json record = massless(2, "stick/stick");
  const Json decided = judged_record(record);
  CHECK(decided["verdict"] == "wrong");
  CertifyOptions little;
  little.judge.effort = 1000;
  const Certified found = certified(record.dump() + "\n", little);
  const Json line = found.lines().at(0);
  CHECK(line["verdict"] == "undecided");
  CHECK(line["motions"].is_null());
  const std::string reason = line["reason"];
  CHECK(reason.starts_with("too much work: about "));
  CHECK(reason.find(" operations on words, more than the effort of 1000 allows; --effort ") != std::string::npos);
  CHECK(found.summary.nothing_refuted());
  little.judge.effort = std::stoull(reason.substr(reason.find("about ") + 6));
  CHECK(judged_record(record, little) == decided);
  --little.judge.effort;
  CHECK(judged_record(record, little)["verdict"] == "undecided");
}

TEST_CASE("numbers of many digits are too much work for a contact problem, at any number of threads") {
  Json W = Json::array(), q = Json::array();
  std::uint64_t x = 1;
  const auto digits = [&x](int n) {
    std::string text;
    for (int i = 0; i < n; ++i)
      text += static_cast<char>('1' + (x = x * 6364136223846793005U + 1442695040888963407U) / (1ULL << 60U) % 9);
    return text;
  };
  const auto fraction = [&] { return digits(8) + "/" + digits(8); };
  for (int i = 0; i < 64; ++i) {
    W.push_back(Json::array());
    for (int j = 0; j < 64; ++j) W.back().push_back(fraction());
    q.push_back("-" + fraction());
  }
  const Json record{{"W", W}, {"q", q}, {"z", q}, {"mode", std::string(64, 'z')}};
  const Json line = judged_record(record);
  CHECK(line["verdict"] == "undecided");
  CHECK(line["reason"].get<std::string>().starts_with("too much work: more than the effort of "));
  CertifyOptions one;
  one.threads = 1;
  CHECK(judged_record(record, one) == line);
}

TEST_CASE("a right answer of which no other was tried says what trying them takes") {
  const Json record{{"M", {{1, 3}, {0, 1}}}, {"q", {-1, -1}}, {"z", {0, 1}}};
  CHECK(judged_record(record)["verdict"] == "certified");
  CertifyOptions little;
  for (little.judge.effort = 1; judged_record(record, little)["modes"] == Json::array(); little.judge.effort += 50) {
    CHECK(judged_record(record, little)["verdict"] == "undecided");
  }
  Json line = judged_record(record, little);
  CHECK(line["verdict"] == "undecided");
  CHECK(line["reason"] == "near the solution of its mode");
  CHECK(line["unexamined"].get<std::string>().starts_with("the other modes: too much work: about "));
  // Two contacts carry one load, in one mode of many.
  const Json shared{{"M", {{1, 1}, {1, 1}}}, {"q", {-1, -1}}, {"z", {0.5, 0.5}}};
  for (little.judge.effort = 1; judged_record(shared, little)["modes"] == Json::array(); little.judge.effort += 50) {
    REQUIRE(little.judge.effort < 1'000'000);
  }
  line = judged_record(shared, little);
  CHECK(line["verdict"] == "ambiguous");
}
