// SPDX-License-Identifier: BSD-3-Clause
#include "core/statics/tangent_probe.hpp"

namespace contactsim {

namespace {

/// Holds the forces of contact for as long as it lives.
class HeldContact {
 public:
  explicit HeldContact(StaticProblem& problem) : problem_(problem) { problem_.hold_rough(true); }
  ~HeldContact() { problem_.hold_rough(false); }
  HeldContact(const HeldContact&) = delete;
  HeldContact& operator=(const HeldContact&) = delete;

 private:
  StaticProblem& problem_;
};

}  // namespace

std::int64_t TangentProbe::differentiate(const Eigen::VectorXd& increment, const Take& take) {
  Eigen::VectorXd base, moved;
  if (!problem_.evaluate_nodes(increment, base)) return 0;
  const HeldContact held(problem_);
  std::vector<std::vector<std::uint32_t>> nodes_of(colours_.n_colours);
  for (std::uint32_t node = 0; node < colours_.colour.size(); ++node) {
    if (colours_.colour[node] < colours_.n_colours && problem_.bodies().is_of_mesh(node))
      nodes_of[colours_.colour[node]].push_back(node);
  }
  std::int64_t n_evaluations = 1;
  for (const std::vector<std::uint32_t>& nodes : nodes_of) {
    if (nodes.empty()) continue;
    for (Eigen::Index unknown = 0; unknown < unknowns_per_node(); ++unknown) {
      Eigen::VectorXd step = Eigen::VectorXd::Zero(problem_.size());
      const double size = problem_.probe_of(place(0, unknown));
      for (const std::uint32_t node : nodes) step(place(node, unknown)) = size;
      problem_.project(step);
      ++n_evaluations;
      if (!problem_.evaluate_nodes(increment + step, moved)) return 0;
      moved = (base - moved) / size;
      for (const std::uint32_t node : nodes) take(node, unknown, moved);
    }
  }
  return n_evaluations;
}

}  // namespace contactsim
