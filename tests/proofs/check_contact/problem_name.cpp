// The name of the problem that a certificate is about.
#include <vector>

#include "base/os/sha256.hpp"
#include "proofs/check_contact/examples.hpp"
#include "proofs/check_contact/problem.hpp"
#include "support/run_program.hpp"

using namespace slipproof::check_contact;

namespace {

/// The canonical form of kRod's problem, by hand.
const std::string kRodForm =
    "slipproof-contact-problem 1\n"
    "dimension 1 free 1 contacts 2\n"
    "mu 0 0\n"
    "matrix\n"
    "0 0 1\n0 1 -1\n0 2 -1\n1 0 1\n2 0 1\n"
    "constant 2 0 0\n";

std::string hash(const std::string& text) {
  Sha256 hash;
  hash.add(text);
  return hash.hexadecimal();
}

std::string named(const std::string& certificate, const std::string& name) {
  return replaced(certificate, "contact 1\n", "contact 1\nproblem " + name + "\n");
}

std::string whole(const std::string& certificate, const std::string& asked = "") {
  const ContactVerdict found = check_contact_certificate(certificate, asked);
  return (found.kind == ContactVerdict::Kind::accepted ? "accepted: " : "rejected: ") + found.message;
}

std::string name_of(const std::string& certificate) {
  Reader reader(certificate);
  return Problem(reader).name();
}

}  // namespace

TEST_CASE("SHA-256: the examples of NIST, and another implementation at every length") {
  CHECK(hash("") == "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  CHECK(hash("abc") == "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  CHECK(hash("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq") ==
        "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  CHECK(hash(std::string(1'000'000, 'a')) == "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
  std::string text;
  for (int i = 0; i < 300; ++i) {
    CHECK(hash(text) == slipproof::sha256(text));
    text += static_cast<char>(i * i + 7 * i);
  }
}

TEST_CASE("the name is that of the canonical form") {
  CHECK(name_of(kRod) == slipproof::sha256(kRodForm));
  CHECK(name_of(replaced(kRod, "constant 2 0", "constant 2 -6/8")) ==
        slipproof::sha256(replaced(kRodForm, "constant 2 0", "constant 2 -3/4")));
}

TEST_CASE("how a problem is written makes no difference, and everything else in it does") {
  const std::string name = name_of(kRod);
  for (const auto& [from, to] :
       std::vector<std::pair<std::string, std::string>>{{"0 0 1  0 1 -1  0 2 -1", "0 2 -1  0 0 0x1p+0  0 1 -7/7"},
                                                        {"matrix 5\n", "matrix 6\n2 2 0  "},
                                                        {"matrix 5\n", "matrix 6\n2 2 -0x0p7  "},
                                                        {"constant 2", "constant  0x0.8p2  # two\n"},
                                                        {"mu 0", "mu -0/3"},
                                                        {"answer 0 5/4 3/4", "answer 0 1 1"}}) {
    const std::string other = replaced(kRod, from, to);
    CAPTURE(other);
    CHECK(name_of(other) == name);
  }
  for (const auto& [from, to] :
       std::vector<std::pair<std::string, std::string>>{{"constant 2", "constant 0x1.0000000000001p+1"},
                                                        {"0 1 -1", "0 1 1"},
                                                        {"1 0 1  2 0 1", "1 0 1  2 1 1"},
                                                        {"matrix 5\n", "matrix 6\n2 2 1  "}}) {
    const std::string other = named(replaced(kRod, from, to), name);
    CAPTURE(other);
    CHECK(whole(other).starts_with("rejected: it names the problem " + name + ", and has the numbers of "));
  }
  CHECK(name_of(replaced(kPlane, "mu 1/2 1/2 1", "mu 1/2 1/2 2")) != name_of(kPlane));
  CHECK(name_of(kDominant) != name_of(kDefinite));
}

TEST_CASE("a certificate says which problem it is about, and is rejected for another") {
  const std::string name = name_of(kRod), other = name_of(kPlane);
  const std::string solution =
      "accepted: a solution within 5.0e-1 of the answer, 2 contacts in dimension 1 and 1 free unknowns, ";
  CHECK(whole(named(kRod, name)) == solution + "of the problem " + name);
  CHECK(whole(named(kRod, name), name) == solution + "of the problem " + name);
  CHECK(whole(named(kRod, name), other) == "rejected: it is about another problem, " + name);
  // One that names none, as the first ones did.
  CHECK(whole(kRod) == solution + "names no problem, has the numbers of " + name);
  CHECK(whole(kRod, name) == whole(kRod));
  CHECK(whole(kRod, other) == "rejected: it is about another problem, " + name);
  // Which problem it is about comes before what is wrong with its proof.
  CHECK(whole(replaced(kRod, "answer 0", "answer 5"), other) == "rejected: it is about another problem, " + name);
  const std::string expected = "', expected 64 hexadecimal digits";
  for (const std::string& bad : {std::string("1"), name + "0", std::string(64, 'A')}) {
    CHECK(verdict(named(kRod, bad)) ==
          "unreadable: line 2, column 9: found '" +
              (bad.size() > 40 ? bad.substr(0, 40) + "'..." + expected.substr(1) : bad + expected));
  }
}

TEST_CASE("the program is asked about a problem by its name") {
  const slipproof::test::TemporaryFolder folder;
  const auto program = [&](const std::vector<std::string>& arguments) {
    return slipproof::test::run(arguments, "slipproof-check-contact");
  };
  const std::string file = folder.write("rod", named(kRod, name_of(kRod)));
  CHECK(program({"--problem", name_of(kRod), file}).exit_code == 0);
  CHECK(program({"--problem", name_of(kPlane), file}).exit_code == 5);
  CHECK(program({"--problem", "1", file}).exit_code == 2);
  CHECK(program({"--problem", name_of(kRod)}).exit_code == 2);
}
