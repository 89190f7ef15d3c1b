// SPDX-License-Identifier: BSD-3-Clause
#include "core/statics/no_equilibrium.hpp"

#include <fmt/format.h>

namespace contactsim {

namespace {

/// Forces left over that are this many times as large as what loads them speak of a body that flies away.
constexpr double runaway = 1e3;

std::string name_of(NodeIndex node, const StaticBodies& bodies, const Mesh& mesh) {
  if (bodies.is_of_mesh(node.value)) return fmt::format("node {}", mesh.node_id(node));
  const std::uint32_t body = bodies.owner(node.value);
  const char* what = node.value == bodies.turning_node(body) ? "the moment on" : "the force on";
  return fmt::format("{} the rigid body '{}'", what, bodies.body(body).name);
}

}  // namespace

std::string describe_imbalance(const StaticProblem& problem, const Mesh& mesh, const CgReport& search,
                               const Eigen::VectorXd& residual) {
  if (!(search.reference > 0.0)) return "elements turn inside out from the first guess on";
  std::string text =
      fmt::format("after {} iterations {:.4g} of forces are left over, {:.3g} of their reference {:.4g}",
                  search.n_iterations, search.residual, search.residual / search.reference, search.reference);
  if (residual.size() == problem.size())
    text += ", most at " + name_of(problem.unknowns().largest_at(residual), problem.bodies(), mesh);
  if (!(search.residual < runaway * search.reference))
    text += "; are all bodies held, by conditions or by what they are joined to?";
  return text;
}

std::string name_free_bodies(const StaticProblem& problem, std::span<const std::uint32_t> free) {
  std::string names;
  for (const std::uint32_t i : free)
    names += (names.empty() ? "'" : ", '") + problem.bodies().body(i).name + "'";
  if (names.empty()) return names;
  const char* what = problem.contact() != nullptr ? "contact alone may hold" : "nothing else holds";
  return fmt::format("; conditions leave rigid motions, which {}, to {}", what, names);
}

}  // namespace contactsim
