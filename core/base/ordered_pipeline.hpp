// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <mutex>
#include <thread>
#include <vector>

namespace contactsim {

/// Makes items on all threads and takes them one after the other, in order, always with the same result.
/// Whichever thread finds the next item made takes it while others make later ones; none waits for its turn
/// but where it is too far ahead, so that items may take unequal times.
///   Item  made in place, its memory is used again
template <class Item>
class OrderedPipeline {
 public:
  ///   make(i, item)  of every i below n, on any thread; must not throw
  ///   take(i, item)  of ascending i, one at a time, on any thread, while items after it are made; must not
  ///                  throw
  template <class Make, class Take>
  void run(std::size_t n, int n_threads, const Make& make, const Take& take);

 private:
  static constexpr std::size_t items_per_thread = 8;

  std::vector<Item> items_;  // a ring: item i stands at i modulo its size
};

template <class Item>
template <class Make, class Take>
void OrderedPipeline<Item>::run(std::size_t n, int n_threads, const Make& make, const Take& take) {
  if (n_threads == 1) {
    items_.resize(std::max<std::size_t>(1, items_.size()));
    for (std::size_t i = 0; i < n; ++i) {
      make(i, items_[0]);
      take(i, items_[0]);
    }
    return;
  }
  items_.resize(std::max(items_.size(), items_per_thread * static_cast<std::size_t>(n_threads)));
  const std::size_t n_items = items_.size();
  std::vector<std::atomic<bool>> is_made(n);
  std::atomic<std::size_t> n_begun = 0, n_taken = 0;
  std::mutex taking;
  const auto take_made = [&] {
    const std::unique_lock lock(taking, std::try_to_lock);
    if (!lock) return;
    for (std::size_t i = n_taken; i < n && is_made[i].load(std::memory_order_acquire); n_taken = ++i)
      take(i, items_[i % n_items]);
  };
#pragma omp parallel num_threads(n_threads)
  for (std::size_t i = n_begun++; i < n; i = n_begun++) {
    while (i >= n_taken + n_items) {
      take_made();
      std::this_thread::yield();
    }
    make(i, items_[i % n_items]);
    is_made[i].store(true, std::memory_order_release);
    take_made();
  }
  take_made();
}

}  // namespace contactsim
