#include "base/crew/pool.hpp"

#include <utility>

#include "base/crew/bytes.hpp"
#include "base/number/flint_memory.hpp"
#include "base/output/output_error.hpp"
#include "base/parallel/stop.hpp"
#include "base/parallel/thread_count.hpp"

namespace slipproof {

std::string Reply::to_bytes() const {
  ByteWriter bytes;
  bytes.number(number).number(static_cast<std::uint64_t>(kind)).text(this->bytes).number(diagnostics.size());
  for (const Diagnostic& d : diagnostics) bytes.text(d.file).number(d.line).number(d.column).text(d.message);
  return bytes.take();
}

Reply Reply::from_bytes(std::string_view text) {
  ByteReader bytes(text);
  Reply answer{.number = bytes.number(), .kind = static_cast<Kind>(bytes.number())};
  if (answer.kind > Kind::failure) throw BrokenBytes();
  answer.bytes = bytes.text();
  for (std::uint64_t left = bytes.number(); left > 0; --left) {
    Diagnostic& d = answer.diagnostics.emplace_back();
    d.file = bytes.text();
    d.line = bytes.number();
    d.column = bytes.number();
    d.message = bytes.text();
  }
  bytes.end();
  return answer;
}

std::string Reply::result() && {
  if (kind == Kind::bad_input) throw InputError(std::move(diagnostics));
  if (kind == Kind::not_written) throw OutputError(bytes);
  if (kind == Kind::failure) throw std::runtime_error(bytes);
  return std::move(bytes);
}

Reply reply_to(std::uint64_t number, std::string_view request, const Service& service) {
  try {
    return {.number = number, .bytes = service(request)};
  } catch (const InputError& error) {
    return {.number = number, .kind = Reply::Kind::bad_input, .diagnostics = error.diagnostics()};
  } catch (const OutputError& error) {
    return {.number = number, .kind = Reply::Kind::not_written, .bytes = error.what()};
  } catch (const Stopped&) {
    throw;
  } catch (const std::exception& error) {
    return {.number = number, .kind = Reply::Kind::failure, .bytes = error.what()};
  }
}

Pool::Pool(unsigned threads, const Service& service) : service_(service) {
  const int count = thread_count(threads);
  for (int i = 0; i < count; ++i) threads_.emplace_back([this](const std::stop_token& stop) { work(stop); });
}

Pool::~Pool() {
  for (std::jthread& thread : threads_) thread.request_stop();
}

void Pool::ask(std::uint64_t number, std::string request) {
  const std::scoped_lock lock(mutex_);
  requests_.emplace_back(number, std::move(request));
  asked_.notify_one();
}

std::optional<Reply> Pool::answer(std::chrono::milliseconds patience) {
  std::unique_lock lock(mutex_);
  if (!answered_.wait_for(lock, patience, [&] { return !answers_.empty(); })) return std::nullopt;
  Reply answer = std::move(answers_.front());
  answers_.pop_front();
  return answer;
}

void Pool::work(const std::stop_token& stop) {
  give_back_flint_memory_at_end();  // of what the service computes with
  const StopScope scope(stop);
  while (true) {
    std::unique_lock lock(mutex_);
    if (!asked_.wait(lock, stop, [&] { return !requests_.empty(); }) || stop.stop_requested()) return;
    const auto [number, request] = std::move(requests_.front());
    requests_.pop_front();
    lock.unlock();
    try {
      Reply answer = reply_to(number, request, service_);
      lock.lock();
      answers_.push_back(std::move(answer));
      answered_.notify_one();
    } catch (const Stopped&) {
      return;
    }
  }
}

}  // namespace slipproof
