#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "proofs/check_contact/files.hpp"
#include "support/run_program.hpp"

using slipproof::test::last_line;
using slipproof::test::run;

namespace {

const std::string rest_scenes = SLIPPROOF_SOURCE_DIR "/cases/mechanisms/scenes/";

}  // namespace

TEST_CASE("rest says whether a scene can rest, must, and up to where") {
  const std::string scene = rest_scenes + "block-on-incline.toml";
  const auto text = run({"rest", scene});
  CHECK(text.exit_code == 0);
  CHECK(last_line(text.out) == "s CAN REST\n");
  CHECK(text.out.find("F: it can rest from -981/250 up to 30411/250") != std::string::npos);
  const auto document = nlohmann::json::parse(run({"rest", scene, "--json", "--parameter", "mu_s"}).out);
  CHECK(document["schema"] == "slipproof/rest/1");
  CHECK(document["can_rest"] == true);
  CHECK(document["must_rest"] == false);  // it may slide, with the smaller kinetic coefficient
  CHECK(document["other_motions"].size() == 1);
  CHECK(document["load"]["to"] == nlohmann::json::array({"30411/250", "30411/250"}));
  CHECK(document["parameter"]["from"] == nlohmann::json::array({"3/4", "3/4"}));
  CHECK(document["parameter"]["to"].is_null());
  CHECK(run({"rest", scene, "--fail-on", "can-move"}).exit_code == 1);

  const auto falls = run({"rest", scene, "--load", "200"});
  CHECK(falls.exit_code == 1);
  CHECK(last_line(falls.out) == "s CANNOT REST\n");
  CHECK(falls.out.find("ay  4/5") != std::string::npos);
  CHECK(run({"rest", scene, "--load", "200", "--fail-on", "none"}).exit_code == 0);
}

TEST_CASE("what rest proves is in a certificate that the checker accepts") {
  const slipproof::test::TemporaryFolder folder;
  for (const std::string load : {"0", "200"}) {
    const std::string file = (folder.path() / "rest.cert").string();
    run({"rest", rest_scenes + "block-on-incline.toml", "--load", load, "--certificate", file});
    const auto verdict = slipproof::check_contact::check_contact_file(file, "");
    CHECK(verdict.kind == slipproof::check_contact::ContactVerdict::Kind::accepted);
    CHECK(verdict.message.starts_with(load == "0" ? "it can rest" : "it cannot rest"));
  }
}

TEST_CASE("rest maps two loads, and draws the map") {
  const slipproof::test::TemporaryFolder folder;
  const std::string table = SLIPPROOF_SOURCE_DIR "/cases/rest/table-pulled-at-its-edge.toml";
  const std::string picture = (folder.path() / "map.svg").string();
  const auto document = nlohmann::json::parse(run({"rest", table, "--map", "H", "P", "-o", picture, "--json"}).out);
  const auto& map = document["map"];
  CHECK(map["exact"] == true);
  CHECK(map["inside"].size() == 4);
  CHECK(map["borders"].size() == 4);
  CHECK(map["inside"][0]["forces"].contains("N_left"));
  CHECK(map["borders"][0]["motion"].contains("alpha"));
  CHECK(slipproof::test::read_file(picture).find("a table that is pulled") != std::string::npos);
  CHECK(run({"rest", table, "--map", "H", "mu"}).exit_code == 3);
  CHECK(run({"rest", table, "--map", "H"}).exit_code == 2);
  CHECK(run({"rest", table, "-o", picture}).exit_code == 2);
  CHECK(run({"rest", table, "--map", "H", "P", "--x-range", "3", "2"}).exit_code == 2);
}

TEST_CASE("draw shows the forces that hold a scene, or the virtual motion that proves its fall") {
  const std::string scene = rest_scenes + "block-on-incline.toml";
  CHECK(run({"draw", scene, "--motion", "rest", "--load", "0"}).out.find("forces that hold it") != std::string::npos);
  const std::string falls = run({"draw", scene, "--motion", "rest", "--load", "200"}).out;
  CHECK(falls.find("a virtual motion that proves its fall") != std::string::npos);
  CHECK(falls.find("green: the virtual motion") != std::string::npos);
  const std::string space = SLIPPROOF_SOURCE_DIR "/cases/rest/three-legged-table.toml";
  CHECK(run({"draw", space, "--motion", "rest", "--load", "100"}).out.find("proves its fall") != std::string::npos);
  const std::string in_space =
      run({"draw", SLIPPROOF_SOURCE_DIR "/cases/rest/three-legged-table.toml", "--motion", "rest", "--load", "100"})
          .out;
  for (const char* words : {">virtual motion<", "moves at a rate of", "turns at a rate of"}) {
    CHECK(in_space.find(words) != std::string::npos);
  }
  for (const char* words : {">acceleration<", "m/s²", "N_left"}) CHECK(in_space.find(words) == std::string::npos);
}

TEST_CASE("rest refuses what moves, and questions that a scene does not fit") {
  const auto moves = run({"rest", rest_scenes + "painleve-rod.toml"});
  CHECK(moves.exit_code == 3);
  CHECK(moves.err.find("the scene moves, expected one at rest") != std::string::npos);
  const std::string ladder = rest_scenes + "ladder.toml";
  CHECK(run({"rest", ladder, "--load", "much"}).exit_code == 2);
  CHECK(run({"rest", ladder, "--load", "-1"}).exit_code == 2);
  CHECK(run({"rest", ladder, "--tilt", "1,2"}).exit_code == 2);
  CHECK(run({"rest", ladder, "--tilt", "1,0,0"}).exit_code == 3);
  CHECK(run({"rest", ladder, "--fail-on", "everything"}).exit_code == 2);
  const auto unknown = run({"rest", ladder, "--parameter", "mu"});
  CHECK(unknown.exit_code == 3);
  CHECK(unknown.err.find("unknown parameter 'mu'") != std::string::npos);
}
