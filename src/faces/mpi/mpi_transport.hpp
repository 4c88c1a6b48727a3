// Sends messages between ranks by MPI.
#pragma once

#include <mpi.h>

#include <list>
#include <optional>
#include <string>

#include "base/crew/transport.hpp"

namespace slipproof {

/// All ranks of MPI_COMM_WORLD, from MPI_Init to MPI_Finalize. A process may have only one, on its main thread.
class MpiTransport final : public Transport {
 public:
  MpiTransport(int& argc, char**& argv);
  /// Waits until all ranks have arrived here.
  ~MpiTransport() override;
  MpiTransport(const MpiTransport&) = delete;
  MpiTransport& operator=(const MpiTransport&) = delete;

  int rank() const override { return rank_; }
  int ranks() const override { return ranks_; }
  /// Throws std::runtime_error if MPI cannot count so many bytes.
  void send(int to, std::string bytes) override;
  std::optional<Message> receive() override;

 private:
  struct Sending {
    std::string bytes;
    MPI_Request request = MPI_REQUEST_NULL;
  };

  void forget_sent();

  int rank_ = 0, ranks_ = 1;
  std::list<Sending> sending_;  ///< a list, because MPI keeps the addresses of its elements
};

}  // namespace slipproof
