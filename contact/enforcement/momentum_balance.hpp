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

/// Forces that let nothing through: at the end of the coming step no contact point penetrates, and tied
/// points are where they belong. Contact points are constraints on the velocities of their carriers, which
/// lumped masses make cheap: A = B M^-1 B^T with one row per point. A pass gives every point the force that
/// would close its gap if all points around had the same pressure, pushing only, with friction returned to
/// the Coulomb cone; so a uniform pressure takes one pass, and waves of the mesh's length a few. Passes are
/// accelerated, begin with half of the forces of the step before, and end when the forces no longer change.
/// Each force acts on both sides of its point alike. The same bits for any number of threads.
///
/// A point that is apart may close by its gap; one that penetrates comes out slowly, so that nothing is
/// thrown out. What meets loses the energy of the motion of its carriers against each other, once; the
/// elements behind them keep theirs.
///
/// Source: forward increment Lagrange multipliers of Carpenter, Taylor and Katona, IJNME 32 (1991) 103-128;
/// momentum balance iterations of Heinstein, Mello, Attaway and Laursen, CMAME 187 (2000) 621-640;
/// accelerated projected gradients of Mazhar, Heyn, Negrut and Tasora, ACM Trans. Graph. 34 (2015) 32,
/// restarted as by O'Donoghue and Candes, Found. Comput. Math. 15 (2015) 715-732.
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
  /// What a row has of one carrier: its velocity along the normal, and along any direction.
  struct Term {
    std::uint32_t carrier = 0;
    double weight = 0.0;                            // signed [1]
    Eigen::Vector3d arm = Eigen::Vector3d::Zero();  // from the carrier, times the weight [length]
  };
  /// A contact point.
  struct Row {
    std::uint32_t point = 0;  // in points_
    std::uint32_t first_term = 0, n_terms = 0;
    bool is_plain = true;       // all carriers are
    bool slides_freely = true;  // without friction
    const PairRule* rule = nullptr;
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();  // [1]
    double start = 0.0;     // gap at the end of the step without forces, less what it may be [length]
    double softness = 0.0;  // gap per force of this point when all have its pressure, at most [length/force]
    double limit_per_force = 0.0;                     // of the tangential force; < 0: the rule says [1]
    Eigen::Vector3d held = Eigen::Vector3d::Zero();   // slip of earlier steps that friction holds [length]
    Eigen::Vector3d slip = Eigen::Vector3d::Zero();   // of the step without forces, in the plane [length]
    Eigen::Vector3d force = Eigen::Vector3d::Zero();  // on the first side [force]
    Eigen::Vector3d ahead = Eigen::Vector3d::Zero();  // that the next pass looks at [force]
  };
  /// A tied point.
  struct TieRow {
    Tie* tie = nullptr;
    std::uint32_t point = 0;  // of the tie
    std::uint32_t first_term = 0, n_terms = 0;
    Eigen::Vector3d start =
        Eigen::Vector3d::Zero();  // distance at the end of the step without forces [length]
    double softness = 0.0;        // as of contact points [length/force]
    Eigen::Vector3d force = Eigen::Vector3d::Zero(), ahead = Eigen::Vector3d::Zero();  // as of contact points
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

  /// Sums of a pass.
  struct Pass {
    double changed = 0.0, all = 0.0;  // of forces [force]
    double uphill = 0.0;              // > 0: the acceleration has gone too far
  };

  static std::uint32_t kind_of(const ContactRecord& record);
  void add_terms(const ContactRecord& record, std::vector<Term>& terms);
  void recall(const ContactRecord& record, Row& row) const;
  void find_softness();
  Eigen::Vector3d change(const Row& row) const;
  Eigen::Vector3d change(const TieRow& row) const;
  void push_all();
  Eigen::Vector3d next_force(const Row& row) const;
  Eigen::Vector3d next_force(const TieRow& row) const;
  double slip_limit(const Row& row, double normal_force) const;
  Pass pass(double momentum);
  Eigen::Vector3d relative_velocity(const ContactRecord& record, bool is_before) const;
  void finish(Row& row);
  void finish(const TieRow& row);
  void remember();

  NodeMobility mobility_;
  const MovingSurface* surface_ = nullptr;
  double dt_ = 0.0, dt_before_ = 0.0;
  std::vector<ContactRecord> points_;
  std::vector<Term> terms_;
  std::vector<TieTerm> tie_terms_;
  std::vector<CarrierTerm> carriers_;           // scratch
  std::vector<std::array<double, 2>> area_of_;  // [n_carriers] scratch: areas that lean on each, by
                                                // translation and by rotation
  std::vector<Row> rows_;
  std::vector<TieRow> tie_rows_;
  std::vector<Memory> memory_;  // ascending by key
  Loss loss_;
};

}  // namespace contactsim
