// Messages between ranks, the processes of one run: over MPI, or over queues between threads.
#pragma once

#include <optional>
#include <string>

namespace slipproof {

struct Message {
  int from = 0;
  std::string bytes;
};

/// One rank's end. Used from one thread. Messages from one rank to another come in the order in which they were sent,
/// whole, and none is lost while both live. A rank that dies ends the run: that is the launcher's work.
class Transport {
 public:
  virtual ~Transport() = default;
  virtual int rank() const = 0;
  virtual int ranks() const = 0;
  /// Does not wait for the receiver.
  virtual void send(int to, std::string bytes) = 0;
  /// Returns a message if one has arrived; does not wait.
  virtual std::optional<Message> receive() = 0;
};

/// A run of a single rank.
class Alone final : public Transport {
 public:
  int rank() const override { return 0; }
  int ranks() const override { return 1; }
  void send(int, std::string) override {}
  std::optional<Message> receive() override { return std::nullopt; }
};

}  // namespace slipproof
