#include "mechanics/reading/read_mechanism.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <string>

#include "base/input/text_file.hpp"
#include "base/input/utf8.hpp"
#include "mechanics/checks/show.hpp"
#include "mechanics/mechanism/forms.hpp"
#include "mechanics/mechanism/names.hpp"
#include "mechanics/reading/shipped.hpp"
#include "mechanics/scene/scene.hpp"

using namespace slipproof;

namespace {

const std::filesystem::path mechanisms = SLIPPROOF_SOURCE_DIR "/cases/mechanisms";

std::string message(const auto& act) {
  try {
    act();
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

}  // namespace

TEST_CASE("a mechanism is read as it is written") {
  const Mechanism m = open_mechanism("bicycle");
  CHECK(m.name == "bicycle");
  CHECK(m.file == "bicycle.toml");
  CHECK(m.parameters.size() == 15);
  CHECK(m.parameters[11].symbol == "J");
  CHECK(m.parameters[11].optional);
  CHECK(m.parameters[11].unit == "kg m^2");
  CHECK(to_string(m.parameters[2].domain.expression) == "h > -R");
  CHECK(m.accelerations == 6);
  CHECK(m.forces == 1);
  CHECK_FALSE(m.by_virtual_work);
  CHECK(m.contacts[1].lift_needs == std::vector<std::size_t>{11});
  CHECK(acceleration_names(m) ==
        std::vector<std::string>{"a", "a_y", "phi", "eps1", "eps2", "eps3", "gap2", "slip2", "gap3", "slip3"});
  CHECK(force_names(m) == std::vector<std::string>{"T", "N2", "S2", "N3", "S3"});
  CHECK(m.equations[2].left.place() == Place{52, 10});
  CHECK(m.contacts[0].gap.place() == Place{60, 8});
}

TEST_CASE("defaults are those of the format") {
  const Mechanism m = parse_mechanism(
      "schema = \"slipproof/mechanism/1\"\nname = \"least\"\n[parameters]\nm = \"m > 0\"\nb = {}\n[unknowns]\n"
      "accelerations = [\"y\"]\n[motion]\ny = \"m*y = -m*b\"\n[[contact]]\nname = \"floor\"\ngap = \"y\"\n",
      "least.toml");
  CHECK(m.parameters[1].domain.expression->truth);
  CHECK_FALSE(m.load);
  CHECK(m.reciprocal);
  CHECK(m.contacts[0].frictionless());
  CHECK_FALSE(m.contacts[0].slip);
  CHECK(force_names(m) == std::vector<std::string>{"N_floor"});
  CHECK(acceleration_names(m) == std::vector<std::string>{"y", "gap_floor"});
  CHECK(to_string(m.equations[0].whole_right()) == "-m * b + N_floor");
  CHECK(mode_count(element_kinds(m)) == 2);
}

TEST_CASE("contact forces are added on the right by virtual work") {
  const Mechanism m = open_mechanism("block-shaken");
  CHECK(to_string(m.equations[0].whole_right()) == "S1 + S2");
  CHECK(to_string(m.equations[1].whole_right()) == "-m * g + N1 + N2");
  CHECK(to_string(m.equations[2].whole_right()) == "-b * N1 + h * S1 + b * N2 + h * S2");
  CHECK(to_string(m.contacts[0].slip_form.load) == "-g");
}

TEST_CASE("every shipped mechanism is found by name, has a scene, and is shown in 80 columns") {
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(mechanisms)) {
    if (entry.path().extension() != ".toml") continue;
    ++files;
    const std::string stem = entry.path().stem().string();
    CAPTURE(stem);
    const ShippedMechanism* shipped = find_shipped(stem);
    REQUIRE(shipped != nullptr);
    CHECK(shipped->text == read_text_file(entry.path()));
    const Mechanism m = open_mechanism(stem);
    CHECK_FALSE(m.source.empty());
    CHECK(shipped->text.starts_with("# Shows: "));
    const MechanismScene scene = read_scene(mechanisms / "scenes" / (stem + ".toml"));
    CHECK(scene.mechanism.name == m.name);
    const auto findings = check_mechanism(m);
    CHECK(std::ranges::none_of(findings, &MechanismFinding::checkable));
    const std::string text = show_text(m, findings);
    for (std::size_t start = 0; start < text.size();) {
      const std::size_t end = text.find('\n', start);
      CHECK(utf8_count(text.substr(start, end - start)) <= 80);
      start = end + 1;
    }
    for (const MechanismParameter& p : m.parameters) CHECK(text.find("\n  " + p.symbol + " ") != text.npos);
  }
  CHECK(files == shipped_mechanisms().size());
  CHECK(files >= 13);
}

TEST_CASE("a file is preferred to a shipped mechanism, and a name that is neither is told") {
  const Mechanism file = open_mechanism("block-shaken.toml", mechanisms.string());
  CHECK(file.file == (mechanisms / "block-shaken.toml").string());
  CHECK(message([] { open_mechanism("block-shaking"); }) ==
        "no such file, and unknown mechanism 'block-shaking', did you mean 'block-shaken'?");
  CHECK(message([] { open_mechanism("ladderr"); }) ==
        "no such file, and unknown mechanism 'ladderr', did you mean 'ladder'?");
  CHECK(message([] { open_mechanism("gone.toml"); }).starts_with("gone.toml: "));
}

TEST_CASE("another parameter becomes the load if it multiplies no unknown") {
  const Mechanism m = open_mechanism("block-shaken");
  CHECK(message([&] { with_load(m, "m"); }) ==
        "block-shaken.toml:28:8: ax: not linear: 'm * ax' multiplies the load m by the unknown ax\n"
        "block-shaken.toml:29:8: ay: not linear: 'm * ay' multiplies the load m by the unknown ay");
  CHECK(message([&] {
          with_load(m, "mu");
        }).find("friction: not linear: 'mu * N1' multiplies the load mu by the unknown N1") != std::string::npos);
  CHECK(message([&] { with_load(m, "mm"); }) == "block-shaken.toml: unknown parameter 'mm', did you mean 'm'?");
  CHECK(message([&] { with_load(m, "g"); }).find("'A * g' multiplies the load A by") == std::string::npos);
  const Mechanism ladder = with_load(open_mechanism("ladder"), "d");
  CHECK(ladder.load->symbol == "d");
  CHECK(to_string(ladder.load->domain[0].expression) == "-l <= d and d <= l");
  CHECK(ladder.parameters.back().symbol == "W");
  CHECK(to_string(ladder.parameters.back().domain.expression) == "W >= 0");
  CHECK(to_string(ladder.equations[2].form.load) == "-W * c");
  CHECK(with_load(open_mechanism("ladder"), "W").load->symbol == "W");
}

TEST_CASE("with a load that definitions depend on, they are written out") {
  const std::string text =
      "schema = \"slipproof/mechanism/1\"\nname = \"x\"\n[parameters]\nm = \"m > 0\"\nP = \"P < m\"\nQ = \"Q > P\"\n"
      "[definitions]\nk = \"2*P\"\nW = \"m*3 + k/m\"\n[unknowns]\naccelerations = [\"y\"]\n[motion]\ny = \"m*y = -W + "
      "P\"\n"
      "[[contact]]\nname = \"floor\"\ngap = \"y\"\n";
  const Mechanism m = with_load(parse_mechanism(text, "x.toml"), "P");
  CHECK(to_string(m.equations[0].form.load) == "-(-2 / m + 1)");
  CHECK(m.load->domain.size() == 2);  // its own, and what Q says of it
}
