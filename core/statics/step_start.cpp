// SPDX-License-Identifier: BSD-3-Clause
#include "core/statics/step_start.hpp"

#include <algorithm>
#include <cstdint>

#include "core/base/threads.hpp"

namespace contactsim {

namespace {

void copy_values(const std::vector<Lanes>& from, std::vector<Lanes>& to) {
  to.resize(from.size());
  const auto n = static_cast<std::int64_t>(from.size());
  parallel_for_ranges(n, threads_for(from.size()), [&](std::int64_t begin, std::int64_t end) {
    std::copy(from.begin() + begin, from.begin() + end, to.begin() + begin);
  });
}

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
    copy_values(state.blocks[i].values, element_values_[i]);
    hourglass_work_.push_back(state.blocks[i].hourglass_work);
  }
}

void StepStart::restore_elements(State& state) const {
  for (std::size_t i = 0; i < state.blocks.size(); ++i) {
    copy_values(element_values_[i], state.blocks[i].values);
    state.blocks[i].hourglass_work = hourglass_work_[i];
  }
}

void StepStart::restore(State& state) const {
  restore_elements(state);
  state.time = time_;
  state.coordinates = coordinates_;
  state.velocity = velocity_;
  state.rotations = rotations_;
  state.forces = forces_;
}

}  // namespace contactsim
