// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "contact/enforcement/constraint_losses.hpp"
#include "contact/enforcement/constraint_pass.hpp"
#include "contact/enforcement/constraint_system.hpp"
#include "contact/enforcement/contact_history.hpp"
#include "contact/enforcement/point_carriers.hpp"
#include "contact/enforcement/pressing_rows.hpp"
#include "contact/enforcement/push_lists.hpp"
#include "contact/enforcement/recovery_energy.hpp"
#include "contact/formulations/contact_step_context.hpp"
#include "contact/geometry/contact_point.hpp"

namespace contactsim {

/// The contact points of a step as constraints: none penetrates at its end. Forces push only, but where what
/// has touched may not part; friction returns to the Coulomb cone.
class ContactConstraints {
 public:
  explicit ContactConstraints(NodeMobility& mobility) : carriers_(mobility), pressing_(mobility) {}

  /// Begins a step.
  ///   dt_before, dt  of the step that ended, of the coming one [time]
  void begin(const ContactKinematics& kinematics, double dt_before, double dt);
  /// Adds a contact point, or a law's force that acts besides.
  ///   rule       of its pair, which must outlive the step
  ///   thickness  of the thinner side [length]
  void add(const ContactPoint& contact_point, const PairRule& rule, double thickness);

  /// To be called once all points are added, before anything of what follows.
  void list_pushes();
  /// Adds the areas of the points to those of their carriers.
  void add_areas(LeaningAreas& areas);
  /// Adds the points to what leans on their carriers.
  void add_loads(const LeaningAreas& areas, std::vector<CarrierLoad>& loads) const;
  /// Softness of each point, by all areas but those of light carriers. Points between sides that are held or
  /// driven, where nothing can be done, are no constraints any more.
  ///   least  softness by area of points between light carriers [length/(force length^2)]
  void set_softness(const LeaningAreas& areas, const LightCarriers& light, double least);
  /// Has no more of penetrations come out than the energy of their pairs pays for; after set_softness().
  void limit_recovery(RecoveryEnergy& recovery);
  /// To be called before the first push_forces() or pass().
  void begin_passes() { pressing_.begin_passes(system_); }
  /// Adds the points with light carriers to the rows of these.
  void add_rows(LightCarriers& light);
  /// What the point of such a row answers to a velocity of its light carriers.
  LightAnswer answer(std::uint32_t light_point, const Eigen::Vector3d& velocity) const;
  /// Pushes the carriers by the forces of the last pass, from which the next one starts: without momentum.
  void push_forces();
  /// Finds the next forces, and pushes the carriers by those that the pass after starts from:
  /// with the momentum beyond.
  ConstraintPass pass(double momentum, const LightCarriers& light);
  /// Gives the points their forces, slip and losses, and remembers them.
  ContactLoss finish();

  /// The points in the order of add(), with force, friction, slip and what is lost.
  std::span<const ContactPoint> points() const { return system_.points; }
  /// Has each two faces, and all nodes of a pair, press with no more than in load steps before, once all
  /// points are added: a part of them may have borne it.
  void spread_pressed();
  /// The points in the order of add() with the forces that the passes begin with.
  std::vector<ContactPoint> begun_points() const;
  /// Hands over the points, for others in exchange.
  void swap_points(std::vector<ContactPoint>& points) { system_.points.swap(points); }
  ContactHistory& memory() { return history_; }
  /// Goes on where contact of another explicit procedure ended, whose memory() it has.
  void go_on() { goes_on_ = true; }
  /// Begins with contact points of load steps before the first step: their forces are those to begin with,
  /// and gaps of what they have pressed count from where they are.
  void begin_pressed(std::span<const ContactPoint> points);

 private:
  using Terms = PointCarriers::Terms;
  using Weights = PointCarriers::Weights;
  using Row = ConstraintRow;
  using Group = ConstraintGroup;
  /// What it takes to bring out a row, and to part all that overlaps at its point [energy].
  struct Need {
    PairIndex pair;
    double recovery = 0.0, parting = 0.0;
  };

  bool has_others() const { return pressing_.n_groups() < system_.groups.size(); }
  template <class FindForce>
  ConstraintPass push_rows(const FindForce& find_force);
  void add_friction(const ContactPoint& contact_point, const PairRule& rule, Row& row);
  void spread_over_faces();
  std::optional<ContactHistory::Entry> recall(const ContactHistory::PointId& id);
  static void begin_where_it_is(const ContactPoint& contact_point, double thickness,
                                std::optional<ContactHistory::Entry>& known);
  void set_start(const ContactPoint& contact_point, const PairRule& rule, double thickness, Row& row);
  void take_over(const ContactPoint& contact_point, const ContactHistory::Entry& known, double allowed,
                 Row& row);
  static PointCarriers::Direction direction(const Group& group, const Row& row) {
    return {group.normal, row.friction.has_value()};
  }
  double slip_softness(const Group& group, std::uint32_t row, const LeaningAreas& areas) const;
  double softness(const Group& group, std::uint32_t row, const LeaningAreas& areas,
                  const LightCarriers& light, double least) const;

  PointCarriers carriers_;
  const ContactKinematics* kinematics_ = nullptr;
  double dt_ = 0.0, dt_before_ = 0.0;
  ConstraintSystem system_;
  PressingRows pressing_;                                             // rows of the groups that press
  PushLists<RowPush> pushes_;                                         // of the others, of several threads
  std::vector<NodeVector> pushing_;                                   // [n_rows] by which they push then
  std::vector<double> row_areas_;                                     // [n_rows] scratch [length^2]
  std::vector<Need> needs_;                                           // [n_rows] scratch
  std::vector<std::pair<const Group*, std::uint32_t>> light_points_;  // with rows, of light carriers
  ContactHistory history_;
  bool begins_pressed_ = false;                   // the history is that of load steps
  bool goes_on_ = false;                          // it is that of another explicit procedure
  std::map<PairIndex, double> pressed_by_nodes_;  // what they pressed [force]
};

}  // namespace contactsim
