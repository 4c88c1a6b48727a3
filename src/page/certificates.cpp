#include <algorithm>

#include "page/sections.hpp"

namespace slipproof {

void add_certificates_section(const Element& main, const PageInput& input) {
  if (input.certificates.empty()) return;
  const Element section = add_section(main, "certificates", "Certificates");
  section.add("p", "lead")
      .text(
          "Statements for all parameters, each with a certificate: case splits and polynomial identities that a small "
          "checker, which shares no code with the prover, has just checked. Anyone can check them again with "
          "slipproof-check.");
  if (input.opinions) add_opinions_table(section, *input.opinions, input.certificates.size());
  const Element list = section.add("div", "certificates");
  for (const PageCertificate& certificate : input.certificates) {
    const Element item = list.add("details", "certificate").set("id", "certificate-" + certificate.theorem);
    const Element summary = item.add("summary");
    summary.add("span", "id").text(certificate.theorem);
    const std::string also = input.opinions ? agreeing_programs(*input.opinions, certificate.theorem) : "";
    if (!also.empty()) summary.add("small", "also").text("also " + also);
    const Element chip = summary.add("span", certificate.accepted ? "chip proved" : "chip refuted");
    chip.add("span").set("aria-hidden", "true").text(certificate.accepted ? "✓ " : "✗ ");
    chip.text(certificate.accepted ? "accepted" : "rejected");
    if (!certificate.message.empty()) item.add("p").text(certificate.message);
    item.add("pre").set("tabindex", 0).add("code").text(certificate.statement);
  }
}

}  // namespace slipproof
