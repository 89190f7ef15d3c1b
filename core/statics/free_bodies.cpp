// SPDX-License-Identifier: BSD-3-Clause
#include "core/statics/free_bodies.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/base/optional_index.hpp"

namespace contactsim {

namespace {

using BodyModes = Eigen::Matrix<double, 3, 6>;
using ModeMatrix = Eigen::Matrix<double, 6, 6>;

/// What elements and rigid bodies join.
struct Body {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();  ///< mean of its nodes [length]
  std::size_t n_nodes = 0;
  double size = 0.0;                     ///< of the node farthest from there [length]
  ModeMatrix held = ModeMatrix::Zero();  ///< what conditions hold of its rigid motions [1]
  bool is_free = false;
  bool is_stabilized = false;
};

/// Calls take(node) for the nodes that a node moves with, by elements or as parts of a rigid body.
template <class Take>
void for_each_joined(const NodeGraph& graph, const StaticBodies& rigid, std::uint32_t node,
                     const Take& take) {
  for (const std::uint32_t other : graph.neighbours(node)) take(other);
  if (rigid.moves(node)) take(rigid.centre_node(rigid.body_of(node)));
  if (rigid.is_of_mesh(node)) return;
  for (const NodeIndex other : rigid.body(rigid.owner(node)).nodes) take(other.value);
}

/// Numbers bodies in the order of their first nodes [n_nodes]; nodes without elements have none.
std::vector<OptionalIndex<std::uint32_t>> number_bodies(const NodeGraph& graph, const StaticBodies& rigid) {
  std::vector<OptionalIndex<std::uint32_t>> body_of(graph.n_nodes());
  std::uint32_t n_bodies = 0;
  std::vector<std::uint32_t> open;
  for (std::uint32_t first = 0; first < graph.n_nodes(); ++first) {
    if (body_of[first] || (graph.neighbours(first).empty() && !rigid.moves(first))) continue;
    body_of[first] = n_bodies;
    open.push_back(first);
    while (!open.empty()) {
      const std::uint32_t node = open.back();
      open.pop_back();
      for_each_joined(graph, rigid, node, [&](std::uint32_t other) {
        if (body_of[other]) return;
        body_of[other] = n_bodies;
        open.push_back(other);
      });
    }
    ++n_bodies;
  }
  return body_of;
}

/// How far translations and rotations of the whole body, the latter by 1 at its size, move a node.
BodyModes modes_at(const Body& body, const Eigen::Vector3d& x) {
  BodyModes modes;
  modes.leftCols<3>().setIdentity();
  const Eigen::Vector3d arm = (x - body.centre) / body.size;
  for (int i = 0; i < 3; ++i) modes.col(3 + i) = Eigen::Vector3d::Unit(i).cross(arm);
  return modes;
}

bool is_free(const Body& body) {
  if (!(body.size > 0.0)) return true;
  constexpr double nothing = 1e-9;
  const Eigen::SelfAdjointEigenSolver<ModeMatrix> solver(body.held, Eigen::EigenvaluesOnly);
  return !(solver.eigenvalues()[0] > nothing);
}

/// A cube of n nodes in spacing h, of modulus E, has nodes of stiffness E h and resists being stretched with
/// E h n^(1/3).
double ground_share(const Body& body) {
  constexpr double share = 1e-2;
  return share * std::pow(static_cast<double>(body.n_nodes), -2.0 / 3.0);
}

}  // namespace

FreeBodies find_free_bodies(const StaticProblem& problem, const NodeGraph& graph,
                            const Eigen::Matrix3Xd& coordinates, const Stabilization& stabilization) {
  const StaticBodies& rigid = problem.bodies();
  const auto body_of = number_bodies(graph, rigid);
  std::vector<Body> bodies;
  const auto for_each_node = [&](const auto& do_one) {
    for (std::uint32_t node = 0; node < graph.n_nodes(); ++node) {
      if (!body_of[node]) continue;
      bodies.resize(std::max<std::size_t>(bodies.size(), *body_of[node] + std::size_t{1}));
      do_one(bodies[*body_of[node]], Eigen::Vector3d(coordinates.col(node)));
    }
  };
  for_each_node([](Body& body, const Eigen::Vector3d& x) {
    body.centre += (x - body.centre) / static_cast<double>(++body.n_nodes);
  });
  for_each_node([](Body& body, const Eigen::Vector3d& x) {
    body.size = std::max(body.size, (x - body.centre).norm());
  });
  problem.held().visit([&](std::uint32_t node, Eigen::Index first, const Eigen::Matrix3d& held) {
    if (!body_of[node]) return;
    Body& body = bodies[*body_of[node]];
    if (!rigid.is_of_mesh(node) && node == rigid.turning_node(rigid.owner(node))) {
      body.held.bottomRightCorner<3, 3>() += held;
    } else if (first == 0) {
      const BodyModes modes = modes_at(body, coordinates.col(node));
      body.held += modes.transpose() * held * modes;
    } else {
      body.held.bottomRightCorner<3, 3>() += held;
    }
  });
  for (Body& body : bodies) body.is_free = is_free(body);
  for (const std::uint32_t node : stabilization.nodes) {
    if (stabilization.share > 0.0 && body_of[node]) bodies[*body_of[node]].is_stabilized = true;
  }
  FreeBodies free;
  free.shares.assign(graph.n_nodes(), 0.0);
  for (std::uint32_t node = 0; node < graph.n_nodes(); ++node) {
    if (!body_of[node]) continue;
    const Body& body = bodies[*body_of[node]];
    const double part = body.is_stabilized ? std::min(stabilization.share, 1.0) : 1.0;
    double& share = free.shares[node];
    if (rigid.is_of_mesh(node)) {
      share = body.is_free ? part * ground_share(body) : 0.0;
    } else {
      share = body.is_free ? std::max(part * StaticBodies::ground_share, StaticBodies::least_share)
                           : StaticBodies::least_share;
    }
    free.are_any = free.are_any || body.is_free;
  }
  for (std::uint32_t i = 0; i < rigid.size(); ++i) {
    const auto& body = body_of[rigid.centre_node(i)];
    if (body && bodies[*body].is_free) free.rigid.push_back(i);
  }
  return free;
}

}  // namespace contactsim
