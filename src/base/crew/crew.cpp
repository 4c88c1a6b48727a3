#include "base/crew/crew.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/crew/bytes.hpp"
#include "base/parallel/stop.hpp"

namespace slipproof {

namespace {

/// What a message is about: its first byte.
enum class Word : char { ready = 'r', request = 'q', answer = 'a', dismissed = 'd' };

constexpr std::chrono::milliseconds patience{1};

std::string with_word(Word word, std::string_view bytes = {}) {
  return static_cast<char>(word) + std::string(bytes);
}

}  // namespace

/// What is known of the requests of one call.
class Crew::Stage {
 public:
  using Request = std::function<std::string(std::uint64_t)>;
  using Take = std::function<void(std::uint64_t, std::string)>;

  Stage(std::uint64_t count, std::size_t window, const Request& request, const Take& take, Taking taking)
      : count_(count), window_(window), request_(request), take_(take), taking_(taking) {}

  bool done() const { return taken_ == count_; }
  /// The next one to hand out, while not too many results wait for an earlier one.
  bool has_next() const { return next_ < std::min(count_, taken_ + window_); }
  std::pair<std::uint64_t, std::string> next() {
    std::string request = request_(next_);
    out_.emplace(next_, request);
    return {next_++, std::move(request)};
  }
  /// The request with this number; it is no longer outstanding.
  std::string returned(std::uint64_t number) {
    auto request = out_.extract(number);
    if (request.empty()) throw BrokenBytes();
    return std::move(request.mapped());
  }
  void put(Reply answer) {
    const std::uint64_t number = answer.number;
    if (taking_ == Taking::as_they_come && answer.kind == Reply::Kind::result) {
      take_(number, std::move(answer).result());
      waiting_.emplace(number, std::nullopt);
    } else {
      waiting_.emplace(number, std::move(answer));
    }
  }
  void take_in_order() {
    for (auto first = waiting_.begin(); first != waiting_.end() && first->first == taken_; first = waiting_.begin()) {
      std::optional<Reply> answer = std::move(waiting_.extract(first).mapped());
      if (answer) take_(taken_, std::move(*answer).result());
      ++taken_;
    }
  }
  std::string missing(const std::function<bool(const std::string&)>& is_kept) const {
    std::vector<std::uint64_t> missing;
    for (std::uint64_t i = taken_; i < count_; ++i) {
      const bool kept = waiting_.contains(i) || (i >= next_ && is_kept(request_(i)));
      if (!kept) missing.push_back(i + 1);
    }
    return fmt::format("stopped on request: {} of {} pieces are done, missing: {}", count_ - missing.size(), count_,
                       ranges_text(missing));
  }

 private:
  std::uint64_t count_, next_ = 0, taken_ = 0;
  std::size_t window_;
  const Request& request_;
  const Take& take_;
  Taking taking_;
  std::map<std::uint64_t, std::string> out_;
  std::map<std::uint64_t, std::optional<Reply>> waiting_;  ///< for an earlier one; nothing where it is taken already
};

Crew::Crew(Transport& transport, CrewOptions options, Service service)
    : transport_(transport),
      options_(std::move(options)),
      service_(std::move(service)),
      slots_(static_cast<std::size_t>(transport.ranks())),
      free_(slots_.size()),
      pool_(options_.threads, service_) {
  if (transport.ranks() <= most_ranks_helped) slots_[0] = free_[0] = pool_.slots();
}

void dismiss_others(Transport& transport) {
  for (int rank = 1; rank < transport.ranks(); ++rank) {
    try {
      transport.send(rank, with_word(Word::dismissed));
    } catch (const std::exception&) {  // a rank that is gone needs no dismissal
    }
  }
}

Crew::~Crew() {
  if (leads()) dismiss_others(transport_);
}

void Crew::serve() {
  transport_.send(0, with_word(Word::ready, ByteWriter().number(pool_.slots()).take()));
  while (true) {
    while (const auto message = transport_.receive()) {
      if (message->bytes.at(0) == static_cast<char>(Word::dismissed)) return;
      ByteReader bytes(std::string_view(message->bytes).substr(1));
      const std::uint64_t number = bytes.number();
      pool_.ask(number, std::string(bytes.text()));
      bytes.end();
    }
    while (const auto answer = pool_.answer(patience)) {
      transport_.send(0, with_word(Word::answer, answer->to_bytes()));
    }
  }
}

void Crew::each(std::uint64_t count, const std::function<std::string(std::uint64_t)>& request,
                const std::function<void(std::uint64_t, std::string)>& take, Taking taking) {
  constexpr std::size_t results_a_slot = 16;
  Stage stage(count, results_a_slot * pool_.slots() * free_.size(), request, take, taking);
  while (!stage.done()) {
    slipproof::stop_if_asked();
    hand_out(stage);
    collect(stage);
    stage.take_in_order();
    look_after(stage);
  }
}

/// To each rank in turn, so that the last requests are spread.
void Crew::hand_out(Stage& stage) {
  bool some = true;
  while (some) {
    some = false;
    for (std::size_t rank = 0; rank < free_.size() && stage.has_next(); ++rank) {
      if (free_[rank] == 0) continue;
      auto [number, request] = stage.next();
      some = true;
      if (auto result = kept(request)) {
        stage.returned(number);
        stage.put({.number = number, .bytes = *std::move(result)});
        continue;
      }
      --free_[rank];
      if (rank == 0) {
        pool_.ask(number, std::move(request));
      } else {
        transport_.send(static_cast<int>(rank),
                        with_word(Word::request, ByteWriter().number(number).text(request).take()));
      }
    }
  }
}

/// Whatever is there now; waits a moment for the first.
void Crew::collect(Stage& stage) {
  bool some = false;
  while (const auto message = transport_.receive()) {
    heard(stage, *message);
    some = true;
  }
  while (auto answer = pool_.answer(some ? std::chrono::milliseconds(0) : patience)) {
    answered(stage, *std::move(answer));
    ++free_[0];
    some = true;
  }
}

void Crew::heard(Stage& stage, const Message& message) {
  const auto from = static_cast<std::size_t>(message.from);
  const std::string_view bytes = std::string_view(message.bytes).substr(1);
  switch (static_cast<Word>(message.bytes.at(0))) {
    case Word::ready:
      // A rank that came late to an earlier crew may say so again: what it has been given counts.
      free_.at(from) += ByteReader(bytes).number() - slots_.at(from);
      slots_.at(from) = ByteReader(bytes).number();
      return;
    case Word::answer:
      ++free_.at(from);
      answered(stage, Reply::from_bytes(bytes));
      return;
    case Word::request:
    case Word::dismissed:
      break;
  }
  throw BrokenBytes();
}

void Crew::answered(Stage& stage, Reply answer) {
  const std::string request = stage.returned(answer.number);
  if (options_.journal != nullptr && answer.kind == Reply::Kind::result) {
    options_.journal->keep(request, answer.bytes);
  }
  stage.put(std::move(answer));
}

std::optional<std::string> Crew::kept(std::string_view request) const {
  if (options_.journal == nullptr) return std::nullopt;
  auto result = options_.journal->find(request);
  if (result && options_.still_counts && !options_.still_counts(request, *result)) return std::nullopt;
  return result;
}

void Crew::look_after(const Stage& stage) {
  const auto now = std::chrono::steady_clock::now();
  if (options_.journal != nullptr && now - flushed_ >= options_.flush_after) {
    options_.journal->flush();
    flushed_ = now;
  }
  if (!options_.stop_asked || !options_.stop_asked() || stage.done()) return;
  if (options_.journal != nullptr) options_.journal->flush();
  throw Unfinished(stage.missing([this](const std::string& request) { return kept(request).has_value(); }));
}

void Crew::stop_if_asked() const {
  if (options_.stop_asked && options_.stop_asked()) throw Unfinished("stopped on request, while rank 0 worked alone");
}

std::string ranges_text(const std::vector<std::uint64_t>& numbers) {
  constexpr std::size_t most = 10;
  std::string text;
  std::size_t ranges = 0, i = 0;
  for (; i < numbers.size() && ranges < most; ++ranges) {
    std::size_t last = i;
    while (last + 1 < numbers.size() && numbers[last + 1] == numbers[last] + 1) ++last;
    text += fmt::format("{}{}", text.empty() ? "" : ", ", numbers[i]);
    if (last > i) text += fmt::format("-{}", numbers[last]);
    i = last + 1;
  }
  return i < numbers.size() ? text + fmt::format(" and {} more", numbers.size() - i) : text;
}

}  // namespace slipproof
