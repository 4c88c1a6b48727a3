// Problems as one JSON object.
#include "contact/formats/json_problem.hpp"
#include "contact/formats/read_files.hpp"
#include "support/files/small_files.hpp"

using namespace slipproof;
using namespace slipproof::test;

namespace {

ReadProblem json(const std::string& text) {
  return read_json_problem(text, "FILE");
}

bool begins(const std::string& text) {
  return is_problem_file(Folder().write("p.json", text));
}
bool is_large(const std::string& line) {
  return JsonProblem(line, "FILE").is_large();
}

}  // namespace

TEST_CASE("a problem as rows, and the same as entries") {
  const ReadProblem rows =
      json(R"({"dimension": 2, "title": "a ramp", "W": [[4, 3], [0, 5]], "q": [-1, 0.1], "mu": 0.5})");
  CHECK(rows.problem.form == ProblemForm::local);
  CHECK(rows.problem.title == "a ramp");
  CHECK(dense(rows.problem.W) == Numbers{4, 3, 0, 5});
  CHECK(rows.problem.q == Numbers{-1, 0.1});
  CHECK(rows.problem.mu == Numbers{0.5});
  CHECK(rows.answers.empty());
  const ReadProblem entries = json(
      R"({"W": {"rows": 2, "columns": 2, "entries": [[1, 1, 5], [0, 0, 4], [0, 1, 3.0e0]]}, "mu": ["1/2"],
          "dimension": 2, "q": ["-1", "0.1"], "r": [1, NaN], "u": [-Infinity, 2]})");
  CHECK(entries.problem.W == rows.problem.W);
  CHECK(entries.problem.q == rows.problem.q);
  CHECK(entries.problem.mu == rows.problem.mu);
  REQUIRE(entries.answers.size() == 1);
  CHECK(std::isnan(entries.answers[0].r[1]));
  CHECK(entries.answers[0].u[0] < -1e308);
}

TEST_CASE("one coefficient stands for all contacts") {
  const ReadProblem read =
      json(R"({"dimension": 3, "W": {"rows": 6, "columns": 6, "entries": []}, "q": [1,2,3,4,5,6], "mu": 0.3})");
  CHECK(read.problem.mu == Numbers{0.3, 0.3});
}

TEST_CASE("the sizes say the dimension where they leave one") {
  const auto dimension = [](const std::string& size, const std::string& q, const std::string& mu) {
    return json(R"({"W": {"rows": )" + size + R"(, "columns": )" + size + R"(, "entries": []}, "q": [)" + q +
                "], \"mu\": " + mu + "}")
        .problem.dimension;
  };
  CHECK(dimension("2", "1,2", "1") == 2);
  CHECK(dimension("3", "1,2,3", "1") == 3);
  CHECK(dimension("6", "1,2,3,4,5,6", "[1,2]") == 3);
  CHECK(dimension("6", "1,2,3,4,5,6", "[1,2,3]") == 2);
}

TEST_CASE("without mu and dimension it is a complementarity problem; M is another name of W") {
  const ReadProblem read = json(R"({"M": [[1, 2], [3, 4]], "q": [-1, -2], "z": [1, 0], "w": [0, 1]})");
  CHECK(read.problem.form == ProblemForm::complementarity);
  CHECK(read.problem.dimension == 1);
  CHECK(dense(read.problem.W) == Numbers{1, 2, 3, 4});
  REQUIRE(read.answers.size() == 1);
  CHECK(read.answers[0].r == Numbers{1, 0});
  CHECK(read.answers[0].u == Numbers{0, 1});
}

TEST_CASE("bilateral rows and the global form") {
  const ProblemFile local =
      json(R"({"dimension": 2, "W": [[1,0],[0,1]], "V": [[7],[8]], "R": [[9]], "s": [5], "q": [1,2],
                                     "mu": [1]})")
          .problem;
  CHECK(dense(local.V) == Numbers{7, 8});
  CHECK(dense(local.R) == Numbers{9});
  CHECK(local.s == Numbers{5});
  const ReadProblem read =
      json(R"({"dimension": 2, "M": [[1,0,0],[0,2,0],[0,0,3]], "H": [[1,2],[3,4],[5,6]], "f": [7,8,9],
                                    "w": [1,2], "mu": 0, "G": {"rows": 3, "columns": 1, "entries": [[2, 0, 4]]}, "b": [6],
                                    "r": [1, 2], "u": [3, 4], "v": [5, 6, 7], "lambda": [8]})");
  const ProblemFile& p = read.problem;
  CHECK(p.form == ProblemForm::global);
  CHECK(dense(p.H) == Numbers{1, 2, 3, 4, 5, 6});
  CHECK(dense(p.G) == Numbers{0, 0, 4});
  CHECK(p.b == Numbers{6});
  CHECK(p.w == Numbers{1, 2});
  REQUIRE(read.answers.size() == 1);
  CHECK(read.answers[0].v == Numbers{5, 6, 7});
  CHECK(read.answers[0].lambda == Numbers{8});
}

TEST_CASE("what is for the reader of records stays so") {
  CHECK(begins(R"({"dimension": 3, "W": [[1]], "q": [1]})"));
  CHECK(begins(R"({"W": {"rows": 1}, "q": [1]})"));
  CHECK(begins(R"({"M": [[1, 2], [3, 4]], "f": [1, 2], "H": )"));
  CHECK_FALSE(begins(R"({"W": [[1, 2], [3, 4]], "q": [1, 2], "mu": 0.5, "z": [1, 2]})"));
  CHECK_FALSE(begins(R"({"M": [[3]], "q": [1], "z": [1]}
{"dimension": 3}
)"));
  CHECK_FALSE(begins(R"({"dimension": 2, "W": [[1]]})"));
  CHECK_FALSE(begins(R"([{"dimension": 3}])"));
  CHECK_FALSE(begins(R"({"a": {"dimension": 3}})"));
  CHECK_FALSE(begins("{"));
  CHECK_FALSE(begins("{\"z\": [NaN]}"));
  // Nothing that stands before the dimension hides it.
  CHECK(begins("\n{\"r\": [NaN, 1e999, -Infinity], \"title\": \"\\\"dimension\\\": 2}\", \"dimension\" : 3 }"));
  CHECK_FALSE(begins("{\"title\": \"dimension: 3\", \"dimension\": 33}"));
  // On several lines it is no record, whatever the dimension.
  CHECK(begins("{\n\"W\": [[1]], \"q\": [1], \"z\": [0]}"));
  CHECK_FALSE(begins("{\n\"h\": 1, \"f\": 2}"));
}

TEST_CASE("large problems are told from those that are judged in exact numbers") {
  CHECK(is_large(R"({"r": [NaN, 1, -Infinity], "dimension": 3, "W": [[1]], "q": [1]})"));
  CHECK(is_large(R"({"W": {"rows": 1, "columns": 1, "entries": [[0, 0, 2]]}, "q": [1]})"));
  CHECK(is_large(R"({"M": [[1]], "f": [1], "H": [[1]], "w": [0]})"));
  CHECK_FALSE(is_large(R"({"dimension": 2, "W": [[1, 2], [3, 4]], "q": [1, 2], "mu": 0.5, "z": [1, 2]})"));
  CHECK_FALSE(is_large(R"({"h": 1, "f": 2, "a": 3})"));
}

TEST_CASE("lists of numbers and of anything else are read alike") {
  const ReadProblem read = json(R"({"W": [[1, "2"], ["3", 4]], "q": [1, "2"], "z": [1, 2]})");
  CHECK(dense(read.problem.W) == Numbers{1, 2, 3, 4});
  CHECK(read.problem.q == Numbers{1, 2});
  CHECK(problem_refusal(Folder().write("p.json", R"({"W": [1, 2], "q": [1, 2], "z": [1, 2]})")) != "");
}

TEST_CASE("JSON Lines are told from one object, in one line or in several") {
  const Folder folder;
  const auto lines = [&](const std::string& text) { return is_json_lines(folder.write("p.json", text)); };
  CHECK(lines("\n {\"a\": {}} \r\n\n{\"a\": 2}\n"));
  CHECK_FALSE(lines("{\"a\": 1}\n\n"));
  CHECK_FALSE(lines("{\"a\":\n{\"b\": 1}}"));
  CHECK_FALSE(lines("{\"W\": [{}\n, {}]}\n{\"W\": 1}\n"));
  CHECK_FALSE(lines(""));
  CHECK_FALSE(lines("1,2\n{\n"));
  CHECK_FALSE(is_json_lines("/nowhere/p.json"));
}

TEST_CASE("a fraction that is no binary64 is the nearest one, and is told") {
  const auto read = read_json_problem(
      R"({"dimension": 2, "q": [1, "2/3"], "mu": 1, "W": [[1, "0x1.00000000000001p0"], [3, "1/2"]]})", "FILE");
  CHECK(read.problem.q == std::vector<double>{1, 2.0 / 3});
  CHECK(read.problem.remarks == std::vector<std::string>{"2 fractions are no binary64: the nearest is judged"});
}

TEST_CASE("malformed JSON is refused with its place or its path") {
  const std::string start = R"({"dimension": 2, "q": [1, 2], "mu": 1, "W": )";
  const std::string rows = R"({"dimension": 2, "W": [[1, 0], [0, 1]], "q": [1, 2], )";
  std::string deep = "{\"W\": ";
  deep += std::string(100000, '[');
  check_refusals(
      {
          {"{", "FILE:1:2: found no JSON object: "},
          {"{\"dimension\": 3,\n \"W\" [[1]]}", "FILE:2:6: found no JSON object: "},
          {"{\"q\": [1e999]}",
           "FILE:1:8: q[1]: found an infinity, or a number that becomes one, expected a finite number"},
          {"{\"q\": [1, \"2\", 3, 1e999x]}", "FILE:1:"},
          {"{\"q\": [01]}", "FILE:1:9: found no JSON object: "},
          {R"({"q": [1, 2], "q": [1, 2]})", "FILE:1:15: found the key 'q' twice, expected it once"},
          {"{NaN: 1}", "FILE:1:2: found NaN, expected a key"},
          {deep, "FILE:1:15: found values nested more than 8 deep"},
          {"{}", "FILE: q: found nothing, expected a list of numbers"},
          {"{} {}", "FILE:1:4: found no JSON object: "},
          {start + "1}",
           "FILE: W: found no matrix, expected a list of rows, or an object of rows, columns and entries"},
          {start + "[[1, 2]]}", "FILE: the number of rows of W: found 1, expected 2, the length of the vectors"},
          {start + "[[1, 2], [3]]}",
           "FILE: the number of columns of W[2]: found 1, expected 2, the length of the vectors"},
          {start + "[[1, 2], [3, null]]}", "FILE:1:58: W[2][2]: found no number, expected one"},
          {start + "[[1, 2], [3, NaN]]}", "FILE:1:58: W[2][2]: found NaN, expected a finite number"},
          {start + "[[1, 2], [3, -Infinity]]}", "FILE:1:58: W[2][2]: found an infinity, or a number that becomes one"},
          {start + "[[1, 2], [3, \"1e9999999\"]]}",
           "FILE:1:59: W[2][2]: found an infinity, or a number that becomes one"},
          {start + "[[1, 2], [3, \"1e4999/3\"]]}", "FILE:1:59: W[2][2]: found a '/' after a number"},
          {start + "[[1, 2], [3, \"0x1p99999999\"]]}",
           "FILE:1:59: W[2][2]: found the exponent 99999999, expected one from"},
          {start + "[[1, 2], [3, \"x\"]]}", "FILE:1:59: W[2][2]: found 'x', expected a digit"},
          {start + R"({"rows": 2, "columns": 2}})", "FILE: W: found other keys, expected rows, columns and a list of"},
          {start + R"({"rows": 2, "columns": 2, "entries": [], "x": 1}})", "FILE: W: found other keys, expected rows"},
          {start + R"({"rows": 1099511627776, "columns": 2, "entries": []}})",
           "FILE: W.rows: found 1099511627776, expected 2, the length of the vectors"},
          {start + R"({"rows": 2, "columns": -2, "entries": []}})",
           "FILE: W.columns: found no count, expected 0, 1, 2"},
          {start + R"({"rows": 2, "columns": 2.5, "entries": []}})", "FILE: W.columns: found no count, expected 0, 1"},
          {start + R"({"rows": 2, "columns": 2, "entries": [[0, 1]]}})",
           "FILE: W.entries[1]: found no entry, expected [row, column, number]"},
          {start + R"({"rows": 2, "columns": 2, "entries": [[0, 2, 1]]}})",
           "FILE: W.entries[1][2]: found 2, expected one from 0 to 2 - 1"},
          {start + R"({"rows": 2, "columns": 2, "entries": [[1, 0, 1], [1, 0, 2]]}})",
           "FILE: W: found the entry in row 2 and column 1 twice, expected it once"},
          {rows + R"("mu": -1})", "FILE: mu[1]: found -1, expected a coefficient of friction, which is not negative"},
          {rows + R"("mu": []})", "FILE: mu: found 0 numbers, expected 1"},
          {rows + R"("mu": [1, 2]})", "FILE: mu: found 2 numbers, expected 1"},
          {rows + R"("mu": {}})", "FILE: mu: found no number, expected one"},
          {rows + R"("x": 1, "mu": 1})", "FILE: x: found an unknown key, expected dimension, W, q, mu"},
          {rows + R"("Mu": 1})", "FILE: mu: found nothing, expected a coefficient of friction"},
          {rows + R"("mu": 1, "r": [1, 2, 3]})", "FILE: r, u: r: found 3 numbers, expected 2"},
          {rows + R"("mu": 1, "r": [1, 2], "z": [1, 2]})", "FILE: z: found it together with r, expected one of them"},
          {rows + R"("mu": 1, "restitution": 0})", "FILE: restitution: found it without impact, expected impact: "},
          {rows + R"("mu": 1, "impact": "hertz"})", "FILE: impact: found 'hertz', expected newton or moreau"},
          {rows + R"("mu": 1, "impact": "poisson"})",
           "FILE: impact: found 'poisson', expected newton or moreau: a record does not tell the impulses"},
          {rows + R"("mu": 1, "impact": "newton"})", "FILE: restitution: found nothing, expected a restitution"},
          {rows + R"("mu": 1, "impact": "newton", "restitution": 1})", "FILE: u_before: found nothing, expected the"},
          {rows + R"("mu": 1, "impact": "newton", "restitution": 1, "v_before": [1]})",
           "FILE: v_before: found it, expected u_before in this form"},
          {rows + R"("mu": 1, "impact": "newton", "restitution": 1.0000001, "u_before": [1, 2]})",
           "FILE: restitution[1]: found 1.0000001, expected a restitution, from 0 to 1"},
          {rows + R"("mu": 1, "impact": "newton", "restitution": [-0.5], "u_before": [1, 2]})",
           "FILE: restitution[1]: found -0.5, expected a restitution, from 0 to 1"},
          {rows + R"("mu": 1, "impact": "newton", "restitution": 1, "u_before": [1]})",
           "FILE: u_before: found 1 numbers, expected 2"},
          {R"({"W": [[1]], "q": [1], "mu": 1})", "FILE: mu: found one number for 1 components, expected 2 or 3"},
          {R"({"W": {"rows": 6, "columns": 6, "entries": []}, "q": [1,2,3,4,5,6], "mu": 1})",
           "FILE: dimension: found nothing, and one mu for 6 components, expected 2 or 3: they are of 3 contacts"},
          {R"({"dimension": 4, "W": [[1]], "q": [1], "mu": 1})", "FILE: dimension: found 4, expected 2 or 3"},
          {R"({"dimension": 2, "W": [[1]], "q": [1], "mu": 1})",
           "FILE: found 1 components, expected a multiple of the dimension 2"},
          {R"({"dimension": 2, "M": [[1]], "H": [[1, 2]], "f": [1], "w": [1, 2]})",
           "FILE: mu: found nothing, expected a"},
          {R"({"dimension": 2, "M": [[1]], "H": [[1, 2]], "f": [1], "w": [1, 2], "mu": 1, "q": [1]})",
           "FILE: q: found an unknown key, expected dimension, M, H, f, w"},
      },
      "p.json", problem_refusal);
}
