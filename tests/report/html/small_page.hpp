// A page with something in every section, and its tree.
#pragma once

#include <doctest/doctest.h>

#include <pugixml.hpp>

#include "base/os/sha256.hpp"
#include "report/html/page.hpp"
#include "support/papers/shipped.hpp"

namespace slipproof::test {

inline const std::string hostile = "</script><script>alert(1)</script><b onmouseover=x>\"'&amp;\xE2\x80\xAE\x01";

inline const VerifyResult& small_result() {
  static const VerifyResult result = [] {
    VerifyOptions options;
    options.samples = 60;
    options.lines = 0;  // verdicts to show, not to trust
    return verify(test::shipped_paper(), options);
  }();
  return result;
}

inline PageInput small_input() {
  PageInput input;
  input.claims = &test::shipped_paper();
  input.result = &small_result();
  input.command = "slipproof report";
  input.version = "0";
  input.figures = read_figures(SLIPPROOF_SOURCE_DIR "/proofs/rozenblat-yashin/figures.toml", *input.claims);
  input.scenes.push_back(read_scene(SLIPPROOF_SOURCE_DIR "/cases/wheelie.toml"));
  input.scenes.back().name = hostile;
  input.certificates.push_back({"T<1>", "T.cert", "a < b & c", CertificateState::rejected, "line 1: " + hostile});
  input.solvers.push_back({hostile, 10, {4, 3, 2, 1, 0, 0}, 1});
  input.sources.push_back({hostile, sha256("")});
  return input;
}

inline pugi::xml_document read(const std::string& html) {
  pugi::xml_document tree;
  const auto result = tree.load_string(html.c_str(), pugi::parse_default | pugi::parse_doctype | pugi::parse_ws_pcdata);
  INFO(result.description() << " at " << result.offset);
  REQUIRE(result);
  return tree;
}

}  // namespace slipproof::test
