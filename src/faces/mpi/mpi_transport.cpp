#include "faces/mpi/mpi_transport.hpp"

#include <iterator>
#include <limits>
#include <stdexcept>
#include <utility>

namespace slipproof {

MpiTransport::MpiTransport(int& argc, char**& argv) {
  int provided = 0;
  MPI_Init_thread(&argc, &argv, MPI_THREAD_FUNNELED, &provided);
  if (provided < MPI_THREAD_FUNNELED) throw std::runtime_error("found an MPI without threads, expected one with them");
  MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
  MPI_Comm_size(MPI_COMM_WORLD, &ranks_);
}

MpiTransport::~MpiTransport() {
  for (Sending& one : sending_) MPI_Wait(&one.request, MPI_STATUS_IGNORE);
  MPI_Finalize();
}

void MpiTransport::send(int to, std::string bytes) {
  if (bytes.size() > static_cast<std::size_t>(std::numeric_limits<int>::max())) {
    throw std::runtime_error("found a message of " + std::to_string(bytes.size()) + " bytes, expected less than 2^31");
  }
  forget_sent();
  Sending& one = sending_.emplace_back();
  one.bytes = std::move(bytes);
  MPI_Isend(one.bytes.data(), static_cast<int>(one.bytes.size()), MPI_BYTE, to, 0, MPI_COMM_WORLD, &one.request);
}

std::optional<Message> MpiTransport::receive() {
  forget_sent();
  int there = 0;
  MPI_Message handle = MPI_MESSAGE_NULL;
  MPI_Status status;
  MPI_Improbe(MPI_ANY_SOURCE, 0, MPI_COMM_WORLD, &there, &handle, &status);
  if (there == 0) return std::nullopt;
  int size = 0;
  MPI_Get_count(&status, MPI_BYTE, &size);
  Message message{status.MPI_SOURCE, std::string(static_cast<std::size_t>(size), '\0')};
  MPI_Mrecv(message.bytes.data(), size, MPI_BYTE, &handle, MPI_STATUS_IGNORE);
  return message;
}

void MpiTransport::forget_sent() {
  for (auto one = sending_.begin(); one != sending_.end();) {
    int sent = 0;
    MPI_Test(&one->request, &sent, MPI_STATUS_IGNORE);
    one = sent != 0 ? sending_.erase(one) : std::next(one);
  }
}

}  // namespace slipproof
