// SPDX-License-Identifier: BSD-3-Clause
// The springs of contact as the equations of load steps see them.
#include "core/base/optional_index.hpp"
#include "core/statics/static_problem.hpp"

namespace contactsim {

void StaticProblem::find_springs() {
  springs_.clear();
  if (contact_ == nullptr) return;
  std::vector<OptionalIndex<std::uint32_t>> held_at(static_cast<std::size_t>(2 * n_ / 3));
  const auto carry = [&](const SpringEnd& end, std::vector<SpringEnd>& ends) {
    for (const Carrier& carrier : bodies_.carriers(end.node, end.turns))
      ends.push_back({carrier.node, carrier.turns, end.corner, end.share * carrier.share});
  };
  std::vector<Eigen::Matrix3d> free;
  visit_held([&](std::uint32_t node, Eigen::Index first, const Eigen::Matrix3d& held) {
    held_at[2 * std::size_t{node} + (first > 0 ? 1 : 0)] = static_cast<std::uint32_t>(free.size());
    free.push_back(Eigen::Matrix3d::Identity() - held);
  });
  contact_->visit_springs([&](const ContactSpring& spring) {
    springs_.push_back(spring);
    if (!bodies_.empty()) {
      springs_.back().ends.clear();
      for (const SpringEnd& end : spring.ends) carry(end, springs_.back().ends);
    }
    for (SpringEnd& end : springs_.back().ends) {
      const auto held = held_at[2 * std::size_t{end.node} + (end.turns ? 1 : 0)];
      if (held) end.share *= free[*held];
    }
  });
}

void StaticProblem::add_springs(const Eigen::VectorXd& direction, Eigen::VectorXd& product) const {
  const auto first_of = [&](const SpringEnd& end) {
    return 3 * Eigen::Index{end.node} + (end.turns ? n_ : 0);
  };
  for (const ContactSpring& spring : springs_) {
    spring.multiply([&](const SpringEnd& end) { return direction.segment<3>(first_of(end)); },
                    [&](const SpringEnd& end, const Eigen::Vector3d& felt) {
                      product.segment<3>(first_of(end)) += felt;
                    });
  }
}

}  // namespace contactsim
