// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "contact/enforcement/contact_force.hpp"
#include "contact/mesh/contact_model.hpp"
#include "core/base/optional_index.hpp"
#include "core/output/output_variables.hpp"

namespace contactsim {

/// Contact of one node, summed over its contact points.
struct NodeContact {
  double status = 0.0;  ///< 1 touches, 0.5 of a block or surface in contact, 0 of none [1]
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();      ///< normal force [force]
  Eigen::Vector3d tangential = Eigen::Vector3d::Zero();  ///< friction [force]
  double area = 0.0;                                     ///< that touches [length^2]
  double gap = 0.0;  ///< of its deepest contact point; of a node that does not touch see find_node_gaps(), if
                     ///< it was asked for [length]
  double tangential_gap = 0.0;  ///< slip held by the tangential spring there [length]
  double interaction = 0.0;     ///< number of its last pair in the log's table, 0 of none [1]
  double surface_area = 0.0;    ///< its share of its surface at the start [length^2]
  double slip_rate = 0.0;       ///< of the last step [length/time]
  Eigen::Vector3d slip_velocity = Eigen::Vector3d::Zero();  ///< the same with its direction [length/time]
  double slip_status = 0.0;  ///< 2 slips, 1 is held along the surface, 0 neither [1]
  NodeFriction friction;     ///< since the start
};

/// Row of the table of nodal contact variables.
struct ContactNodeRow {
  std::string_view name;
  FieldShape shape = FieldShape::scalar;
  void (*fill)(const NodeContact& node, double* values) = nullptr;
  std::string_view help;    ///< one line with the dimension
  bool needs_gaps = false;  ///< of nodes that do not touch
  int list_size = 1;        ///< number of components of a list

  int n_components() const { return shape == FieldShape::list ? list_size : component_count(shape); }
};

/// Source: Sierra/SM 5.22, 8.10 and 9.
std::span<const ContactNodeRow> contact_node_rows();

/// Force, moment, centre and area of contact on a surface, or on the first surface of a pair. Both parts of
/// the force and of the moment, along the normals and along the surface, add up to the whole.
struct ContactTotal {
  Eigen::Vector3d normal_force = Eigen::Vector3d::Zero();     ///< [force]
  Eigen::Vector3d friction_force = Eigen::Vector3d::Zero();   ///< [force]
  Eigen::Vector3d normal_moment = Eigen::Vector3d::Zero();    ///< about the origin [force length]
  Eigen::Vector3d friction_moment = Eigen::Vector3d::Zero();  ///< the same [force length]
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();  ///< places times normal forces, summed [force length]
  double normal_sum = 0.0;                           ///< of the sizes of normal forces [force]
  double area = 0.0;                                 ///< that touches [length^2]
  double penetration = 0.0;                          ///< deepest since the start [length]
  double energy = 0.0;    ///< taken from the bodies since the start, < 0 given to them [energy]
  double friction = 0.0;  ///< lost to friction since the start [energy]

  Eigen::Vector3d force() const { return normal_force + friction_force; }
  Eigen::Vector3d moment() const { return normal_moment + friction_moment; }
  /// Adds a force at a place.
  void add(const Eigen::Vector3d& place, const Eigen::Vector3d& normal, const Eigen::Vector3d& along) {
    normal_force += normal;
    friction_force += along;
    normal_moment += place.cross(normal);
    friction_moment += place.cross(along);
  }
};

/// Row of the table of global contact variables: one of each surface, name_<surface>, of each pair,
/// name_<first>_<second>, and of each side set of the mesh, name_<side set>, that is no surface by its name.
struct ContactTotalRow {
  std::string_view name;
  FieldShape shape = FieldShape::scalar;
  void (*fill)(const ContactTotal& total, double* values) = nullptr;
  std::string_view help;     ///< one line with the dimension
  bool is_of_pairs = false;  ///< known of pairs and so of surfaces, not of other side sets
};
std::span<const ContactTotalRow> contact_total_rows();

/// Names of groups of contact variables, and what others call these. Source: generic output requests and
/// output variables of Abaqus/Explicit general contact, 36.4.1; CDIS, CSTR and PCON of CalculiX.
OutputNames contact_output_names();

/// The contact variables of a run, worked out when someone asks for them, once per step.
class ContactOutput {
 public:
  /// Both must outlive this.
  ContactOutput(ContactForce& force, const ContactModel& contact, const Model& model);

  /// All variables, to be added to those of the run; this must outlive them.
  std::vector<OutputVariable> variables();

  /// To be called after the force has gone over to other surfaces.
  void renew();

 private:
  void begin();
  /// Brings everything to the state. Whoever asks first does the work.
  void evaluate(const State& state);
  /// The same with the gaps of nodes that do not touch, which take a search.
  void evaluate_gaps(const State& state);
  void add_place(const ContactPoint& contact_point);
  void add_tie(const InterfaceConstraint& tie, const CornerForces& forces);
  void add_to_totals(PairIndex pair, bool is_swapped, const ContactTotal& on_first);
  void add_to_nodes(const ContactPoint& contact_point, const ContactPointSide& side, double sign);
  /// The share of each corner of a tie's side in its area.
  static double tie_share(const InterfaceConstraint& tie, bool is_first);
  /// A variable of a row, filled from a total that is brought up to date when someone asks.
  template <class Find>
  OutputVariable make_total(const ContactTotalRow& row, const std::string& name, const Find& find);
  void add_side_sets(std::vector<OutputVariable>& variables);
  const ContactTotal& total_of_side_set(std::size_t index, const State& state);

  ContactForce& force_;
  const ContactModel& contact_;
  const Model& model_;
  std::mutex lock_;
  std::optional<std::int64_t> step_, gaps_step_;               // of what is known, and of gaps
  std::vector<double> rest_status_;                            // [n_nodes] of nodes that touch nothing
  std::vector<OptionalIndex<ContactNodeIndex>> contact_node_;  // [n_nodes] position among the contact nodes
  IndexedVector<ContactNodeIndex, NodeContact> nodes_;         // [n_contact_nodes]
  IndexedVector<SurfaceIndex, ContactTotal> surfaces_;
  IndexedVector<PairIndex, ContactTotal> pairs_;

  /// What is known of a side set of the mesh.
  struct SideSetTotal {
    std::optional<std::int64_t> step;
    std::vector<ElementSide> sides;  // ascending, once someone has asked
    ContactTotal total;
  };
  std::vector<SideSetTotal> side_sets_;  // [n_side_sets]
};

}  // namespace contactsim
