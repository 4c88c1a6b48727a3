#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "support/replaced.hpp"
#include "support/run_program.hpp"

using slipproof::test::last_line;
using slipproof::test::read_file;
using slipproof::test::replaced;
using slipproof::test::run;
using slipproof::test::TemporaryFolder;
using Json = nlohmann::json;

namespace {

const std::string shipped = SLIPPROOF_SOURCE_DIR "/proofs/rozenblat-yashin/claims.toml";

}  // namespace

TEST_CASE("the shipped paper is the default; every verdict as expected exits with 0") {
  const auto verified = [](const std::vector<std::string>& more) {
    std::vector<std::string> all{"verify", "--samples", "120", "--lines", "0", "--only", "A5"};
    all.insert(all.end(), more.begin(), more.end());
    return run(all);
  };
  const auto json = verified({"--json"});
  CHECK(json.exit_code == 0);
  CHECK(json.err.empty());  // no progress bar where there is no terminal
  const Json document = Json::parse(json.out);
  CHECK(document["schema"] == "slipproof/verify/1");
  CHECK(document["samples"] == 120);
  CHECK(document["seed"] == 1);
  bool found = false;
  for (const Json& claim : document["claims"]) {
    for (const char* key : {"id", "reading", "verdict", "expected", "samples", "counterexample"}) {
      CHECK(claim.contains(key));
    }
    if (claim["id"] != "A5.1" || claim["reading"] != "printed") continue;
    found = true;
    CHECK(claim["verdict"] == "refuted");
    CHECK(claim["expected"] == "refuted");
    CHECK(claim["counterexample"]["motions"].size() == 3);
    // The counterexample is a scene: `solve` finds the same motions in it.
    const TemporaryFolder folder;
    const auto scene = folder.write("scene.toml", claim["counterexample"]["scene"].get<std::string>());
    const auto solved = run({"solve", "--json", scene});
    REQUIRE(solved.exit_code == 0);
    CHECK(Json::parse(solved.out)["motions"] == claim["counterexample"]["motions"]);
  }
  CHECK(found);
  CHECK(verified({"--json", "--threads", "1"}).out == json.out);
  CHECK(verified({"--json", "--threads", "64", shipped}).out == json.out);
  CHECK(last_line(verified({}).out).starts_with("s VERIFIED "));
}

TEST_CASE("an unexpected refutation exits with 1, an undecided claim with 4") {
  const TemporaryFolder folder;
  const std::string text = read_file(shipped);
  const auto wrong = folder.write("wrong.toml", replaced(text, "0 < F*sigma < xi1", "0 < F*sigma < 2*xi1"));
  const auto refuted = run({"verify", "--only", "A1", "--samples", "120", wrong});
  CHECK(refuted.exit_code == 1);
  CHECK(last_line(refuted.out).starts_with("s REFUTED "));
  const auto unclear = folder.write("unclear.toml", replaced(text, "0 < F*sigma < xi1", "0 < F*sigma < xi1/(b - b)"));
  const auto undecided = run({"verify", "--only", "A1", "--samples", "120", "--quiet", unclear});
  CHECK(undecided.exit_code == 4);
  CHECK(undecided.out.starts_with("s UNDECIDED "));
}

TEST_CASE("proved claims name their certificates, and a tampered one exits with 5") {
  const TemporaryFolder folder;
  const std::filesystem::path proofs = std::filesystem::path(shipped).parent_path();
  folder.write("claims.toml", read_file(proofs / "claims.toml"));
  std::filesystem::create_directory(folder.path() / "certificates");
  for (const std::string name : {"A1.1.always.statement", "A1.1.always.cert", "A1.1.only-then.statement",
                                 "A1.1.only-then.cert", "A1.1.defined.statement", "A1.1.defined.cert"}) {
    folder.write("certificates/" + name, read_file(proofs / "claims.theorems" / name));
  }
  const auto claims = folder.path() / "claims.toml";
  const std::vector<std::string> text{"verify", "--samples", "100", "--only", "A1.1", claims};
  const std::vector<std::string> json{"verify", "--samples", "100", "--only", "A1.1", "--json", claims};
  CHECK(run(text).exit_code == 0);
  CHECK(run(text).out.find("by A1.1.always.cert\n") != std::string::npos);
  Json claim = Json::parse(run(json).out)["claims"][0];
  CHECK(claim["verdict"] == "proved");
  CHECK(claim["certificates"] == Json{"A1.1.only-then.cert", "A1.1.always.cert", "A1.1.defined.cert"});
  CHECK_FALSE(claim.contains("rejected"));

  folder.write("certificates/A1.1.always.cert",
               replaced(read_file(proofs / "claims.theorems/A1.1.always.cert"), "\nterm 1 ", "\nterm 2 "));
  for (const std::string more : {"--quiet", "--errata", "--seed=1"}) {
    auto arguments = text;
    arguments.push_back(more);
    const auto rejected = run(arguments);
    CHECK(rejected.exit_code == 5);
    CHECK(rejected.err.find("certificate rejected: ") != std::string::npos);
    CHECK(rejected.err.find("A1.1.always.cert:") != std::string::npos);
    if (more != "--errata") CHECK(last_line(rejected.out).starts_with("s REJECTED "));
  }
  const auto rejected = run(json);
  CHECK(rejected.exit_code == 5);
  claim = Json::parse(rejected.out)["claims"][0];
  CHECK(claim["verdict"] == "holds");
  CHECK(claim["certificates"].empty());
  CHECK(claim["rejected"].size() == 1);
  CHECK(run({"verify", "--samples", "100", "--only", "A1.2", claims}).exit_code == 0);  // no claim that it is about
}

TEST_CASE("--only of a folder judges the papers that have such a claim") {
  const std::string folder = std::filesystem::path(shipped).parent_path().parent_path().string();
  const auto some = run({"verify", folder, "--only", "E4.7", "--samples", "40", "--lines", "0"});
  CHECK(some.exit_code == 0);
  CHECK(some.out.find("rozenblat-yashin") != std::string::npos);
  CHECK(some.out.find("ladder") == std::string::npos);
  CHECK(last_line(some.out).starts_with("s VERIFIED "));
  const auto none = run({"verify", folder, "--only", "Zz"});
  CHECK(none.exit_code == 3);
  CHECK(none.err.find("found no claim whose id begins with 'Zz' in its papers") != std::string::npos);
  const auto one = run({"verify", folder + "/rozenblat-yashin", "--only", "E4.7", "--samples", "40", "--lines", "0"});
  CHECK(one.out.find("by E4.7.1.refuted.cert\n") != std::string::npos);
}

TEST_CASE("many certificates of a claim are counted, and named when asked for; words are explained") {
  const auto brief = run({"verify", "--only", "A5.2", "--samples", "40", "--lines", "0"}).out;
  const auto whole = run({"verify", "--only", "A5.2", "--samples", "40", "--lines", "0", "--names"}).out;
  const auto lines = [](const std::string& text) { return std::count(text.begin(), text.end(), '\n'); };
  CHECK(lines(brief) < 22);
  CHECK(lines(whole) > lines(brief) + 45);  // the repaired claim has 51
  CHECK(brief.find(" certificates, A5.2.") != std::string::npos);
  CHECK(brief.find("; --names lists them\n") != std::string::npos);
  CHECK(whole.find("--names") == std::string::npos);
  CHECK(brief.find("An equation is tried at every 17th") != std::string::npos);
}

TEST_CASE("certificates that a claims file asks for and that are not there are missing, in every form of output") {
  const TemporaryFolder folder;
  const std::filesystem::path proofs = std::filesystem::path(shipped).parent_path();
  for (const char* file : {"claims.toml", "second-opinions.csv", "figures.toml"}) {
    folder.write(file, read_file(proofs / file));
  }
  folder.write("by-hand.theorems", read_file(proofs / "by-hand.theorems"));
  const auto output = [&](const std::vector<std::string>& more) {
    std::vector<std::string> all{"verify", "--samples", "40",   "--lines",
                                 "0",      "--only",    "A1.1", folder.path() / "claims.toml"};
    all.insert(all.end(), more.begin(), more.end());
    return run(all).out;
  };
  const std::string text = output({});
  CHECK(text.find("      missing A1.1.only-then, A1.1.always, A1.1.defined\n") != std::string::npos);
  CHECK(last_line(text).find(" missing ") != std::string::npos);
  const Json json = Json::parse(output({"--json"}));
  const std::size_t missing = json["missing"];
  CHECK(missing > 3);  // A1.1a, too
  REQUIRE(json["claims"][0]["unproved"].size() == 3);
  CHECK(json["claims"][0]["unproved"][0]["state"] == "missing");
  const std::string sentence = std::to_string(missing) + " certificates that the claims file asks for are missing";
  CHECK(output({"--errata"}).find(sentence) != std::string::npos);
  CHECK(output({"--errata", "--markdown"}).find(sentence) != std::string::npos);
  const Json sarif = Json::parse(output({"--sarif"}));
  CHECK(sarif["runs"][0]["properties"]["missing"] == missing);
  const std::string page = (folder.path() / "page.html").string();
  output({"--report", page});
  CHECK(read_file(page).find(sentence) != std::string::npos);
  CHECK(read_file(page).find("No proof of A1.1.always: missing; there is no such statement<") != std::string::npos);
}

TEST_CASE("the errata of some claims show a misprint as those of all claims do, or not at all") {
  const auto wrong = [](const std::vector<std::string>& more) {
    std::vector<std::string> all{"verify", "--samples", "60", "--lines", "0", "--errata", "--json"};
    all.insert(all.end(), more.begin(), more.end());
    const Json errata = Json::parse(run(all).out);
    for (const Json& finding : errata["findings"]) {
      if (finding["id"] == "3.1.b1") return finding["wrong"].get<std::string>();
    }
    return std::string();
  };
  const std::string whole = wrong({});
  const std::string shown = whole.substr(0, whole.find(": "));  // the claim that shows it
  const std::string part = wrong({"--only", "A5.1"});
  CHECK(part.starts_with("claims that use it fail, as " + shown + " shows, which was not judged"));
  const std::string same = wrong({"--only", shown});
  CHECK(same.substr(0, same.find(" (")) == whole.substr(0, whole.find(" (")));
}

TEST_CASE("malformed claims exit with 3 and name the place") {
  const TemporaryFolder folder;
  const std::string text = read_file(shipped);
  const std::vector<std::pair<std::string, std::string>> mistakes{
      {replaced(text, "0 < F*sigma < xi1", "0 < F*sigma < xi9"), "xi9"},
      {replaced(text, "0 < F*sigma < xi1", "0 < F*sigma <"), "expected"},
      {replaced(text, "kind = \"interval\"", "kind = \"intervall\""), "interval"},
      {replaced(text, "mode = \"stick/stick\"", "mode = \"stick/stuck\""), "stuck"},
      {"schema = \"slipproof/claims/7\"\n", "slipproof/claims/1"},
      {"[[claim\n", "bad.toml:"},
      {"", "schema"}};
  for (const auto& mistake : mistakes) {
    const auto outcome = run({"verify", folder.write("bad.toml", mistake.first)});
    CHECK(outcome.exit_code == 3);
    CHECK(outcome.out.empty());
    CHECK(outcome.err.find("bad.toml:") != std::string::npos);
    CAPTURE(outcome.err);
    CHECK(outcome.err.find(mistake.second) != std::string::npos);
  }
  CHECK(run({"verify", "/nonexistent/claims.toml"}).exit_code == 3);
}

TEST_CASE("usage errors of verify exit with 2") {
  for (const std::vector<std::string>& arguments :
       std::vector<std::vector<std::string>>{{"verify", "--samples", "0"},
                                             {"verify", "--samples", "many"},
                                             {"verify", "--seed", "-1"},
                                             {"verify", "--threads", "x"},
                                             {"verify", "--threads", "-1"},
                                             {"verify", "--frobnicate"}}) {
    CHECK(run(arguments).exit_code == 2);
  }
}

TEST_CASE("mutants of a claims file are judged, with lemmas that the checker accepts") {
  const TemporaryFolder folder;
  const std::string lemmas = (folder.path() / "lemmas").string();
  const std::string claims = SLIPPROOF_SOURCE_DIR "/proofs/rear-drive/claims.toml";
  const auto text = run({"verify", claims, "--mutants", "--every", "29", "--lemmas", lemmas});
  CHECK(text.exit_code == 0);
  CHECK(text.out.find("make a claim fail") != std::string::npos);
  CHECK(last_line(text.out).starts_with("s TIGHT mutants 75 refuted "));
  const auto checked = run({lemmas}, "slipproof-check");
  CHECK(checked.exit_code == 0);
  CHECK(last_line(checked.out).starts_with("s ACCEPTED"));
  const Json json = Json::parse(run({"verify", claims, "--mutants", "--every", "145", "--json"}).out);
  CHECK(json["schema"] == "slipproof/mutants/1");
  CHECK(json["mutants"].size() == 15);
  CHECK(json["counts"]["survivor"] == 0);
  for (const Json& mutant : json["mutants"]) CHECK(mutant.contains("claim"));
  CHECK(run({"verify", claims, "--mutants", "--errata"}).exit_code == 2);
  CHECK(run({"verify", claims, "--mutants", "--only", "A"}).exit_code == 2);
  CHECK(run({"verify", claims, "--every", "2"}).exit_code == 2);
}
