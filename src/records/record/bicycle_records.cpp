#include "records/record/bicycle_records.hpp"

#include <utility>

#include "mechanics/scene/bicycle_scene.hpp"

namespace slipproof {

namespace {

CertifiedMechanism in_words(CertifiedMechanism certified) {
  certified.forms = {
      {{"h0"}, {{"h", "h0 - R"}}},
      {{"b"}, {{"b2", "b"}, {"b3", "b"}}},
      {{"M2", "M3"}, {{"M", "1"}, {"I1", "0"}, {"I2", "M2*R^2"}, {"I3", "M3*R^2"}, {"r1", "1"}, {"r2", "1"}}},
      {{"mu"}, {{"r1", "1"}, {"r2", "mu"}}},
      {{"P"}, {{"F", "P*r1*R/(r2*L)"}}}};
  certified.word = {"kind", "external", {"internal", "external"}};
  certified.answers = {"a", "S2", "S3", "N2", "N3"};
  return certified;
}

}  // namespace

CertifiedMechanism bicycle_records() {
  CertifiedMechanism certified(bicycle_mechanism());
  certified.values.given[bicycle_parameter("external")] = true;
  return in_words(std::move(certified));
}

CertifiedMechanism bicycle_records(MechanismScene scene) {
  return in_words(CertifiedMechanism(std::move(scene)));
}

CertifiedMechanism records_of_scene(const std::string& text, const std::string& file) {
  MechanismScene scene = parse_scene(text, file, Dimensions::any);
  return is_mechanism_scene(text) ? CertifiedMechanism(std::move(scene)) : bicycle_records(std::move(scene));
}

}  // namespace slipproof
