#include <array>
#include <string>
#include <utility>

#include "report/html/sections.hpp"
#include "report/papers/second_checker.hpp"

namespace slipproof {

namespace {

/// By CertificateState: the verdict with the same appearance, and a sign.
constexpr std::array<std::pair<const char*, const char*>, 5> looks{
    {{"proved", "✓ "}, {"refuted", "✗ "}, {"undecided", "∅ "}, {"undecided", "? "}, {"refuted", "✗ "}}};

}  // namespace

void add_certificates_section(const Element& main, const PageInput& input) {
  if (input.certificates.empty()) return;
  const Element section = add_section(main, "certificates", "Certificates");
  section.add("p", "lead")
      .text(
          "Statements for all parameters, each with a certificate: case splits and polynomial identities that a small "
          "checker, which shares no code with the prover, has just checked. Anyone can check them again with "
          "slipproof-check.");
  if (const auto& second = input.result->second_checker) section.add("p").text(in_words(*second) + ".");
  if (input.opinions) add_opinions_table(section, *input.opinions, input.certificates.size());
  const Element list = section.add("div", "certificates");
  for (const PageCertificate& certificate : input.certificates) {
    const Element item = list.add("details", "certificate").set("id", "certificate-" + certificate.theorem);
    const Element summary = item.add("summary");
    summary.add("span", "id").text(certificate.theorem);
    const std::string also = input.opinions ? agreeing_programs(*input.opinions, certificate.theorem) : "";
    if (!also.empty()) summary.add("small", "also").text("also " + also);
    const auto& [look, sign] = looks[static_cast<std::size_t>(certificate.state)];
    add_chip(summary, look, sign, to_string(certificate.state));
    if (!certificate.message.empty()) item.add("p").text(certificate.message);
    item.add("pre").set("tabindex", 0).add("code").text(certificate.statement);
  }
}

}  // namespace slipproof
