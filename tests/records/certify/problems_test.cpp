// Contact problems: each verdict on problems that a person can follow, recorded solvers, broken input.
#include <doctest/doctest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "contact/simulation/loaded_contacts.hpp"
#include "mechanics/scene/bicycle_scene.hpp"
#include "records/certify/certify.hpp"
#include "records/certify/judged_problems.hpp"
#include "records/judging/record_judge.hpp"
#include "records/problems/problem_judge.hpp"
#include "records/reading/record_reader.hpp"
#include "records/record/bicycle_records.hpp"
#include "support/scenes/bicycle_scenes.hpp"

using namespace slipproof;
using namespace slipproof::test;
using Json = nlohmann::json;

namespace {

const std::string definite = R"({"M":[[2,1],[1,2]],"q":[-5,-6],)";        // z = (4/3, 7/3)
const std::string three = R"({"M":[[1,2],[2,1]],"q":[-1,-1],)";           // z = (1/3, 1/3), (1, 0), (0, 1)
const std::string box = R"({"W":[[1,0],[0,1]],"q":[-1,0.75],"mu":0.5,)";  // N = 1, T = -1/2, slip = 1/4

}  // namespace

TEST_CASE("each verdict on an LCP, with what the reader needs to see") {
  Json line = judged(definite + R"("z":[1.3333333333333333,2.3333333333333335]})");
  CHECK(line["verdict"] == "certified");
  CHECK(line["modes"] == Json{"zz"});
  CHECK(line["solutions"] == 1);
  CHECK(line["tier"] == "exact");
  CHECK(judged(definite + R"("z":["4/3","7/3"],"w":[0,0],"mode":"zz"})")["max_relative_error"] == "0");

  line = judged(definite + R"("z":[1.333,2.333]})");
  CHECK(line["verdict"] == "inaccurate");
  CHECK(line["found"][0]["z"] == Json{"4/3", "7/3"});
  CertifyOptions loose;
  loose.contact.tolerance = 1e-3;
  CHECK(judged(definite + R"("z":[1.333,2.333]})", loose)["verdict"] == "certified");
  CHECK(judged(definite + R"("z":["4/3","7/3"],"w":[0,0.1]})")["verdict"] == "wrong");
  CHECK(judged(definite + R"("z":["4/3","7/3"],"w":[0,1e-4]})")["verdict"] == "inaccurate");

  line = judged(definite + R"("z":[2.5,0]})");
  CHECK(line["verdict"] == "wrong");
  line = judged(definite + R"("z":[2.5,0],"mode":"zw"})");
  CHECK(line["verdict"] == "wrong");
  CHECK(line["claimed"] == "zw");
  CHECK(line["violated"] == "w2 >= 0");
  CHECK(line["margin"] == "-7/2");
  CHECK(judged(definite + R"("z":["4/3","7/3"],"mode":"zw"})")["verdict"] == "wrong");

  for (const char* z : {R"([1,0])", R"([0,1])", R"(["1/3","1/3"])"}) {
    line = judged(three + R"("z":)" + z + "}");
    CHECK(line["verdict"] == "ambiguous");
    CHECK(line["solutions"] == 3);
    CHECK(line["found"].size() == 3);
  }
  CHECK(judged(three + R"("z":[0.5,0.5]})")["verdict"] == "wrong");

  line = judged(R"({"M":[[-1]],"q":[-1],"z":[0]})");
  CHECK(line["verdict"] == "wrong");
  CHECK(line["solutions"] == 0);
  CHECK(line["violated"] == "w1 >= 0");
  CHECK(line["margin"] == "-1");
}

TEST_CASE("each verdict on frictional contact") {
  Json line = judged(box + R"("z":[1,-0.5]})");
  CHECK(line["verdict"] == "certified");
  CHECK(line["modes"] == Json{"slip+"});
  line = judged(box + R"("z":[1,-0.75],"mode":"stick"})");
  CHECK(line["verdict"] == "wrong");
  CHECK(line["violated"] == "|T1| <= mu N1");
  CHECK(line["margin"] == "-1/4");
  CHECK(line["found"][0]["modes"] == Json{"slip+"});
  line = judged(R"({"W":[[1,0],[0,1]],"q":[2,1],"mu":[0.5],"z":[0,0]})");
  CHECK(line["verdict"] == "certified");
  CHECK(line["modes"] == Json{"lift"});
  CHECK(judged(R"({"W":[[1,0],[0,1]],"q":[2,1],"mu":[0.5],"z":[0,1e-12]})")["verdict"] == "certified");
  CHECK(judged(R"({"W":[[1,0],[0,1]],"q":[2,1],"mu":[0.5],"z":[0,0.1]})")["verdict"] == "wrong");

  // A rigid rod on two contacts, twice: only the sum of the forces is determined.
  const std::string rod = R"({"W":[[1,0,1,0],[0,1,0,1],[1,0,1,0],[0,1,0,1]],"q":[-1,0,-1,0],"mu":[0.5,0.5],)";
  line = judged(rod + R"("z":[0.25,0.125,0.75,-0.125]})");
  CHECK(line["verdict"] == "certified");  // one motion, whatever its forces
  CHECK(line["solutions"] == 0);
  CHECK(line["continua"][0]["mode"] == "stick/stick");
  CHECK(line["continua"][0]["nearest_z"] == Json{"1/4", "1/8", "3/4", "-1/8"});
  CHECK(judged(rod + R"("z":[0.25,0.126,0.75,-0.125]})")["verdict"] == "inaccurate");
  CHECK(judged(rod + R"("z":[0.25,0.2,0.75,-0.2]})")["verdict"] == "wrong");  // |T1| > mu N1
  CHECK(judged(rod + R"("z":[1.25,0,-0.25,0]})")["verdict"] == "wrong");
}

TEST_CASE("an answer among infinitely many solutions is held against the nearest one, whatever the sizes in it") {
  // N + T = 1, |T| <= N: every size of T has a solution next to it.
  const std::string sum = R"({"W":[[1,1],[1,1]],"q":[-1,-1],"mu":[1],)";
  for (const char* tiny : {"1e-17", "-1e-17", "1e-30", "0", "1e-10"}) {
    const Json line = judged(sum + R"("z":[1,)" + tiny + "]}");
    CAPTURE(line.dump());
    CHECK(line["verdict"] == "certified");
    CHECK(std::stod(line["max_relative_error"].get<std::string>()) <= 1e-10);
  }
  CHECK(judged(sum + R"("z":[1,1e-7]})")["verdict"] == "certified");
  CHECK(judged(sum + R"("z":[1,1e-4]})")["verdict"] == "inaccurate");
  CHECK(judged(sum + R"("z":[1,0.5]})")["verdict"] == "wrong");
  // The same with w, and in thousandths of the unit of forces.
  CHECK(judged(sum + R"("z":[1,1e-17],"w":[0,1e-17]})")["verdict"] == "certified");
  const std::string small = R"({"W":[["1/1000","1/1000"],["1/1000","1/1000"]],"q":[-1,-1],"mu":[1],)";
  CHECK(judged(small + R"("z":[1000,1e-14]})")["verdict"] == "certified");
  CHECK(judged(small + R"("z":[1000,1]})")["verdict"] == "inaccurate");
}

TEST_CASE("where not every solution can be found, a right answer is undecided unless it is the only one by theory") {
  // 20 components, each z_i + c z_(i+1) >= 1: definite for c = 1/2, not for c = 3.
  const auto chain = [](const std::string& c, const std::string& z, const std::string& more = "") {
    std::string M, q, zs;
    for (int i = 0; i < 20; ++i) {
      M += i == 0 ? "[" : ",[";
      for (int j = 0; j < 20; ++j) M += (j == 0 ? "" : ",") + (i == j ? "1" : j == i + 1 ? c : "0");
      M += "]";
      q += i == 0 ? "-1" : ",-1";
      zs += (i == 0 ? "" : ",") + z;
    }
    return R"({"M":[)" + M + R"(],"q":[)" + q + R"(],"z":[)" + zs + "]" + more + "}";
  };
  // z_20 = 1, z_i = 1 - z_(i+1) / 2 from there on.
  std::vector<double> z(20, 1);
  for (std::size_t i = 19; i-- > 0;) z[i] = 1 - z[i + 1] / 2;
  Json record = Json::parse(chain("0.5", "0"));
  record["z"] = z;
  Json line = judged(record.dump());
  CHECK(line["verdict"] == "certified");
  CHECK(line["unique_by"] == "positive definite");
  z[3] += 1e-5;
  record["z"] = z;
  CHECK(judged(record.dump())["verdict"] == "inaccurate");
  CHECK(judged(chain("0.5", "0"))["verdict"] == "wrong");

  // With c = 3: z = (..., 0, 1, 0, 1) from the end is a solution.
  record = Json::parse(chain("3", "0"));
  std::vector<double> alternating;
  for (int i = 0; i < 20; ++i) alternating.push_back(i % 2);
  record["z"] = alternating;
  const Certified chained = problems(record.dump() + "\n");
  const auto lines = chained.lines();
  CHECK(lines[0]["verdict"] == "undecided");
  CHECK(lines[0]["modes"] == Json{"wzwzwzwzwzwzwzwzwzwz"});
  CHECK(lines[0]["solutions"].is_null());
  CHECK(chained.summary.nothing_refuted());
  CHECK_FALSE(chained.summary.all_certified());
  line = judged(chain("3", "1"));
  CHECK(line["verdict"] == "undecided");
  CHECK(line["violated"] == "w1 >= 0");
  line = judged(chain("3", "1", R"(,"mode":"zzzzzzzzzzzzzzzzzzzz")"));
  CHECK(line["verdict"] == "wrong");
  CHECK(line["margin"].get<std::string>().starts_with("-"));
}

TEST_CASE("one solution for every q is told where it is asked for") {
  CertifyOptions asked;
  asked.judge.every_q = true;
  // The determinant of slip- is 1 - mu/2.
  const auto told = [&](const std::string& mu, const CertifyOptions& options) {
    return judged(R"({"W":[[1,0.5],[0.5,1]],"q":[1,0],"mu":")" + mu + R"(","z":[0,0]})", options);
  };
  CHECK(told("1", asked)["every_q"] == Json{{"verdict", "unique"}, {"by", "mode determinants"}});
  const Json several = told("5/2", asked);
  CHECK(several["verdict"] == "certified");  // of this q
  CHECK(several["every_q"] ==
        Json{{"verdict", "not unique"}, {"by", "mode determinants"}, {"mode", "slip+"}, {"determinant", "-1/4"}});
  CHECK_FALSE(told("1", {}).contains("every_q"));
  CHECK(judged(three + R"("z":[1,0]})", asked)["every_q"]["mode"] == "zz");
}

TEST_CASE("with friction beyond all modes the bound on mu makes a right answer the only one") {
  // 20 contacts that do not know of each other; each bears 1 and is pushed by 1/4.
  const auto contacts = [](double mu) {
    Json record{{"q", Json::array()}, {"z", Json::array()}, {"mu", mu}};
    for (std::size_t i = 0; i < 40; ++i) {
      record["W"].push_back(std::vector<double>(40));
      record["W"][i][i] = 1;
      record["q"].push_back(i % 2 == 0 ? -1 : 0.25);
      record["z"].push_back(i % 2 == 0 ? 1 : -0.25);
    }
    return judged(record.dump());
  };
  CHECK(contacts(0.5)["verdict"] == "certified");
  CHECK(contacts(0.5)["unique_by"] == "bound on mu");
  CHECK(contacts(1)["verdict"] == "undecided");
}

TEST_CASE("recorded answers of Siconos get the same verdict as contact problems and as bicycles") {
  // A force of a wheel that all but leaves the road may have no right digit: there the scales of the two forms differ.
  std::size_t records = 0, several = 0;
  for (const char* solver : {"fc2d-enum", "fc2d-lemke", "fc2d-nsgs", "lcp-lemke", "lcp-newton-min", "lcp-bard"}) {
    CAPTURE(solver);
    const std::string path = std::string(SLIPPROOF_SOURCE_DIR) + "/cases/solvers/siconos-" + solver + ".csv";
    std::ifstream file(path);
    REQUIRE(file);
    CertifyOptions options;
    options.ignore_unknown = true;
    options.threads = 1;
    std::string verdicts, header, row, verdict;
    certify(
        file, [&](std::string_view out) { verdicts += out; }, options);
    file.clear();
    file.seekg(0);
    std::getline(file, header);
    const RecordJudge judge(bicycle_records(), options.judge);
    const RecordFields& fields = judge.fields();
    const RecordReader reader(options, judge.certified(), fields, header);
    std::istringstream lines(verdicts);
    while (std::getline(file, row) && std::getline(lines, verdict)) {
      const Json scene = Json::parse(verdict);
      if (scene["verdict"] == "invalid") continue;
      CAPTURE(row);
      Record record;
      reader.read(row, record);
      RecordPoint point = point_of(judge.setting(), record);
      const ContactProblem problem =
          loaded_contacts({"", bicycle_mechanism(), std::move(point.values), std::move(point.load), {}}).problem;
      ProblemAnswer answer;
      for (const char* force : {"N2", "S2", "N3", "S3"}) answer.z.push_back(record.exactly(*fields.find(force)));
      const auto judgement = judge_problem(problem, answer, options.judge);
      ++records;
      CHECK(judgement.motions == scene["motions"]);
      const std::string found(name(judgement.verdict));
      const std::string expected = scene["verdict"];
      const auto right = [](const std::string& v) { return v != "wrong"; };
      CHECK(right(found) == right(expected));
      CHECK((found == "ambiguous") == (expected == "ambiguous"));
      if (expected == "certified") CHECK((found == "certified" || found == "inaccurate"));
      several += judgement.motions > 1 ? 1 : 0;
    }
  }
  CHECK(records > 950);
  CHECK(several >= 50);
}

TEST_CASE("one mu for what may be planar or in space asks for the dimension") {
  // Two contacts in space, each with the one right answer; taken for three in the plane it would be wrong.
  const std::string rows = "[[1,0,0,0,0,0],[0,1,0,0,0,0],[0,0,1,0,0,0],[0,0,0,1,0,0],[0,0,0,0,1,0],[0,0,0,0,0,1]]";
  const std::string rest = R"("q":[-1,0.1,0.1,-1,0,0],"mu":0.5,"z":[1,-0.1,-0.1,1,0,0])";
  const Json open = judged("{\"W\":" + rows + "," + rest + "}");
  CHECK(open["verdict"] == "invalid");
  CHECK(
      open["reason"].get<std::string>().find(
          "dimension: found nothing, and one mu for 6 components, expected 2 or 3: they are of 3 contacts in the plane "
          "or of 2 in space") != std::string::npos);
  CHECK(judged("{\"dimension\":3,\"W\":" + rows + "," + rest + "}")["verdict"] == "solution within rho");
  CHECK(judged("{\"dimension\":2,\"W\":" + rows + "," + rest + "}")["verdict"] == "wrong");
  // With a coefficient for each contact the sizes say it.
  const std::string planar = R"("q":[-1,0.1,-1,0.1,-1,0],"mu":[0.5,0.5,0.5],"z":[1,-0.1,1,-0.1,1,0])";
  CHECK(judged("{\"W\":" + rows + "," + planar + "}")["verdict"] == "certified");
}

TEST_CASE("an answer may be called r and u, as at real size") {
  const Json line = judged(R"({"title":"x","W":[[1,0],[0,1]],"q":[-1,0.1],"mu":0.5,"r":[1,-0.1],"u":[0,0]})");
  CHECK(line["verdict"] == "certified");
}

TEST_CASE("decimals mean the nearest binary64, or themselves") {
  const std::string tenth = R"({"M":[[0.1]],"q":[-1],"z":[10]})";
  CHECK(judged(tenth)["max_relative_error"] != "0");
  CertifyOptions exact;
  exact.decimal_exact = true;
  CHECK(judged(tenth, exact)["max_relative_error"] == "0");
  CHECK(judged(R"({"M":[["1/10"]],"q":["-0x1p0"],"z":[10]})")["max_relative_error"] == "0");
}

TEST_CASE("an answer that is no number is invalid, a line that is no problem is broken") {
  const std::vector<std::pair<std::string, std::string>> answers{
      {R"(["nan",1])", "z[1]: found nan, expected a finite number"},
      {R"([1,"-inf"])", "z[2]: found -inf, expected a finite number"},
      {R"([1,"1e400"])", "z[2]: found 1e400, expected a number that binary64 can hold"},
      {R"([1e999,1])", "z[1]: found 1e999, expected a number that binary64 can hold"},
      {"[1," + std::string(400, '9') + "]", "expected a number that binary64 can hold"},
      {R"(["Infinity",1])", "z[1]: found Infinity, expected a finite number"}};
  for (const auto& [z, reason] : answers) {
    const Json line = judged(definite + R"("z":)" + z + "}");
    CHECK(line["verdict"] == "invalid");
    CHECK_MESSAGE(line["reason"].get<std::string>().find(reason) != std::string::npos, line["reason"]);
  }
  const std::vector<std::pair<std::string, std::string>> rows{
      {R"({"q":[1],"z":[0]})", "W: found nothing, expected a matrix"},
      {R"({"M":[[1]],"q":[1]})", "z: found nothing, expected an answer"},
      {R"({"M":[[1]],"W":[[1]],"q":[1],"z":[0]})", "M: found it together with W, expected one of them"},
      {R"({"M":[[1]],"M":[[1]],"q":[1],"z":[0]})", "twice"},
      {R"({"M":[[1,2]],"q":[1],"z":[0]})",
       "the number of columns of M[1]: found 2, expected 1, the length of the vectors"},
      {R"({"M":[1],"q":[1],"z":[0]})", "M[1]: found no list"},
      {R"({"M":1,"q":[1],"z":[0]})", "M: found no matrix, expected a list of rows"},
      {R"({"M":[[[1]]],"q":[1],"z":[0]})", "M[1][1]: found no number, expected one"},
      {R"({"M":[[1]],"q":[[1]],"z":[0]})", "q[1]: found no number, expected one"},
      {R"({"M":[[1]],"q":[],"z":[]})", "found 0 components of q, expected 1 to 64"},
      {R"({"M":[[1]],"q":[1],"z":[0,1]})", "z: found 2 components, expected 1 as in q"},
      {R"({"M":[[1]],"q":[1],"z":[0],"w":[]})", "w: found 0 components"},
      {R"({"M":[[1]],"q":[1],"z":["x"]})", "z[1]: found 'x'"},
      {R"({"M":[["nan"]],"q":[1],"z":[0]})", "M[1][1]: found"},
      {R"({"M":[["1e400"]],"q":[1],"z":[0]})", "expected a finite number within binary64's range"},
      {R"({"M":[[-1e999]],"q":[1],"z":[0]})",
       "M[1][1]: found an infinity, or a number that becomes one, expected a finite number"},
      {R"({"W":[[1,0,0],[0,1,0],[0,0,1]],"q":[1,2,3],"mu":1,"z":[0,0,0]})",
       "dimension: found nothing, and contacts of 3 components, expected \"dimension\": 3"},
      {R"({"M":[[1]],"q":[1],"z":[0],"r":[0]})", "r: found it together with z, expected one of them"},
      {R"({"M":[[null]],"q":[1],"z":[0]})", "M[1][1]: found no number, expected one"},
      {R"({"M":[[true]],"q":[1],"z":[0]})", "M[1][1]: found no number, expected one"},
      {R"({"M":{},"q":[1],"z":[0]})", "M: found other keys, expected rows, columns and a list of entries"},
      {R"({"M":[[1]],"q":[1],"z":[0],"mode":"x"})", "mode: found 'x', expected letters z and w"},
      {R"({"M":[[1]],"q":[1],"z":[0],"mode":3})", "mode: found '3'"},
      {R"({"M":[[1]],"q":[1],"mu":1,"z":[0]})",
       "mu: found one number for 1 components, expected 2 or 3 components for each contact"},
      {R"({"M":[[1]],"q":[1],"mu":[1,1],"z":[0]})",
       "mu: found 2 coefficients for 1 components, expected 2 or 3 components for each contact"},
      {R"({"W":[[1,0],[0,1]],"q":[1,1],"mu":-1,"z":[0,0]})", "found mu1 = -1, expected >= 0"},
      {R"({"W":[[1,0],[0,1]],"q":[1,1],"mu":1,"z":[0,0],"mode":"zw"})", "expected states like stick/slip+/lift"},
      {R"({"M":[[1]],"q":[1],"z":[0],"nme":1})", "nme: found an unknown key"},
      {R"({"M":[[1]],"q":[1],"z":[0])", "found no JSON object"},
      {R"([{"M":[[1]],"q":[1],"z":[0]}])", "found a list, expected an object"}};
  std::string text;
  for (const auto& row : rows) text += row.first + "\n";
  const Certified found = problems(text);
  const auto lines = found.lines();
  REQUIRE(lines.size() == rows.size());
  CHECK(found.summary.broken == rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    CAPTURE(rows[i].first);
    CHECK(lines[i]["verdict"] == "invalid");
    const std::string reason = lines[i]["reason"];
    CAPTURE(reason);
    CHECK(reason.starts_with("line " + std::to_string(i + 1)));
    CHECK(reason.find(rows[i].second) != std::string::npos);
  }
  CertifyOptions lenient;
  lenient.ignore_unknown = true;
  CHECK(judged(R"({"M":[[1]],"q":[1],"z":[0],"name":"x"})", lenient)["verdict"] == "certified");
}
