// SPDX-License-Identifier: BSD-3-Clause
#include "core/statics/fading_forces.hpp"

#include <span>
#include <string>
#include <utility>

#include "core/base/state_archive.hpp"

namespace contactsim {

void FadingForces::begin(Eigen::VectorXd forces, double from, double until) {
  forces_ = std::move(forces);
  from_ = from;
  until_ = until;
}

void FadingForces::archive(Eigen::Index size, StateArchive& saved) {
  const std::string name = "run/out_of_balance";
  if (saved.restores() ? !saved.has(name) : empty()) return;
  forces_.resize(size);
  saved.fixed(name, std::span(forces_.data(), static_cast<std::size_t>(forces_.size())));
  saved.numbers(name + "_times", from_, until_);
}

}  // namespace contactsim
