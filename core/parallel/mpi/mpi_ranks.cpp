// SPDX-License-Identifier: BSD-3-Clause
// The ranks of MPI, as a library that the program loads when mpirun has started it.
#include <mpi.h>

#include <algorithm>
#include <chrono>
#include <limits>
#include <memory>
#include <thread>
#include <vector>

#include "core/parallel/load_ranks.hpp"

namespace contactsim {

namespace {

/// Counts of MPI 3 are int; larger parts go in pieces.
constexpr std::size_t max_count = std::size_t{1} << 30;

int as_int(std::size_t n) { return static_cast<int>(n); }

int rank_of_world() {
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  return rank;
}

int count_of_world() {
  int count = 1;
  MPI_Comm_size(MPI_COMM_WORLD, &count);
  return count;
}

/// Errors of MPI end all processes, as MPI_ERRORS_ARE_FATAL says by default.
class MpiRanks final : public Ranks {
 public:
  MpiRanks() : Ranks(rank_of_world(), count_of_world()) {}
  ~MpiRanks() override { MPI_Finalize(); }

  void gather(std::span<std::byte> all, std::span<const std::size_t> begins) override {
    if (all.size() > max_count) return gather_in_pieces(all, begins);
    counts_.clear();
    first_.clear();
    for (std::size_t i = 0; i + 1 < begins.size(); ++i) {
      first_.push_back(as_int(begins[i]));
      counts_.push_back(as_int(begins[i + 1] - begins[i]));
    }
    MPI_Allgatherv(MPI_IN_PLACE, 0, MPI_DATATYPE_NULL, all.data(), counts_.data(), first_.data(), MPI_BYTE,
                   MPI_COMM_WORLD);
  }

  void broadcast(std::span<std::byte> bytes) override { broadcast(bytes, 0); }

  void exchange(std::span<const std::span<const std::byte>> out,
                std::span<const std::span<std::byte>> in) override {
    requests_.clear();
    for (int other = 0; other < count(); ++other) {
      for_pieces(in[static_cast<std::size_t>(other)], other, [&](std::span<std::byte> piece) {
        MPI_Irecv(piece.data(), as_int(piece.size()), MPI_BYTE, other, 0, MPI_COMM_WORLD,
                  &requests_.emplace_back());
      });
    }
    for (int i = 1; i < count(); ++i) {
      const int other = (rank() + i) % count();
      for_pieces(out[static_cast<std::size_t>(other)], other, [&](std::span<const std::byte> piece) {
        MPI_Isend(piece.data(), as_int(piece.size()), MPI_BYTE, other, 0, MPI_COMM_WORLD,
                  &requests_.emplace_back());
      });
    }
    MPI_Waitall(as_int(requests_.size()), requests_.data(), MPI_STATUSES_IGNORE);
  }

  bool wait_for_all(double seconds) override {
    using Clock = std::chrono::steady_clock;
    const auto end = Clock::now() + std::chrono::duration<double>(seconds);
    MPI_Request request = MPI_REQUEST_NULL;
    MPI_Ibarrier(MPI_COMM_WORLD, &request);
    int is_done = 0;
    for (auto pause = std::chrono::microseconds(1);;
         pause = std::min(2 * pause, std::chrono::microseconds(10000))) {
      MPI_Test(&request, &is_done, MPI_STATUS_IGNORE);
      if (is_done != 0 || Clock::now() > end) return is_done != 0;
      std::this_thread::sleep_for(pause);
    }
  }

  [[noreturn]] void abort(int exit_code) override {
    MPI_Abort(MPI_COMM_WORLD, exit_code);
    std::_Exit(exit_code);
  }

 private:
  template <class Byte, class Function>
  void for_pieces(std::span<Byte> bytes, int other, const Function& function) {
    if (other == rank()) return;
    for (; !bytes.empty(); bytes = bytes.subspan(std::min(bytes.size(), max_count)))
      function(bytes.first(std::min(bytes.size(), max_count)));
  }

  void broadcast(std::span<std::byte> bytes, int source) {
    for (; !bytes.empty(); bytes = bytes.subspan(std::min(bytes.size(), max_count)))
      MPI_Bcast(bytes.data(), as_int(std::min(bytes.size(), max_count)), MPI_BYTE, source, MPI_COMM_WORLD);
  }

  void gather_in_pieces(std::span<std::byte> all, std::span<const std::size_t> begins) {
    for (std::size_t i = 0; i + 1 < begins.size(); ++i)
      broadcast(all.subspan(begins[i], begins[i + 1] - begins[i]), static_cast<int>(i));
  }

  std::vector<int> counts_, first_;    // scratch
  std::vector<MPI_Request> requests_;  // scratch
};

}  // namespace

extern "C" __attribute__((visibility("default"))) Ranks* contactsim_join_mpi() {
  int has_begun = 0, level = 0;
  MPI_Initialized(&has_begun);
  if (has_begun == 0) MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &level);
  return new MpiRanks;
}

}  // namespace contactsim
