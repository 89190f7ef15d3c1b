// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "contact/enforcement/constraint_pass.hpp"
#include "contact/enforcement/contact_history.hpp"
#include "contact/enforcement/point_carriers.hpp"
#include "contact/enforcement/push_lists.hpp"
#include "contact/enforcement/recovery_energy.hpp"
#include "contact/formulations/contact_step_context.hpp"
#include "contact/geometry/contact_point.hpp"
#include "core/base/optional_index.hpp"
#include "core/base/threads.hpp"

namespace contactsim {

/// Lost in half of the step before and in half of the coming one, to friction and where sides met [energy].
struct ContactLoss {
  double friction_before = 0.0, friction_after = 0.0, impact_before = 0.0, impact_after = 0.0;

  ContactLoss& operator+=(const ContactLoss& other) {
    friction_before += other.friction_before;
    friction_after += other.friction_after;
    impact_before += other.impact_before;
    impact_after += other.impact_after;
    return *this;
  }
};

/// The contact points of a step as constraints: none penetrates at its end. Forces push only, but where what
/// has touched may not part; friction returns to the Coulomb cone.
class ContactConstraints {
 public:
  explicit ContactConstraints(NodeMobility& mobility) : carriers_(mobility) {}

  /// Begins a step.
  ///   dt_before, dt  of the step that ended, of the coming one [time]
  void begin(const ContactKinematics& kinematics, double dt_before, double dt);
  /// Adds a contact point, or a law's force that acts besides.
  ///   rule       of its pair, which must outlive the step
  ///   thickness  of the thinner side [length]
  void add(const ContactPoint& contact_point, const PairRule& rule, double thickness);

  /// Adds the areas of the points to those of their carriers.
  void add_areas(LeaningAreas& areas) const;
  /// Adds the points to what leans on their carriers.
  void add_loads(const LeaningAreas& areas, std::vector<CarrierLoad>& loads) const;
  /// Softness of each point, by all areas but those of light carriers. Points between sides that are held or
  /// driven, where nothing can be done, are no constraints any more.
  ///   least  softness by area of points between light carriers [length/(force length^2)]
  void set_softness(const LeaningAreas& areas, const LightCarriers& light, double least);
  /// Has no more of penetrations come out than the energy of their pairs pays for; after set_softness().
  void limit_recovery(RecoveryEnergy& recovery);
  /// Adds the points with light carriers to the rows of these.
  void add_rows(LightCarriers& light);
  /// What the point of such a row answers to a velocity of its light carriers.
  LightAnswer answer(std::uint32_t light_point, const Eigen::Vector3d& velocity) const;
  /// To be called once all is added, softness is set and recovery limited: passes may begin.
  void begin_passes();
  /// Pushes the carriers by the forces of the last pass, which the next one looks at: without momentum.
  void push_forces();
  /// Finds the next forces, and pushes the carriers by what the pass after looks at: by the momentum beyond.
  ConstraintPass pass(double momentum, const LightCarriers& light);
  /// Gives the points their forces, slip and losses, and remembers them.
  ContactLoss finish();

  /// The points in the order of add(), with force, friction, slip and what is lost.
  std::span<const ContactPoint> points() const { return points_; }
  /// Has each two faces, and all nodes of a pair, press with no more than in load steps before, once all
  /// points are added: a part of them may have borne it.
  void spread_pressed();
  /// The points in the order of add() with the forces that the passes begin with.
  std::vector<ContactPoint> begun_points() const;
  /// Hands over the points, for others in exchange.
  void swap_points(std::vector<ContactPoint>& points) { points_.swap(points); }
  ContactHistory& memory() { return history_; }
  /// Goes on where contact of another explicit procedure ended, whose memory() it has.
  void go_on() { goes_on_ = true; }
  /// Begins with contact points of load steps before the first step: their forces are those to begin with,
  /// and gaps of what they have pressed count from where they are.
  void begin_pressed(std::span<const ContactPoint> points);

 private:
  using Terms = PointCarriers::Terms;
  using Weights = PointCarriers::Weights;
  /// A contact point. Fourth numbers are 0.
  struct Row {
    NodeVector force = NodeVector::Zero();  // on the first side [force]
    NodeVector ahead = NodeVector::Zero();  // that the next pass looks at [force]
    double start = 0.0;     // gap at the end of the step without forces, less what it may be [length]
    double recovery = 0.0;  // of its penetration that is to come out [length]
    double zero_gap = 0.0;  // at which it just touches [length]
    double softness = 0.0;  // gap per force of this point when all have its pressure, at most [length/force]
    std::uint32_t point = 0;             // in points_
    OptionalIndex<std::uint32_t> grip;   // of a point with friction
    OptionalIndex<std::uint32_t> light;  // its row among those with light carriers
    bool pulls = false;                  // it has touched and may not part
  };
  /// Contact points between the same entities, which have the same carriers.
  struct Group {
    NodeVector normal = NodeVector::Zero();  // [1]
    std::uint32_t first_row = 0, n_rows = 0;
    Terms terms;
  };
  /// Friction of a contact point.
  struct Grip {
    const PairRule* rule = nullptr;
    double limit_per_force = 0.0;                    // of the tangential force; < 0: the rule says [1]
    Eigen::Vector3d held = Eigen::Vector3d::Zero();  // slip of earlier steps that friction holds [length]
    Eigen::Vector3d slip = Eigen::Vector3d::Zero();  // of the step without forces, in the plane [length]
    double softness = 0.0;                           // slip per force, as of the normal [length/force]
  };

  /// Groups that are worked on as one piece, alike for any number of threads.
  static constexpr std::size_t groups_per_chunk = 64;

  /// Calls visit(group, row) for each point of some groups, in their order.
  template <class Visit>
  static void visit_rows(std::span<const Group> groups, const Visit& visit) {
    for (const Group& group : groups) {
      for (std::uint32_t row = group.first_row; row < group.first_row + group.n_rows; ++row)
        visit(group, row);
    }
  }
  template <class Visit>
  void visit_rows(const Visit& visit) const {
    visit_rows(groups_, visit);
  }
  int threads() const { return threads_for(10 * rows_.size()); }
  template <class Sums, class Visit>
  Sums sum_rows(int n_threads, const Visit& visit) const;
  template <class FindForce>
  ConstraintPass push_rows(const FindForce& find_force);
  bool is_of_last_group(const ContactPoint& contact_point) const;
  void add_friction(const ContactPoint& contact_point, const PairRule& rule, Row& row);
  void spread_over_faces();
  std::optional<ContactHistory::Entry> recall(const ContactPoint& contact_point);
  static void begin_where_it_is(const ContactPoint& contact_point, double thickness,
                                std::optional<ContactHistory::Entry>& known);
  void take_over(const ContactPoint& contact_point, const ContactHistory::Entry& known, double allowed,
                 Row& row);
  double area_of(const Row& row) const { return points_[row.point].area; }
  static PointCarriers::Direction direction(const Group& group, const Row& row) {
    return {group.normal, row.grip.has_value()};
  }
  double slip_softness(const Group& group, std::uint32_t row, const LeaningAreas& areas) const;
  double softness(const Group& group, std::uint32_t row, const LeaningAreas& areas,
                  const LightCarriers& light, double least) const;
  void drop_held();
  double slip_limit(const Row& row, const NodeVector& changed, double normal_force) const;
  double pressing(const NodeVector& normal, const Row& row, const NodeVector& changed) const;
  NodeVector next_force(const NodeVector& normal, const Row& row, const NodeVector& changed) const;
  Eigen::Vector3d trial_traction(const Eigen::Vector3d& normal, const Row& row,
                                 const NodeVector& changed) const;
  double lost_before(const Eigen::Vector3d& force, const ContactPoint& point, const Eigen::Vector3d& before,
                     const Eigen::Vector3d& changed) const;
  void finish_friction(const Row& row, double force, const NodeVector& change, const Eigen::Vector3d& before,
                       ContactHistory::Entry& entry, ContactLoss& loss);
  std::optional<ContactHistory::Entry> finish(const Row& row, double force, const NodeVector& change,
                                              ContactLoss& loss);

  PointCarriers carriers_;
  const ContactKinematics* kinematics_ = nullptr;
  double dt_ = 0.0, dt_before_ = 0.0;
  std::vector<ContactPoint> points_;
  std::vector<Group> groups_;
  std::vector<Row> rows_;
  std::vector<Weights> weights_;                                      // [n_rows]
  PushLists pushes_;                                                  // of several threads
  std::vector<NodeVector> pushing_;                                   // [n_rows] by which rows push then
  std::vector<std::pair<const Group*, std::uint32_t>> light_points_;  // with rows, of light carriers
  std::vector<Grip> grips_;
  ContactHistory history_;
  bool begins_pressed_ = false;                   // the history is that of load steps
  bool goes_on_ = false;                          // it is that of another explicit procedure
  std::map<PairIndex, double> pressed_by_nodes_;  // what they pressed [force]
};

}  // namespace contactsim
