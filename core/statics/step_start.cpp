// SPDX-License-Identifier: BSD-3-Clause
#include "core/statics/step_start.hpp"

#include <algorithm>
#include <cstdint>

#include "core/base/threads.hpp"
#include "core/dynamics/rank_share.hpp"

namespace contactsim {

namespace {

///   values  the positions that are copied
void copy_values(const std::vector<Lanes>& from, ChunkRange values, std::vector<Lanes>& to) {
  to.resize(from.size());
  const auto first = static_cast<std::int64_t>(values.begin), n = static_cast<std::int64_t>(values.size());
  parallel_for_ranges(n, threads_for(values.size()), [&](std::int64_t begin, std::int64_t end) {
    std::copy(from.begin() + first + begin, from.begin() + first + end, to.begin() + first + begin);
  });
}

ChunkRange all_of(const std::vector<Lanes>& values) { return {0, values.size()}; }

}  // namespace

void StepStart::remember(const State& state) {
  time_ = state.time;
  coordinates_ = state.coordinates;
  velocity_ = state.velocity;
  rotations_ = state.rotations;
  forces_ = state.forces;
  element_values_.resize(state.blocks.size());
  hourglass_work_.clear();
  for (std::size_t i = 0; i < state.blocks.size(); ++i) {
    copy_values(state.blocks[i].values, all_of(state.blocks[i].values), element_values_[i]);
    hourglass_work_.push_back(state.blocks[i].hourglass_work);
  }
}

void StepStart::restore_elements(State& state) const {
  for (std::size_t i = 0; i < state.blocks.size(); ++i) {
    const ChunkRange own = share_ != nullptr ? share_->own_values(i) : all_of(element_values_[i]);
    copy_values(element_values_[i], own, state.blocks[i].values);
    state.blocks[i].hourglass_work = hourglass_work_[i];
  }
}

void StepStart::restore(State& state) const {
  restore_elements(state);
  if (share_ != nullptr) {
    for (std::size_t i = 0; i < state.blocks.size(); ++i)
      copy_values(element_values_[i], all_of(element_values_[i]), state.blocks[i].values);
  }
  state.time = time_;
  state.coordinates = coordinates_;
  state.velocity = velocity_;
  state.rotations = rotations_;
  state.forces = forces_;
}

}  // namespace contactsim
