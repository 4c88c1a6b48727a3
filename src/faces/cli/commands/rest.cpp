#include "contact/rest/rest.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/input/diagnostic.hpp"
#include "base/output/output_file.hpp"
#include "contact/rest/rest_certificate.hpp"
#include "faces/cli/command.hpp"
#include "faces/cli/load_option.hpp"
#include "faces/cli/png.hpp"
#include "faces/cli/warnings.hpp"
#include "report/planes/rest_map_svg.hpp"
#include "report/scenes/rest_report.hpp"

namespace slipproof::cli {

namespace {

struct RestArguments {
  CommonOptions common;
  std::string scene, load, tilt, parameter, certificate, out;
  std::vector<std::string> map, x_range, y_range;
  std::vector<std::string> fail_on{"cannot-rest"};
  std::uint64_t effort = RestQuestions().effort;
  int digits = 6;
};

[[noreturn]] void refuse(const RestArguments& arguments, const std::string& message) {
  throw InputError({{arguments.scene, 0, 0, message}});
}

/// `x,y,z`; nothing: z, the axis of the plane.
std::array<Rational, 3> axis_of(const std::string& text) {
  if (text.empty()) return {0, 0, 1};
  std::vector<std::string> parts{""};
  for (const char c : text) {
    if (c == ',') {
      parts.emplace_back();
    } else {
      parts.back().push_back(c);
    }
  }
  if (parts.size() != 3) throw CLI::ValidationError("--tilt", "found " + text + ", expected an axis x,y,z");
  return {number_of("--tilt", parts[0]), number_of("--tilt", parts[1]), number_of("--tilt", parts[2])};
}

int exit_code_of(const RestAnswer& answer, const std::vector<std::string>& fail_on) {
  const auto fails = [&](const char* word) { return std::ranges::find(fail_on, word) != fail_on.end(); };
  const std::optional<bool> can = answer.decision.can;
  if (can == false && fails("cannot-rest")) return refuted_or_not_certified;
  if (answer.decision.touching && fails("touching")) return refuted_or_not_certified;
  if (can == true && answer.must.must != true && fails("can-move")) return refuted_or_not_certified;
  if (!can) return fails("undecided") ? refuted_or_not_certified : undecided;
  return success;
}

RestMapQuestion map_question(const RestArguments& arguments) {
  RestMapQuestion question{arguments.map[0], arguments.map[1], {}, {}};
  const auto x = range_of(arguments.x_range), y = range_of(arguments.y_range);
  question.x_frame.from = x[0], question.x_frame.to = x[1];
  question.y_frame.from = y[0], question.y_frame.to = y[1];
  for (const RestMap::Frame* frame : {&question.x_frame, &question.y_frame}) {
    if (frame->from && *frame->from >= *frame->to) {
      throw CLI::ValidationError("--map", "found a range that ends where it begins, expected FROM below TO");
    }
  }
  return question;
}

int answer(const RestArguments& arguments, bool tilts) {
  MechanismScene scene = at_load(read_scene(arguments.scene, Dimensions::any), arguments.load);
  refuse_impact(scene, "rest");
  RestQuestions questions;
  if (tilts) {
    if (arguments.tilt.empty() && scene.mechanism.dimension == 3) {
      throw CLI::ValidationError("--tilt", "found no axis, expected one as x,y,z in space");
    }
    questions.tilt = axis_of(arguments.tilt);
  }
  questions.parameter = arguments.parameter;
  questions.effort = arguments.effort;
  if (!arguments.map.empty()) questions.map = map_question(arguments);
  print_warnings(scene, arguments.common);
  std::optional<OutputFile> certificate;
  if (!arguments.certificate.empty()) {
    certificate.emplace(arguments.certificate, Inputs{arguments.scene, scene.mechanism.file});
  }
  expect_picture_name(arguments.out);
  std::optional<OutputFile> out;
  if (!arguments.out.empty()) out.emplace(arguments.out, Inputs{arguments.scene, scene.mechanism.file});
  const RestAnswer found = find_rest(std::move(scene), questions);
  if (certificate) {
    const std::string text = rest_certificate(found);
    if (text.empty()) refuse(arguments, "nothing is proved about its rest, expected a proof for a certificate");
    certificate->write(text);
  }
  if (out) {
    if (!found.map) refuse(arguments, "the effort was not enough for a map");
    out->write(picture_for(arguments.out, rest_map_svg_file(found)));
  }
  print_report(
      arguments.common, [&] { return rest_json(found); }, [&] { return rest_document(found, arguments.digits); });
  return exit_code_of(found, arguments.fail_on);
}

}  // namespace

void add_rest(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<RestArguments>();
  CLI::App& command = *app.add_subcommand("rest", "Find whether a scene can rest, whether it must, and up to where");
  command.add_option("SCENE", options->scene, "Scene file (TOML), in the plane or in space")->required();
  add_load_option(command, options->load);
  CLI::Option* tilt = command
                          .add_option("--tilt", options->tilt,
                                      "Find the greatest angle by which gravity can turn about an axis x,y,z, by the "
                                      "right hand; in the plane the axis is left out")
                          ->expected(0, 1);
  command.add_option("--parameter", options->parameter, "Find the values of a parameter at which it can rest");
  CLI::Option* map = command
                         .add_option("--map", options->map,
                                     "X Y: find the region of two loads in which it can rest: parameters that multiply "
                                     "no unknown")
                         ->expected(2);
  add_range_option(command, "--x-range", options->x_range, "FROM TO of the map's X");
  add_range_option(command, "--y-range", options->y_range, "FROM TO of the map's Y");
  for (const char* range : {"--x-range", "--y-range"}) command.get_option(range)->needs(map);
  command.add_option("-o,--out", options->out, "Draw the map to this file, .svg or .png")->needs(map);
  command
      .add_option("--fail-on", options->fail_on,
                  "What ends with exit code 1: some of cannot-rest (the default), touching, can-move (or not proved "
                  "that it cannot), undecided, none, with commas")
      ->delimiter(',')
      ->check(CLI::IsMember({"cannot-rest", "touching", "can-move", "undecided", "none"}));
  command.add_option("--certificate", options->certificate,
                     "Write what is proved to this file, for slipproof-check-contact");
  command.add_option("--effort", options->effort, "Operations on words that each question may take")
      ->check(whole_number(1));
  add_digits_option(command, options->digits);
  add_report_options(command, options->common);
  add_examples(command, {"cases/rest/block-on-slope.toml --tilt"});
  command.callback([options, tilt, &exit_code] { exit_code = answer(*options, tilt->count() > 0); });
}

}  // namespace slipproof::cli
