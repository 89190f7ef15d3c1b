// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "contact/enforcement/contact_force.hpp"
#include "core/dynamics/model.hpp"
#include "support/contact_deck.hpp"

namespace contactsim::test {

/// General contact as the defaults of interactions, with more lines in them, under the lines of surfaces.
std::string general_contact(const std::string& more = "",
                            const std::string& surfaces = "skin all blocks = on\n");

/// Bodies of a mesh with a contact definition, moved by a test. Their material has bulk modulus 1, shear
/// modulus 0.5 and density 1; shells are as thick as the mesh's first attribute says, lines have it as area
/// and particles as radius. For contact the elements' stable step is 1.
class ContactBodies {
 public:
  /// Throws std::logic_error when the deck has errors.
  ///   function_lines  outside procedures, of functions that friction models name
  ///   ranks           which detect contact together
  ContactBodies(const MeshBuilder& builder, const std::string& contact_lines,
                const std::string& function_lines = "", std::vector<TimeSteppingBlock> periods = {},
                Ranks& ranks = one_rank())
      : ContactBodies(builder, with_contact(contact_lines), function_lines, std::move(periods), ranks) {}
  ContactBodies(const MeshBuilder& builder, const Region& region, const std::string& function_lines = "",
                std::vector<TimeSteppingBlock> periods = {}, Ranks& ranks = one_rank());
  ContactBodies(const ContactBodies&) = delete;
  ContactBodies& operator=(const ContactBodies&) = delete;

  Mesh mesh;
  Region region;
  std::vector<FunctionDefinition> functions;
  std::vector<TimeSteppingBlock> time_stepping_blocks;
  Modelled definition;
  Model model;
  Eigen::Matrix3Xd x, v, forces;  ///< forces: those asked for last
  Eigen::Matrix3Xd turning;       ///< angular velocity of the nodes
  Eigen::Matrix3Xd moments;       ///< that go with the forces; 3 x 0 when no node turns
  double time = 0.0, dt = 0.0;
  ContactForce contact;

  Motion motion() const { return {time, dt, x, v, 1.0, moments.cols() > 0 ? &turning : nullptr}; }
  /// Asks for the forces, and the moments, where the nodes are.
  ForceReport ask();
  /// Moves the nodes by their velocities, then asks.
  ForceReport step(double size);

  /// Shifts the nodes of a block, or sets their velocity; by the block's position in the mesh.
  void shift(std::size_t block, const Eigen::Vector3d& way);
  void set_velocity(std::size_t block, const Eigen::Vector3d& velocity);
  /// The sum of the forces on a block's nodes.
  Eigen::Vector3d force_on(std::size_t block) const;
  /// The sums over all nodes of the forces asked for last, of their moments about the origin, of their sizes.
  Eigen::Vector3d net_force() const { return forces.rowwise().sum(); }
  Eigen::Vector3d net_moment() const;
  double force_size() const { return forces.colwise().norm().sum(); }

 private:
  static Region with_contact(const std::string& lines);
  static Model make_model_of(const Mesh& mesh);
};

/// What contact's own parts are tested with, without elements: the mass behind a unit of area is 4.
struct ContactParts {
  ContactParts(const MeshBuilder& builder, const std::string& contact_lines);
  ContactParts(const ContactParts&) = delete;
  ContactParts& operator=(const ContactParts&) = delete;

  Mesh mesh;
  ContactDefinition definition;
  Modelled model;
  ContactMesh contact_mesh;
  PairRules rules;
  ContactKinematics kinematics;
  Eigen::Matrix3Xd x, v;
  ConstrainedPairs constrained;

  Motion motion(double dt = 0.0) const { return {0.0, dt, x, v, 1.0}; }
  /// Takes the motion over, bounds of faces too.
  void move() {
    kinematics.move_nodes(motion());
    kinematics.bound_all();
  }
  ContactStepContext context(double dt = 0.0) const { return {kinematics, rules, constrained, dt}; }
  FormulationSetup setup() const { return {contact_mesh, model, rules}; }
  /// The candidates of a search now.
  ///   depths  of faces and surface nodes that are in something already
  FacePairLists face_partners;
  NodeFaceLists node_faces;
  void search(std::span<const float> face_depths = {}, std::span<const float> node_depths = {});
  /// The same by a search that may have found some before.
  void find_candidates(ContactSearch& search, double dt = 0.0, std::span<const float> face_depths = {},
                       std::span<const float> node_depths = {});
};

}  // namespace contactsim::test
