// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <vector>

#include "contact/enforcement/constraint_pass.hpp"
#include "contact/enforcement/node_mobility.hpp"
#include "contact/formulations/tied/ties.hpp"
#include "core/base/optional_index.hpp"

namespace contactsim {

/// The points of ties as constraints: at the end of the coming step each is where it was tied. A point that
/// stands off the second face turns with it.
class TieConstraints {
 public:
  explicit TieConstraints(NodeMobility& mobility) : mobility_(mobility) {}

  /// Begins a step.
  ///   dt  the coming one [time]
  void begin(const ContactKinematics& kinematics, double dt);
  /// Adds the points of a tie, which must outlive the step.
  void add(Tie& tie);
  bool empty() const { return rows_.empty(); }

  // As of ContactConstraints.
  void add_areas(LeaningAreas& areas) const;
  void add_loads(const LeaningAreas& areas, std::vector<CarrierLoad>& loads) const;
  void set_softness(const LeaningAreas& areas, const LightCarriers& light, double least);
  void add_rows(LightCarriers& light);
  std::uint32_t n_light_points() const { return static_cast<std::uint32_t>(light_points_.size()); }
  LightAnswer answer(std::uint32_t light_point, const Eigen::Vector3d& velocity) const;
  void push_forces();
  ConstraintPass pass(double momentum, const LightCarriers& light);
  /// Gives the points of the ties their forces.
  void finish();

 private:
  struct Term {
    std::uint32_t carrier = 0;
    Eigen::Matrix3d weight;  // signed [1]
    Eigen::Vector3d arm;     // from the carrier [length]
    double bound = 0.0;      // by how much the weight lengthens vectors at most [1]
  };
  struct Row {
    Tie* tie = nullptr;
    std::uint32_t point = 0;  // of the tie
    std::uint32_t first_term = 0, n_terms = 0;
    Eigen::Vector3d start =
        Eigen::Vector3d::Zero();         // distance at the end of the step without forces [length]
    double softness = 0.0;               // as of contact points [length/force]
    OptionalIndex<std::uint32_t> light;  // its row among those with light carriers
    Eigen::Vector3d force = Eigen::Vector3d::Zero(), ahead = Eigen::Vector3d::Zero();  // [force]
  };
  /// Corners of a tie, and the axes that turn with the second side.
  struct Sides {
    CornerVectors x;
    FaceCorners second;
    Eigen::Matrix3d axes;
  };

  std::span<const Term> terms_of(const Row& row) const {
    return std::span(terms_).subspan(row.first_term, row.n_terms);
  }
  double area_of(const Row& row) const { return row.tie->points[row.point].area; }
  Sides sides_of(const Tie& tie) const;
  void add_point(Tie& tie, std::uint32_t index, const Sides& sides);
  void add_term(std::uint32_t carrier, const Eigen::Matrix3d& weight, const Eigen::Vector3d& arm);
  void add_first_terms(const Tie& tie, const TiePoint& point);
  void add_second_terms(const Tie& tie, const TiePoint& point, const Eigen::Vector3d& offset,
                        const std::array<Eigen::Matrix3d, 4>& transferred);
  double turn_size(const Term& term) const;
  Eigen::Vector3d change(const Row& row) const;
  double share(const Term& term, const LeaningAreas& areas) const;
  Eigen::Vector3d next_force(const Row& row, const Eigen::Vector3d& changed) const;
  void push(const Row& row);

  NodeMobility& mobility_;
  const ContactKinematics* kinematics_ = nullptr;
  double dt_ = 0.0;
  std::vector<Row> rows_;
  std::vector<Term> terms_;
  std::vector<CarrierTerm> carriers_;        // scratch
  std::vector<std::uint32_t> light_points_;  // rows with light carriers
};

}  // namespace contactsim
