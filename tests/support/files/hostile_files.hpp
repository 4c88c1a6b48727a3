// Folders that somebody made to deceive a checker of certificates, or to stop it. Every checker gets the same ones.
#pragma once

#include <doctest/doctest.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <functional>
#include <sstream>

#include "support/run_program.hpp"

namespace slipproof::test {

/// What a checker accepts: the text of a certificate and, where its format has one, of the statement beside it.
struct GoodTexts {
  std::string statement, certificate;
};

/// A certificate with its verdicts: that of the checkers that look for a statement beside it and that of those for
/// which the certificate brings its own.
struct Hostile {
  std::string certificate, beside_statement, alone;
};

class HostileFolder : public TemporaryFolder {
 public:
  explicit HostileFolder(GoodTexts good) : good_(std::move(good)) {}
  ~HostileFolder() { std::system(("rm -rf " + quoted((path() / "deep").string())).c_str()); }

  std::filesystem::path at(const std::string& name) const { return path() / name; }
  void statement(const std::string& name) const { write(name + ".statement", good_.statement); }
  void certificate(const std::string& name) const { write(name + ".cert", good_.certificate); }
  void both(const std::string& name) const { statement(name), certificate(name); }
  void link(const std::string& name, const std::string& to) const { std::filesystem::create_symlink(to, at(name)); }
  void pipe(const std::string& name) const { REQUIRE(mkfifo(at(name).c_str(), 0600) == 0); }
  void folder(const std::string& name) const { std::filesystem::create_directories(at(name)); }
  /// A tebibyte, of which nothing is on the disk.
  void huge(const std::string& name) const {
    write(name, "");
    std::filesystem::resize_file(at(name), std::uintmax_t{1} << 40);
  }
  /// deep/d/d/.../d, whose whole path may be longer than the system takes one.
  void nested(std::size_t depth) const {
    folder("deep");
    int here = open(at("deep").c_str(), O_DIRECTORY | O_RDONLY);
    for (std::size_t i = 0; i < depth; ++i) {
      REQUIRE(mkdirat(here, "d", 0700) == 0);
      const int below = openat(here, "d", O_DIRECTORY | O_RDONLY);
      close(here);
      here = below;
    }
    close(here);
  }

 private:
  GoodTexts good_;
};

struct HostileCase {
  std::string what;
  std::function<void(const HostileFolder&)> make;
  std::vector<Hostile> found;  ///< all that checkers find in the folder
};

/// Verdicts of certificates and of statements with such a text.
inline HostileCase with_text(const std::string& what, const std::string& text) {
  return {what,
          [text](const HostileFolder& f) {
            f.statement("c"), f.write("c.cert", text);
            f.certificate("s"), f.write("s.statement", text);
          },
          {{"c.cert", "rejected", "unreadable"}, {"s.cert", "unreadable", "accepted"}}};
}

inline std::vector<HostileCase> hostile_cases() {
  using F = const HostileFolder&;
  const std::string nul(1, '\0'), unreadable = "unreadable", accepted = "accepted";
  const std::string forged = "a\naccepted A2.1\ns ACCEPTED 1 accepted\x1B[2K\r",
                    disguised = "\xE2\x80\xAE\xC2\x9B\xFF\xC3";
  const std::string undecided = "slipproof-undecided 1\ntheorem t\n";
  const std::string deepest = "deep" + [] {
    std::string path;
    for (int i = 0; i < 1'100; ++i) path += "/d";
    return path;
  }();
  return {
      {"what is good", [](F f) { f.both("t"); }, {{"t.cert", accepted, accepted}}},
      {"nothing", [](F) {}, {{"", unreadable, unreadable}}},
      {"pipes that nobody writes to",
       [](F f) { f.statement("c"), f.pipe("c.cert"), f.certificate("s"), f.pipe("s.statement"); },
       {{"c.cert", unreadable, unreadable}, {"s.cert", unreadable, accepted}}},
      {"files without an end",
       [](F f) {
         f.statement("c"), f.link("c.cert", "/dev/zero"), f.certificate("s"), f.link("s.statement", "/dev/zero");
       },
       {{"c.cert", unreadable, unreadable}, {"s.cert", unreadable, accepted}}},
      {"files that are too long",
       [](F f) { f.statement("c"), f.huge("c.cert"), f.certificate("s"), f.huge("s.statement"); },
       {{"c.cert", "rejected", unreadable}, {"s.cert", unreadable, accepted}}},
      {"files whose reading fails",
       [](F f) {
         f.statement("c"), f.link("c.cert", "/proc/self/mem");
         f.certificate("s"), f.link("s.statement", "/proc/self/mem");
       },
       {{"c.cert", unreadable, unreadable}, {"s.cert", unreadable, accepted}}},
      with_text("empty files", ""),
      with_text("binary files",
                "\x7F"
                "ELF" +
                    nul + nul + "\xFF\xFE\n"),
      with_text("a line without an end", std::string(3 << 20, 'x')),
      with_text("nested without an end", std::string(200'000, '(') + "\n" + std::string(200'000, '{')),
      with_text("lines that end as elsewhere", "slipproof-certificate 1\r\ntheorem t\r\n"),
      {"names that forge lines",
       [=](F f) { f.both(forged), f.certificate("b" + forged), f.both(disguised), f.statement("c" + forged); },
       {{forged + ".cert", accepted, accepted},
        {"b" + forged + ".cert", unreadable, accepted},
        {"c" + forged + ".cert", "missing", "missing"},
        {disguised + ".cert", accepted, accepted}}},
      {"names that are options, quotes, and comments",
       [](F f) { f.both("-n"), f.both("'\"`$(x)"), f.both("a*) Axiom false : False. (*"); },
       {{"'\"`$(x).cert", accepted, accepted},
        {"-n.cert", accepted, accepted},
        {"a*) Axiom false : False. (*.cert", accepted, accepted}}},
      {"names that are hardly names",
       [](F f) {
         f.both("..x"), f.both("."), f.both("x.cert"), f.both(" "), f.write("x.cert\n", ""), f.write(".cert", "");
       },
       {{" .cert", accepted, accepted},
        {"..cert", accepted, accepted},
        {"..x.cert", accepted, accepted},
        {"x.cert.cert", accepted, accepted}}},
      {"a name with no room for the longer ending",
       [](F f) { f.certificate(std::string(250, 'n')); },
       {{std::string(250, 'n') + ".cert", unreadable, accepted}}},
      {"folders that are called like files",
       [](F f) {
         f.statement("c"), f.folder("c.cert"), f.certificate("s"), f.folder("s.statement"), f.folder("x.cert");
       },
       {{"c.cert", unreadable, unreadable}, {"s.cert", unreadable, accepted}}},
      {"links to nothing",
       [](F f) {
         f.statement("c"), f.link("c.cert", "nothing"), f.certificate("s"), f.link("s.statement", "nothing");
         f.statement("m");
       },
       {{"c.cert", unreadable, unreadable}, {"m.cert", "missing", "missing"}, {"s.cert", unreadable, accepted}}},
      {"links that lead to themselves",
       [](F f) {
         f.statement("c"), f.link("c.cert", "d.cert"), f.link("d.cert", "c.cert"), f.statement("d");
         f.certificate("s"), f.link("s.statement", "s.statement");
       },
       {{"c.cert", unreadable, unreadable}, {"d.cert", unreadable, unreadable}, {"s.cert", unreadable, accepted}}},
      {"folders that contain themselves",
       [](F f) {
         f.folder("in"), f.link("in/up", ".."), f.link("in/here", "."), f.link("x", "y"), f.link("y", "x"), f.both("t");
       },
       {{"t.cert", accepted, accepted}}},
      {"links out of the folder",
       [](F f) { f.both("t"), f.link("root", "/"), f.link("u.cert", "t.cert"), f.link("u.statement", "t.statement"); },
       {{"root", unreadable, unreadable}, {"t.cert", accepted, accepted}, {"u.cert", accepted, accepted}}},
      {"folders in folders, more than files may be open",
       [=](F f) { f.nested(1'100), f.both(deepest + "/t"); },
       {{deepest + "/t.cert", accepted, accepted}}},
      {"a path that is too long",
       [](F f) { f.nested(2'100), f.both("t"); },
       {{"deep", unreadable, unreadable}, {"t.cert", accepted, accepted}}},
      {"records of searches that ended without",
       [=](F f) {
         for (const char* name : {"a", "b", "c", "d", "e"}) f.statement(name);
         f.write("a.cert", undecided);
         f.write("b.cert", "\n# why\n" + undecided + "\nbecause $10 are spent\n  because x > 0 is left\n");
         f.write("c.cert", undecided + "because\n");
         f.write("d.cert", "slipproof-undecided 1\ntheorem u\n");
         f.write("e.cert", undecided + "because \x1B[1A\n");
       },
       {{"a.cert", "undecided", unreadable},
        {"b.cert", "undecided", unreadable},
        {"c.cert", "rejected", unreadable},
        {"d.cert", "rejected", unreadable},
        {"e.cert", "rejected", unreadable}}},
      {"a search that ended without, and nothing worse",
       [=](F f) { f.both("t"), f.statement("u"), f.write("u.cert", undecided); },
       {{"t.cert", accepted, accepted}, {"u.cert", "undecided", unreadable}}},
  };
}

/// What a checker says of files that may hold it up for ever: after a minute it is ended.
inline ProgramEnd run_checker(const std::string& program, const std::vector<std::string>& arguments) {
  const TemporaryFolder folder;
  std::string command = "timeout 60 " + quoted(program);
  for (const std::string& argument : arguments) command += " " + quoted(argument);
  command += " >" + quoted((folder.path() / "out").string()) + " 2>&1 </dev/null";
  const int status = std::system(command.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read_file(folder.path() / "out"), ""};
}

/// The last line and the exit code that such verdicts have.
inline ProgramEnd expected_end(const std::vector<std::string>& verdicts) {
  struct Counted {
    const char *verdict, *word;
    int exit_code;
  };
  constexpr std::array<Counted, 5> worst{{{"rejected", "REJECTED", 5},
                                          {"unreadable", "UNREADABLE", 3},
                                          {"missing", "MISSING", 3},
                                          {"undecided", "UNDECIDED", 4},
                                          {"accepted", "ACCEPTED", 0}}};
  const auto count = [&](const char* verdict) { return std::count(verdicts.begin(), verdicts.end(), verdict); };
  const auto found = std::find_if(worst.begin(), worst.end(), [&](const auto& w) { return count(w.verdict) > 0; });
  std::ostringstream out;
  out << "s " << found->word;
  const char* separator = " ";
  for (const char* verdict : {"accepted", "rejected", "missing", "undecided", "unreadable"}) {
    out << separator << count(verdict) << ' ' << verdict;
    separator = ", ";
  }
  out << '\n';
  return {found->exit_code, out.str(), ""};
}

/// Nothing that an editor or a terminal does not show as it stands, and no line that a name of a file has made.
inline void check_lines(const std::string& out, std::size_t lines) {
  CHECK(static_cast<std::size_t>(std::count(out.begin(), out.end(), '\n')) == lines);
  for (const char c : out) {
    const bool shown = (c >= ' ' && c != '\x7F') || c == '\n' || static_cast<unsigned char>(c) >= 0x80;
    REQUIRE(shown);
  }
  for (const char* hidden : {"\xE2\x80\xAE", "\xC2\x9B", "\xFF"}) CHECK(out.find(hidden) == std::string::npos);
}

}  // namespace slipproof::test
