// The words and numbers of a certificate, as the second reading takes them.
#pragma once

#include <gmpxx.h>

#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace slipproof::test::second {

using Q = mpq_class;
using Vec = std::vector<Q>;
using Mat = std::vector<Vec>;  // dense

inline constexpr std::size_t none = static_cast<std::size_t>(-1);

struct No {
  std::string why;
};
struct Garbled {};

inline void need(bool holds, const char* why) {
  if (!holds) throw No{why};
}

inline Q power_of_two(long e) {
  mpz_class two = 1;
  two <<= static_cast<mp_bitcnt_t>(std::labs(e));
  return e < 0 ? Q(1, two) : Q(two);
}

inline bool only(const std::string& text, const char* allowed) {
  return !text.empty() && text.find_first_not_of(allowed) == std::string::npos;
}

inline Q to_number(std::string text) {
  const bool minus = text[0] == '-';
  if (minus) text.erase(0, 1);
  if (text.size() > 5000) throw Garbled();
  Q value;
  if (text.rfind("0x", 0) == 0) {
    const std::size_t p = text.find('p');
    if (p == std::string::npos) throw Garbled();
    std::string digits = text.substr(2, p - 2), power = text.substr(p + 1);
    long places = 0;
    if (const std::size_t dot = digits.find('.'); dot != std::string::npos) {
      places = static_cast<long>(digits.size() - dot - 1);
      if (dot == 0 || places == 0) throw Garbled();
      digits.erase(dot, 1);
    }
    const bool down = !power.empty() && power[0] == '-';
    if (down || (!power.empty() && power[0] == '+')) power.erase(0, 1);
    if (!only(digits, "0123456789abcdef") || !only(power, "0123456789") || power.size() > 6) throw Garbled();
    if (std::stol(power) > 5000) throw Garbled();
    value = Q(mpz_class(digits, 16)) * power_of_two((down ? -1 : 1) * std::stol(power) - 4 * places);
  } else {
    const std::size_t slash = text.find('/');
    const std::string over = text.substr(0, slash), under = slash == std::string::npos ? "1" : text.substr(slash + 1);
    if (!only(over, "0123456789") || !only(under, "0123456789") || mpz_class(under) == 0) throw Garbled();
    value = Q(mpz_class(over), mpz_class(under));
    value.canonicalize();
  }
  return minus ? Q(-value) : value;
}

class Words {
 public:
  explicit Words(const std::string& text) {
    for (const char c : text) {
      if (c != ' ' && c != '\t' && c != '\n' && (c < ' ' || c > '~')) throw Garbled();
    }
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
      std::istringstream words(line.substr(0, line.find('#')));
      for (std::string word; words >> word;) words_.push_back(word);
    }
  }
  std::string next() {
    if (at_ == words_.size()) throw Garbled();
    return words_[at_++];
  }
  bool is(const std::string& word) const { return at_ < words_.size() && words_[at_] == word; }
  bool take(const std::string& word) {
    if (!is(word)) return false;
    ++at_;
    return true;
  }
  void expect(const std::string& word) {
    if (!take(word)) throw Garbled();
  }
  bool at_end() const { return at_ == words_.size(); }
  Q number() { return to_number(next()); }
  std::size_t count(std::size_t end) {
    const std::string word = next();
    if (!only(word, "0123456789") || word.size() > 9) throw Garbled();
    const std::size_t value = std::stoul(word);
    if (value >= end) throw Garbled();
    return value;
  }
  Vec numbers(std::size_t n) {
    if (n > words_.size()) throw Garbled();
    Vec result;
    for (std::size_t i = 0; i < n; ++i) result.push_back(number());
    return result;
  }
  Vec named(const std::string& name, std::size_t n) {
    expect(name);
    return numbers(n);
  }
  Mat entries(std::size_t rows, std::size_t columns) {
    Mat result(rows, Vec(columns));
    std::set<std::pair<std::size_t, std::size_t>> seen;
    for (std::size_t left = count(words_.size()); left > 0; --left) {
      const std::size_t i = count(rows), j = count(columns);
      if (!seen.emplace(i, j).second) throw Garbled();
      result[i][j] = number();
    }
    return result;
  }

 private:
  std::vector<std::string> words_;
  std::size_t at_ = 0;
};

struct Certificate {
  std::size_t D = 0, F = 0, K = 0, n = 0;
  Vec mu, c, x, bounds;
  Mat A;
  std::string law = "coulomb";
  Q slip_speed;
  bool has_answer = false;

  Vec motion(const Vec& at) const {
    Vec w = c;
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) {
        if (A[i][j] != 0) w[i] += A[i][j] * at[j];
      }
    }
    return w;
  }
};

inline Q absolute(const Q& x) {
  return x < 0 ? Q(-x) : x;
}

inline Q dot(const Vec& a, const Vec& b) {
  Q sum;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

/// Whether contact k obeys the law.
bool lawful(const Certificate& p, std::size_t k, const Vec& x, const Vec& w);
/// Checks an enclosure, or a ball; throws No.
void enclosure(const Certificate& p, Words& words, bool ball);
/// Checks a list of all solutions; throws No.
void all_solutions(const Certificate& p, Words& words);

}  // namespace slipproof::test::second
