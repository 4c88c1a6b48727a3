#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "base/input/utf8.hpp"
#include "support/run_program.hpp"

using namespace slipproof::test;
using Json = nlohmann::json;

namespace {

double fraction(const std::string& text) {
  const std::size_t bar = text.find('/');
  return std::stod(text) / (bar == std::string::npos ? 1 : std::stod(text.substr(bar + 1)));
}

}  // namespace

TEST_CASE("search: the last line says what was found, or that nothing was, and unique only with a proof") {
  const TemporaryFolder folder;
  const std::string file =
      folder
          .write("sled.toml",
                 "schema = \"slipproof/mechanism/1\"\nname = \"sled\"\n[parameters]\nm = \"m > 0\"\nmu = \"mu >= 0\"\n"
                 "g = \"g > 0\"\n[load]\nsymbol = \"F\"\n[unknowns]\naccelerations = [\"ax\", \"ay\"]\n[motion]\n"
                 "ax = \"m*ax = F\"\nay = \"m*ay = -m*g\"\n[[contact]]\nname = \"floor\"\ngap = \"ay\"\nslip = \"ax\"\n"
                 "friction = \"mu\"\n")
          .string();
  const auto sled = run({"search", file, "--samples", "20"});
  CHECK(sled.exit_code == 0);
  CHECK(last_line(sled.out).starts_with("s UNIQUE samples 20 one 20 none 0 "));
  CHECK(last_line(sled.out).ends_with(" by theorem 1 of two-wheeler\n"));
  const auto block = run({"search", "block-on-incline", "--samples", "20"});
  CHECK(block.exit_code == 0);
  CHECK(last_line(block.out).starts_with("s NONE FOUND samples 20 one 20 none 0 "));
  const auto rod = run({"search", "painleve-rod", "--samples", "100"});
  CHECK(rod.exit_code == 1);
  CHECK(last_line(rod.out).starts_with("s FOUND samples 100 one "));
  CHECK(rod.err.empty());
  CHECK(run({"search", "painleve-rod", "--for", "none"}).exit_code == 1);
  // From mu = 4/3 on there are several, which few samples meet.
  const std::vector<std::string> near{"search", "painleve-rod", "--samples",
                                      "40",     "--within",     "3*I = m*l^2 and mu < 1.35"};
  const auto missed = run(near);
  CHECK(missed.exit_code == 0);
  CHECK(last_line(missed.out).starts_with("s NONE FOUND samples 40 one 40 "));
  const auto below = run({"search", "painleve-rod", "--for", "none", "--within", "mu < 1 and 3*I = m*l^2"});
  CHECK(below.exit_code == 0);
  CHECK(last_line(below.out) == "s NONE FOUND samples 2000 for none\n");
  const auto empty = run({"search", "ladder", "--within", "mu_f < mu_w and mu_w < mu_f", "--samples", "5"});
  CHECK(empty.exit_code == 4);
  CHECK(last_line(empty.out).starts_with("s UNDECIDED samples 0 "));
}

TEST_CASE("search: mistakes are told, with nothing on standard output") {
  const auto within = run({"search", "ladder", "--within", "mu_f < 1 and q > 0"});
  CHECK(within.exit_code == 3);
  CHECK(within.out.empty());
  CHECK(within.err.starts_with("--within:1:14: "));
  CHECK(run({"search", "ladder", "--within", ""}).exit_code == 3);
  CHECK(run({"search", "no-such-thing"}).exit_code == 3);
  CHECK(run({"search", "ladder", "--for", "one"}).exit_code == 2);
  CHECK(run({"search", "ladder", "--samples", "0"}).exit_code == 2);
  CHECK(run({"search"}).exit_code == 2);
}

TEST_CASE("search: text has 80 columns, --quiet its last line, JSON the same counts") {
  const std::vector<std::string> call{"search", "ladder", "--samples", "100"};
  const auto with = [&](const char* option) {
    auto longer = call;
    longer.emplace_back(option);
    return run(longer);
  };
  const auto text = run(call), quiet = with("--quiet"), json = with("--json");
  std::istringstream lines(text.out);
  for (std::string line; std::getline(lines, line);) CHECK(slipproof::utf8_count(line) <= 80);
  CHECK(quiet.out == last_line(text.out));
  const Json document = Json::parse(json.out);
  CHECK(document["schema"] == "slipproof/search/1");
  CHECK(document["samples"] == 100);
  std::size_t longest = 0;
  for (const Json& cell : document["cells"]) {
    CHECK(cell["motions"] == cell["modes"].size() + cell["on_boundary"].get<std::size_t>());
    CHECK(cell["simplest"].contains("W"));
    CHECK(cell["simplest"]["theta"].contains("cos"));
    longest = std::max(longest, cell["samples"].get<std::size_t>());
  }
  CHECK(longest <= 100);
  CHECK(longest > 50);
}

TEST_CASE("search in space: places without a motion and with several, which one works out by hand; never unique") {
  const std::string space = SLIPPROOF_SOURCE_DIR "/cases/space/mechanisms/";
  const std::vector<std::string> rod{"search",   space + "leaning-rod.toml", "--samples", "40", "--json",
                                     "--within", "g = 10 and mu = 1"};
  const auto found = run(rod);
  CHECK(found.exit_code == 1);
  const Json document = Json::parse(found.out);
  CHECK(document["verdict"] == "found");
  CHECK(document["proof"].is_null());
  CHECK(document["samples"] == 40);
  CHECK(document["one"].get<int>() + document["none"].get<int>() + document["several"].get<int>() +
            document["continuum"].get<int>() + document["undecided"].get<int>() ==
        40);
  REQUIRE(document["several"] > 0);
  // W_NN = 7/2, W_NT = 5, W_TT = 11: where friction presses a slipping foot down, mu > 7/10, it may lift, as 5 F >= g,
  // and also slip by 9 F - 4 (5 F - g) at mu = 1, with N = (5 F - g)/(3/2).
  const Json* several = nullptr;
  for (const Json& cell : document["cells"]) {
    if (several == nullptr && cell["motions"] > 1) several = &cell;
  }
  REQUIRE(several != nullptr);
  const auto number = [&](const char* name) { return fraction((*several)["simplest"][name].get<std::string>()); };
  CHECK(number("mu") == 1);
  CHECK(5 * number("F") >= 10);
  CHECK(11 * number("F") <= 40);
  const auto low = run({"search", space + "leaning-rod.toml", "--samples", "20", "--within", "mu < 7/10"});
  CHECK(low.exit_code == 0);
  CHECK(last_line(low.out) == "s NONE FOUND samples 20 one 20 none 0 several 0 continuum 0 hysteresis 0 undecided 0\n");
  const auto one_load =
      run({"search", space + "leaning-rod.toml", "--samples", "5", "--within", "F = 3 and mu = 1 and g = 10"});
  CHECK(last_line(one_load.out) == "s FOUND samples 5 one 0 none 0 several 5 continuum 0 hysteresis 0 undecided 0\n");
}

TEST_CASE("search of an impact: where its law gains energy, and `impact` says the same there") {
  const std::string rod = SLIPPROOF_SOURCE_DIR "/proofs/impacts/rod.toml";
  const auto found = run({"search", rod, "--samples", "60", "--json"});
  CHECK(found.exit_code == 1);
  const Json document = Json::parse(found.out);
  CHECK(document["one"] == 60);
  CHECK(document["gain"] > 0);
  const Json cell = document["cells"][0];
  REQUIRE(cell["gains_energy"] == true);
  const TemporaryFolder folder;
  std::string scene = "name = \"found\"\nmechanism = \"" + rod + "\"\n[values]\n";
  for (const auto& [name, value] : cell["simplest"].items()) {
    scene += value.is_string() ? name + " = " + value.dump() + "\n"
                               : name + " = { cos = " + value["cos"].dump() + ", sin = " + value["sin"].dump() + " }\n";
  }
  const Json there = Json::parse(run({"impact", folder.write("found.toml", scene).string(), "--json"}).out);
  CHECK(there["before"]["energy"] == cell["energy"]["before"]);
  CHECK(there["outcomes"][0]["energy"] == cell["energy"]["outcomes"][0]["after"]);
  CHECK(there["outcomes"][0]["gains_energy"] == true);
  CHECK(fraction(cell["energy"]["outcomes"][0]["gain"]) > 0);
  CHECK(document["cells"].back()["energy"].is_null());
  const auto moreau = run({"search", rod, "--samples", "60", "--law", "moreau", "--for", "gain"});
  CHECK(moreau.exit_code == 1);  // the same for a contact that approaches alone
  const std::string one_restitution = SLIPPROOF_SOURCE_DIR "/proofs/impacts/rod-moreau.toml";
  const auto none = run({"search", one_restitution, "--samples", "60"});
  CHECK(none.exit_code == 0);
  CHECK(last_line(none.out).ends_with(" gain 0\n"));
}

TEST_CASE("search of an impact in space, and of what is none") {
  const TemporaryFolder folder;
  // bar-that-gains: 2 before, 104/27 after, which does not depend on where the bar is.
  const std::string bar =
      "schema = \"slipproof/mechanism/1\"\nname = \"bar\"\ndimension = 3\ngravity = \"none\"\n[impact]\n"
      "law = \"moreau\"\n[[body]]\nname = \"bar\"\nmass = \"1\"\ninertia = [\"1/3\", \"1/3\", \"1/3\"]\n"
      "at = [\"0\", \"0\", \"0\"]\nvelocity = [\"0\", \"0\", \"-1\"]\nspin = [\"0\", \"-3\", \"0\"]\n";
  const auto stop = [](const std::string& name, const std::string& x, const std::string& restitution) {
    const std::string point = "[\"" + x + "\", \"0\", \"0\"]\n";
    return "[[contact]]\nname = \"" + name + "\"\nof = \"bar\"\npoint = " + point + "through = " + point +
           "normal = [\"0\", \"0\", \"1\"]\nrestitution = \"" + restitution + "\"\n";
  };
  const std::string file = folder.write("bar.toml", bar + stop("left", "-1", "1") + stop("right", "2", "0")).string();
  const Json space = Json::parse(run({"search", file, "--samples", "2", "--json"}).out);
  CHECK(space["verdict"] == "found");
  CHECK(space["gain"] == 2);
  CHECK(space["cells"][0]["energy"]["before"] == "2");
  CHECK(space["cells"][0]["energy"]["outcomes"][0]["after"] == "104/27");
  CHECK(space["cells"][0]["energy"]["outcomes"][0]["gain"] == "50/27");
  const auto poisson = run({"search", file, "--law", "poisson"});
  CHECK(poisson.exit_code == 3);
  CHECK(poisson.err.find("Poisson's law, whose two phases only `slipproof impact` solves") != std::string::npos);
  const auto none = run({"search", "ladder", "--for", "gain"});
  CHECK(none.exit_code == 3);
  CHECK(none.err.find("found no impact, which alone may gain energy") != std::string::npos);
  CHECK(run({"search", "ladder", "--law", "newton"}).exit_code == 3);
  CHECK(run({"search", file, "--law", "hertz"}).exit_code == 2);
}
