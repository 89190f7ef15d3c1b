// SPDX-License-Identifier: BSD-3-Clause
#include "contact/enforcement/contact_stabilization.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>
#include <utility>

#include "contact/enforcement/penalty_limits.hpp"
#include "contact/formulations/near_pairs.hpp"
#include "contact/formulations/nodes_before_faces.hpp"
#include "contact/formulations/penalty.hpp"
#include "contact/geometry/face_map.hpp"
#include "contact/mesh/mean_edge.hpp"
#include "core/base/state_archive.hpp"

namespace contactsim {

namespace {

/// The automatic coefficient over the stiffness of the elements behind both sides. A pressure of a
/// ten-thousandth of their modulus closes a tenth of an element in some ten steps so.
constexpr double coefficient = 1e-3;

/// Of the coefficient along the surface. Source: OptiStruct, CNTSTB, TFRAC.
constexpr double tangential_fraction = 0.1;

Eigen::Matrix3Xd positions(const ContactKinematics& kinematics) {
  const ContactMesh& contact_mesh = kinematics.contact_mesh();
  Eigen::Matrix3Xd x(3, static_cast<Eigen::Index>(contact_mesh.n_nodes()));
  for (const ContactNodeIndex i : contact_mesh.nodes()) x.col(i.value) = kinematics.x(i);
  return x;
}

/// The way from the second side to the first, where planes stand still.
Eigen::Vector3d distance(const ContactKinematics& kinematics, const ContactPoint& sides) {
  Eigen::Vector3d way = kinematics.x(sides.first.nodes[0]);
  for (std::size_t k = 0; k < 4; ++k) {
    const double weight = sides.second.weights[static_cast<Eigen::Index>(k)];
    if (weight != 0.0) way -= weight * kinematics.x(sides.second.nodes[k]);
  }
  return way;
}

}  // namespace

ContactStabilization::ContactStabilization(const ContactSetup& setup, const PairRules& rules,
                                           const ContactKinematics& start)
    : setup_(setup), rules_(rules) {
  for (const SurfacePair& pair : setup.contact.pairs) {
    const bool is_on = setup.is_static() && pair.stabilization.is_on();
    is_on_ = is_on_ || is_on;
    ranges_.push_back(is_on ? pair.stabilization.range.value_or(mean_edge(start, pair)) : 0.0);
  }
}

/// Of the pair's remaining fraction and what is left of the rest, times the steps in the block.
double ContactStabilization::factor(const SurfacePair& pair) const {
  const double remains = pair.stabilization.remaining_fraction.value_or(0.0);
  return level_.n_steps * (remains + (1.0 - remains) * level_.ramp);
}

double ContactStabilization::largest_share() const {
  double largest = 0.0;
  for (const PairIndex i : indices(ranges_)) {
    const SurfacePair& pair = setup_.contact.pairs[i];
    if (ranges_[i] > 0.0 && rules_[i].is_active)
      largest = std::max(largest, coefficient * *pair.stabilization.scale * factor(pair));
  }
  return largest;
}

/// Adds a node and what it is near to.
///   other  of a face, null of a plane
void ContactStabilization::add(const ContactKinematics& kinematics, ContactPoint sides, double gap,
                               const PenaltyProperties* other) {
  constexpr double of_penalty = coefficient / (penalty_over_element * static_penalty_scale);
  const SurfaceNode& node = kinematics.contact_mesh().surface_nodes[sides.row()];
  const SurfacePair& pair = setup_.contact.pairs[sides.pair];
  sides.first.nodes.fill(node.node);
  sides.first.weights = Eigen::Vector4d::UnitX();
  const double area = pair.node_share() * kinematics.area_against(node, sides.normal, pair.smoothing);
  const double per_area = of_penalty * *pair.stabilization.scale *
                          stiffness_of_sides(node.penalty_properties, other) *
                          (1.0 - std::max(gap, 0.0) / ranges_[sides.pair]);
  points_.push_back({sides, per_area * area, distance(kinematics, sides)});
}

void ContactStabilization::add_faces(const ContactKinematics& kinematics, const Motion& motion) {
  const ContactMesh& contact_mesh = kinematics.contact_mesh();
  ContactSearch search(contact_mesh, *setup_.model.mesh, rules_, {}, setup_.definition.dash,
                       setup_.model.rigid.nodes.body_of);
  search.reach_at_least(ranges_);
  std::vector<NodeBeforeFace> near;
  visit_nodes_before_faces(search, kinematics, rules_, motion, [&](const NodeBeforeFace& node) {
    if (std::abs(node.gap) < ranges_[node.pair] && !rules_[node.pair].only_ties()) near.push_back(node);
  });
  // A node stands before several faces of a pair: the nearest counts.
  std::ranges::sort(near, {}, [](const NodeBeforeFace& node) {
    return std::tuple(node.pair.value, node.row.value, std::abs(node.gap), node.face.value);
  });
  const auto others = std::ranges::unique(
      near, {}, [](const NodeBeforeFace& node) { return std::pair(node.pair.value, node.row.value); });
  near.erase(others.begin(), others.end());
  for (const NodeBeforeFace& found : near) {
    const ContactFace& face = contact_mesh.faces[found.face];
    const bool is_triangle = kinematics.face(found.face).is_triangle;
    ContactPoint sides;
    sides.pair = found.pair;
    sides.first_entity = found.row.value;
    sides.second_entity = found.face.value;
    sides.second = {face.corners, corner_weights(found.point.xi, found.point.eta, is_triangle)};
    sides.normal = found.point.normal;
    add(kinematics, sides, found.gap, &face.penalty_properties);
  }
}

void ContactStabilization::add_planes(const ContactKinematics& kinematics) {
  const ContactMesh& contact_mesh = kinematics.contact_mesh();
  const auto& surfaces = setup_.contact.surfaces.surfaces;
  for (const PairIndex i : indices(ranges_)) {
    if (!(ranges_[i] > 0.0) || !rules_[i].is_active) continue;
    const SurfacePair& pair = setup_.contact.pairs[i];
    for (const auto& [with_plane, other] :
         {std::pair(pair.first, pair.second), std::pair(pair.second, pair.first)}) {
      for (const std::uint32_t number : surfaces[with_plane].analytic_planes) {
        const AnalyticPlane& plane = setup_.contact.planes[number];
        ContactPoint sides;
        sides.pair = i;
        sides.normal = plane.normal.normalized();
        for (const SurfaceNodeIndex row : contact_mesh.rows_of(other)) {
          const SurfaceNode& node = contact_mesh.surface_nodes[row];
          const double gap = (kinematics.x(node.node) - plane.origin).dot(sides.normal) - node.radius -
                             rules_.gap_offsets().of_node(i, row);
          if (!(std::abs(gap) < ranges_[i]) || !is_facing(kinematics, node, sides.normal)) continue;
          sides.first_entity = row.value;
          add(kinematics, sides, gap, nullptr);
        }
      }
      if (pair.first == pair.second) break;
    }
  }
}

void ContactStabilization::begin_step(ContactKinematics kinematics, const Motion& motion) {
  points_.clear();
  if (!is_on_) return;
  kinematics.bound_all();
  begun_ = positions(kinematics);
  add_faces(kinematics, motion);
  add_planes(kinematics);
}

Eigen::Matrix3d ContactStabilization::stiffness_now(const Point& point) const {
  const SurfacePair& pair = setup_.contact.pairs[point.sides.pair];
  const Eigen::Matrix3d along = point.sides.normal * point.sides.normal.transpose();
  const double tangential = pair.stabilization.tangential_fraction.value_or(tangential_fraction);
  return factor(pair) * point.stiffness * (along + tangential * (Eigen::Matrix3d::Identity() - along));
}

void ContactStabilization::find_forces(const ContactKinematics& kinematics) {
  for (Point& point : points_)
    point.sides.tangential = -stiffness_now(point) * (distance(kinematics, point.sides) - point.start);
}

void ContactStabilization::add_to(ContactAssembler& assembler) const {
  for (const Point& point : points_) assembler.add_forces(point.sides);
}

double ContactStabilization::force() const {
  double squares = 0.0;
  for (const Point& point : points_) squares += point.sides.tangential.squaredNorm();
  return std::sqrt(squares);
}

void ContactStabilization::visit_springs(const ContactSprings& springs,
                                         const std::function<void(const ContactSpring&)>& take) const {
  if (!acts()) return;
  for (const Point& point : points_) take(springs.spring_between(point.sides, stiffness_now(point)));
}

std::vector<ContactNodeIndex> ContactStabilization::nodes() const {
  std::vector<ContactNodeIndex> nodes;
  for (const Point& point : points_) {
    nodes.push_back(point.sides.first.nodes[0]);
    for (std::size_t k = 0; k < 4; ++k) {
      if (point.sides.second.weights[static_cast<Eigen::Index>(k)] != 0.0)
        nodes.push_back(point.sides.second.nodes[k]);
    }
  }
  return nodes;
}

double ContactStabilization::end_step(const ContactKinematics& kinematics) {
  if (!is_on_) return 0.0;
  Eigen::Matrix3Xd now = Eigen::Matrix3Xd::Zero(3, begun_.cols());
  for (const Point& point : points_) {
    const auto add_one = [&](const ContactPointSide& side, std::size_t k, double sign) {
      const double weight = side.weights[static_cast<Eigen::Index>(k)];
      if (weight != 0.0) now.col(side.nodes[k].value) += sign * weight * point.sides.tangential;
    };
    for (std::size_t k = 0; k < 4; ++k) {
      add_one(point.sides.first, k, 1.0);
      add_one(point.sides.second, k, -1.0);
    }
  }
  Eigen::Matrix3Xd mean = now;
  if (last_.cols() == now.cols()) mean += last_;
  const double taken = -0.5 * mean.cwiseProduct(positions(kinematics) - begun_).sum();
  last_ = std::move(now);
  return taken;
}

void ContactStabilization::archive(std::size_t n_nodes, StateArchive& saved) {
  if (!is_on_) return;
  const std::string name = "contact/stabilization/forces";
  if (saved.restores() ? !saved.has(name) : last_.cols() == 0) return;
  last_.resize(3, static_cast<Eigen::Index>(n_nodes));
  saved.fixed(name, last_);
}

}  // namespace contactsim
