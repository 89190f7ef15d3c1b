// SPDX-License-Identifier: BSD-3-Clause
#include "core/statics/static_springs.hpp"

namespace contactsim {

void StaticSprings::find(const StaticContact* contact, const StaticBodies& bodies,
                         const HeldDirections& held) {
  springs_.clear();
  if (contact == nullptr) return;
  const FreeProjections free(held, bodies.n_nodes());
  const auto carry = [&](const SpringEnd& end, std::vector<SpringEnd>& ends) {
    for (const Carrier& carrier : bodies.carriers(end.node, end.turns))
      ends.push_back({carrier.node, carrier.turns, end.corner, end.share * carrier.share});
  };
  contact->visit_springs([&](const ContactSpring& spring) {
    springs_.push_back(spring);
    if (!bodies.empty()) {
      springs_.back().ends.clear();
      for (const SpringEnd& end : spring.ends) carry(end, springs_.back().ends);
    }
    for (SpringEnd& end : springs_.back().ends) {
      if (const Eigen::Matrix3d* left = free.find(end.node, end.turns)) end.share *= *left;
    }
  });
}

void StaticSprings::add(Eigen::Index n, const Eigen::VectorXd& direction, Eigen::VectorXd& product) const {
  const auto first_of = [&](const SpringEnd& end) {
    return 3 * Eigen::Index{end.node} + (end.turns ? n : 0);
  };
  for (const ContactSpring& spring : springs_) {
    spring.multiply([&](const SpringEnd& end) { return direction.segment<3>(first_of(end)); },
                    [&](const SpringEnd& end, const Eigen::Vector3d& felt) {
                      product.segment<3>(first_of(end)) += felt;
                    });
  }
}

}  // namespace contactsim
