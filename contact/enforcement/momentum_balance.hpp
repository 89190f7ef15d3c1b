// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "contact/contact_record.hpp"
#include "contact/contact_renumbering.hpp"
#include "contact/contact_scene.hpp"
#include "contact/enforcement/node_mobility.hpp"
#include "contact/ties.hpp"

namespace contactsim {

class StateArchive;

/// What balancing a step came to.
struct BalanceReport {
  int n_iterations = 0;
  double residual = 0.0;  ///< change of all forces in the last iteration over their sum [1]
};

/// Forces that let nothing through: at the end of the coming step no contact point penetrates, and tied points
/// are where they belong. Contact points are constraints on the velocities of their carriers. They are passed
/// over one by one in a fixed order, to and fro, each getting the force that closes its own gap, pushing only,
/// with friction returned to the Coulomb cone, until the forces no longer change. Forces begin as those of the
/// step before. Each force acts on both sides of its point alike.
///
/// A point that is still apart may close by its gap; one that penetrates already comes out slowly, so that
/// nothing is thrown out. What meets loses the energy of the motion of its carriers against each other, once;
/// elements behind them keep theirs.
///
/// Source: forward increment Lagrange multipliers of Carpenter, Taylor and Katona, IJNME 32 (1991) 103-128;
/// momentum balance iterations of Heinstein, Mello, Attaway and Laursen, CMAME 187 (2000) 621-640; projected
/// Gauss-Seidel as in Jean, CMAME 177 (1999) 235-257.
class MomentumBalance {
 public:
  /// Begins a step.
  ///   surface  sees the velocities of the coming step without these forces
  void begin(const Model& model, const MovingSurface& surface, const State& state);
  /// Adds a contact point, or a law's force that acts besides.
  ///   rule  of its pair, which must live on
  ///   thickness  of the thinner side [length]
  void add(const ContactRecord& record, const PairRule& rule, double thickness);
  /// Adds the points of a tie, which must live on; find_forces() answers for it afterwards.
  void add(Tie& tie);
  /// Finds the forces.
  BalanceReport solve(int max_iterations);
  /// The points in the order of add(), with force, friction, slip and what is lost.
  std::span<const ContactRecord> points() const { return points_; }
  /// The forces of a tie on its corners.
  TieForces find_forces(const Tie& tie) const;
  /// Lost in half of the step before and in half of the coming one, to friction and where sides met [energy].
  struct Loss {
    double friction_before = 0.0, friction_after = 0.0, impact_before = 0.0, impact_after = 0.0;
  };
  const Loss& loss() const { return loss_; }

  /// Goes over to other faces and nodes.
  void renumber(const ContactRenumbering& places);
  void archive(StateArchive& saved);

 private:
  static constexpr std::uint32_t none = 0xffffffff;

  /// One constraint: a contact point, or all points whose pressure is that of one node, each along its own
  /// normal by its share of the area.
  struct Row {
    std::uint32_t first_point = none, last_point = none;  // in points_, linked by next_point_
    std::uint32_t next = none;                            // row with the same multiplier
    std::uint32_t part = 0;                               // number of the row among those
    bool is_open = false;                                 // nothing of it closes yet
    bool slides_freely = true;                            // without friction
    bool is_plain = true;                                 // all carriers are
    std::uint32_t first_term = 0, n_terms = 0;
    const PairRule* rule = nullptr;
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();  // mean [1]
    double area = 0.0;                                 // [length^2]
    double gap = 0.0, closing = 0.0;                   // means by area [length]
    double thickness = 0.0;                            // of the thinnest side [length]
    double start = 0.0;         // gap at the end of the step without forces, less what it may be [length]
    double mobility = 0.0;      // gap per normal force [length/force]
    double side_mobility = 0.0;      // slip per tangential force, of the more mobile direction [length/force]
    double force = 0.0;              // normal [force]
    double limit_per_force = 0.0;    // of the tangential force; < 0: the rule says [1]
    Eigen::Vector3d held = Eigen::Vector3d::Zero();  // slip of earlier steps that friction holds [length]
    Eigen::Vector3d slip = Eigen::Vector3d::Zero();  // of the step without forces, in the plane [length]
    Eigen::Vector3d tangential = Eigen::Vector3d::Zero();  // [force]
  };
  /// What a row has of one carrier: its velocity along the normals, and along any direction.
  struct Term {
    std::uint32_t carrier = 0;
    NodeVector normal = NodeVector::Zero();  // sum of share, weight and normal; the fourth number is 0 [1]
    double weight = 0.0;                     // sum of share and weight [1]
    Eigen::Vector3d turn = Eigen::Vector3d::Zero();  // of the normals about the carrier [length]
    Eigen::Vector3d arm = Eigen::Vector3d::Zero();   // sum of share, weight and arm [length]
  };
  /// A tied point.
  struct TieRow {
    std::uint32_t first_term = 0, n_terms = 0;
    Eigen::Vector3d start;            // distance at the end of the step without forces [length]
    Eigen::Matrix3d inverse;          // force per distance [force/length]
    Eigen::Vector3d force;            // on the first side [force]
    Tie* tie = nullptr;
    std::uint32_t point = 0;  // of the tie
  };
  struct TieTerm {
    std::uint32_t carrier = 0;
    Eigen::Matrix3d weight;  // signed [1]
    Eigen::Vector3d arm;     // from the carrier [length]
  };
  /// What is remembered of a contact point.
  struct Memory {
    std::uint32_t kind = 0, first = 0, second = 0, part = 0;
    double pressure = 0.0;  // normal force over area
    Eigen::Vector3d traction = Eigen::Vector3d::Zero(), held = Eigen::Vector3d::Zero();

    using Key = std::array<std::uint32_t, 4>;
    Key key() const { return {kind, first, second, part}; }
  };

  static std::uint32_t kind_of(const ContactRecord& record);
  std::uint32_t find_row(const ContactRecord& record, const PairRule& rule);
  void build(Row& row);
  void add_terms(const Row& row, const ContactRecord& point, double share);
  Memory key_of(const Row& row) const;
  void recall(Row& row) const;
  double normal_change(const Row& row) const;
  Eigen::Vector3d change(const Row& row) const;
  void push_normal(const Row& row, double force);
  void push_along(const Row& row, const Eigen::Vector3d& force);
  Eigen::Vector3d change(const TieRow& row) const;
  void push(const TieRow& row, const Eigen::Vector3d& force);
  double pass(Row& row);
  double pass(TieRow& row);
  double slip_limit(const Row& row) const;
  Eigen::Vector3d relative_velocity(const ContactRecord& record, bool is_before) const;
  template <class Visit>
  void visit_points(const Row& row, const Visit& visit);
  Eigen::Vector3d change_at(const ContactRecord& point);
  void finish(Row& row);
  void finish(const TieRow& row);

  NodeMobility mobility_;
  const MovingSurface* surface_ = nullptr;
  double dt_ = 0.0, dt_before_ = 0.0;
  std::vector<ContactRecord> points_;
  std::vector<std::uint32_t> next_point_;     // [n_points] of the same row
  std::vector<std::uint32_t> row_of_node_;    // [n_contact_nodes] first row with that multiplier
  std::vector<Term> terms_;
  std::vector<CarrierTerm> carriers_;         // scratch
  std::vector<TieTerm> tie_terms_;
  std::vector<Row> rows_;
  std::vector<TieRow> tie_rows_;
  std::vector<Memory> memory_;  // ascending by key
  Loss loss_;
};

}  // namespace contactsim
