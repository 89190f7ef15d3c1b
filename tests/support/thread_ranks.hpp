// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <barrier>
#include <cstddef>
#include <functional>
#include <span>
#include <stdexcept>
#include <thread>
#include <vector>

#include "core/parallel/ranks.hpp"

namespace contactsim::test {

/// Ranks that are threads of one process: what they say to each other is copied between two barriers.
class ThreadRanks {
 public:
  explicit ThreadRanks(int count) : count_(count), all_(count), views_(static_cast<std::size_t>(count)) {}

  /// Calls work(ranks) on each rank, and throws what one of them throws.
  void run(const std::function<void(Ranks&)>& work) {
    std::vector<std::exception_ptr> thrown(static_cast<std::size_t>(count_));
    std::vector<std::thread> threads;
    for (int rank = 0; rank < count_; ++rank) {
      threads.emplace_back([&, rank] {
        One ranks(rank, *this);
        try {
          work(ranks);
        } catch (...) {
          thrown[static_cast<std::size_t>(rank)] = std::current_exception();
          all_.arrive_and_drop();
        }
      });
    }
    for (std::thread& thread : threads) thread.join();
    for (const std::exception_ptr& problem : thrown) {
      if (problem) std::rethrow_exception(problem);
    }
  }

 private:
  struct View {
    std::span<const std::byte> bytes;
    std::span<const std::span<const std::byte>> messages;
  };

  class One final : public Ranks {
   public:
    One(int rank, ThreadRanks& team) : Ranks(rank, team.count_), team_(team) {}

    void gather(std::span<std::byte> all, std::span<const std::size_t> begins) override {
      own().bytes = all;
      team_.all_.arrive_and_wait();
      for (std::size_t other = 0; other + 1 < begins.size(); ++other) {
        if (other == self()) continue;
        const std::size_t n = begins[other + 1] - begins[other];
        std::ranges::copy(team_.views_[other].bytes.subspan(begins[other], n),
                          all.subspan(begins[other], n).begin());
      }
      team_.all_.arrive_and_wait();
    }

    void broadcast(std::span<std::byte> bytes) override {
      own().bytes = bytes;
      team_.all_.arrive_and_wait();
      if (!is_root()) std::ranges::copy(team_.views_[0].bytes, bytes.begin());
      team_.all_.arrive_and_wait();
    }

    void exchange(std::span<const std::span<const std::byte>> out,
                  std::span<const std::span<std::byte>> in) override {
      own().messages = out;
      team_.all_.arrive_and_wait();
      for (std::size_t other = 0; other < in.size(); ++other) {
        if (other == self()) continue;
        const std::span<const std::byte> message = team_.views_[other].messages[self()];
        if (message.size() != in[other].size()) throw std::logic_error("a message of another size");
        std::ranges::copy(message, in[other].begin());
      }
      team_.all_.arrive_and_wait();
    }

    bool wait_for_all(double /*seconds*/) override {
      team_.all_.arrive_and_wait();
      return true;
    }

    [[noreturn]] void abort(int /*exit_code*/) override { throw std::runtime_error("the ranks are ended"); }

   private:
    std::size_t self() const { return static_cast<std::size_t>(rank()); }
    View& own() { return team_.views_[self()]; }

    ThreadRanks& team_;
  };

  int count_;
  std::barrier<> all_;
  std::vector<View> views_;  // [count] what each has to say
};

}  // namespace contactsim::test
