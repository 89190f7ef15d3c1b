// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "contact/lofting/loft_points.hpp"
#include "contact/mesh/pair_lists.hpp"
#include "contact/smoothing/smooth_faces.hpp"
#include "core/base/contact_indices.hpp"
#include "core/base/indexed_vector.hpp"
#include "core/mesh/mesh.hpp"

namespace contactsim {

struct ContactModel;
struct Model;

/// What stands behind a piece of a contact surface.
struct PenaltyProperties {
  double thickness = 0.0;  ///< of the element: its volume over the face's area [length]
  double stiffness =
      0.0;  ///< of the penalty, per area: see contact/formulations/penalty.hpp [force/length^3]
  double mass_per_area = 0.0;  ///< that moves with the face [mass/length^2]
  bool is_rigid = false;       ///< rigid, held or driven: it gives way by no spring of its own
  double start_depth = 0.0;    ///< by which it penetrated something at the start [length]
};

/// How much stiffer than the element behind it a penalty is. Nodes of elements that set the step cannot bear
/// it and get less (limit_stiffness); where others do, contact is nearly rigid.
inline constexpr double penalty_over_element = 10.0;

/// One face of a contact surface, or a facet of one whose midside nodes move it: the facets of a face follow
/// each other and have the same side.
struct ContactFace {
  std::array<ContactNodeIndex, 4> corners{};  ///< outward right-hand order; a triangle repeats its last
  SurfaceIndex surface;
  ElementSide side;
  float sharpness = 0.0f;  ///< see measure_sharpness [degrees]
  PenaltyProperties penalty_properties;

  bool is_triangle() const { return corners[2] == corners[3]; }
};

/// A node of a contact surface that meets faces as a node.
struct SurfaceNode {
  ContactNodeIndex node;  ///< contact node
  SurfaceIndex surface;
  ElementSide side;     ///< a face that has it; side 1 of a line or particle
  float radius = 0.0f;  ///< of the sphere around a line's or particle's node [length]
  double area =
      0.0;  ///< its share of the surface at the start; of a sphere its cross-section; of a node
            ///< without faces 0, then by add_penalty_properties() that of a cube of its mass [length^2]
  PenaltyProperties penalty_properties;
  bool is_free = false;  ///< all its elements are dead: it is a mass of its own that meets faces
};

/// A node that has stayed in contact though all its elements are dead.
struct ErodedNode {
  NodeIndex node;
  SurfaceIndex surface;  ///< that had it
  ElementSide side;      ///< of a dead element: what it stands for in area and backing
};

/// A line between two nodes that meets other lines. A round one is all that is within the radius of a beam's
/// or truss's axis, or of a particle's one node; a sharp one stands between two faces. Where rods of unlike
/// radii meet, each of them has the least of these there, and tapers towards it.
struct ContactEdge {
  std::array<ContactNodeIndex, 2> nodes{};  ///< contact nodes; of a particle the same twice
  SurfaceIndex surface;
  ElementSide side;     ///< side 1 of the element; of a sharp edge that of its first face
  double radius = 0.0;  ///< 0 of sharp edges [length]
  double width = 0.0;   ///< of the strip that touches another edge [length]
  PenaltyProperties penalty_properties;
  std::optional<std::array<FaceIndex, 2>> faces = {};  ///< of sharp edges
  bool is_feature = false;                             ///< a sharp edge that meets other sharp ones
  std::array<double, 2> less{};                        ///< by which the radius is less at each end [length]

  bool is_sharp() const { return faces.has_value(); }
  /// The radius at a point, by its share of the way from the first end to the second [length].
  double radius_at(double share) const { return radius - ((1.0 - share) * less[0] + share * less[1]); }
  bool is_particle() const { return nodes[0] == nodes[1]; }
};

/// The faces and nodes of all contact surfaces, with nodes numbered for contact alone: first nodes of the
/// mesh, ascending as there, then points of lofts, which hang on nodes of the mesh. Const between deaths of
/// elements.
struct ContactMesh {
  IndexedVector<ContactNodeIndex, NodeIndex> mesh_nodes;          ///< of the mesh; of lofts what they hang on
  LoftPoints loft;                                                ///< the last of the contact nodes
  IndexedVector<ContactNodeIndex, ContactNodeIndex> first_alike;  ///< the first one with the same mesh node
  IndexedVector<FaceIndex, ContactFace> faces;  ///< by surface, then as the surface has them, facet by facet
  IndexedVector<SurfaceNodeIndex, SurfaceNode> surface_nodes;  ///< by surface, then by node
  IndexedVector<EdgeIndex, ContactEdge> edges;                 ///< round ones by surface, then sharp ones
  std::vector<FaceIndex> first_face;                           ///< [n_surfaces + 1], see faces_of()
  std::vector<SurfaceNodeIndex> first_node;                    ///< [n_surfaces + 1], see rows_of()
  IndexedVector<ContactNodeIndex, double> mass;                ///< [n_contact_nodes] [mass]
  PairLists<ContactNodeIndex, FaceIndex> faces_of_node;        ///< that have the node as a corner
  SmoothFaces smooth_faces;                                    ///< that stand for round surfaces

  std::size_t n_nodes() const { return mesh_nodes.size(); }
  IndexRange<ContactNodeIndex> nodes() const { return indices(mesh_nodes); }
  /// Position of a node of the mesh that is in contact.
  ContactNodeIndex find_node(NodeIndex node) const;
  std::size_t n_surfaces() const { return first_face.size() - 1; }
  IndexRange<SurfaceIndex> surfaces() const { return {{}, {static_cast<std::uint32_t>(n_surfaces())}}; }
  /// The faces of a surface, and its nodes.
  IndexRange<FaceIndex> faces_of(SurfaceIndex surface) const {
    return {first_face[surface.value], first_face[surface.value + 1]};
  }
  IndexRange<SurfaceNodeIndex> rows_of(SurfaceIndex surface) const {
    return {first_node[surface.value], first_node[surface.value + 1]};
  }
  /// A contact node as a node of a surface.
  std::optional<SurfaceNodeIndex> find_row(ContactNodeIndex node, SurfaceIndex surface) const;
  /// Contact nodes that are nodes of the mesh; those of lofts follow.
  std::size_t n_mesh_points() const { return mesh_nodes.size() - loft.size(); }
  /// Whether a contact node is one of the mesh, and whether a face is of a loft.
  bool is_mesh_point(ContactNodeIndex node) const { return node.value < n_mesh_points(); }
  bool is_lofted(const ContactFace& face) const { return !is_mesh_point(face.corners[0]); }
  /// The memory of its lists, without those of lofts [bytes].
  std::size_t bytes() const;
  /// Whether two faces hang on a common node of the mesh.
  bool share_node(const ContactFace& a, const ContactFace& b) const;
};

/// Candidates of contact.
using FacePairLists = PairLists<FaceIndex, FaceIndex>;
using NodeFaceLists = PairLists<SurfaceNodeIndex, FaceIndex>;
using EdgePairLists = PairLists<EdgeIndex, EdgeIndex>;

/// Thickness of the solid behind a face: its volume over the face's area. Behind the face of a shell, whose
/// own thickness its side sets do not have, the square root of the area [length].
double thickness_behind(const Mesh& mesh, ElementSide side);

/// Numbers the faces and nodes of the surfaces, with the thickness of the elements behind them. Nodes of node
/// sets that no outside face of the mesh has are left out: they lie behind it.
///   eroded_nodes  ascending, on top of the nodes of the surfaces
ContactMesh make_contact_mesh(const ContactModel& contact, const Mesh& mesh,
                              std::span<const ErodedNode> eroded_nodes = {});

/// Adds masses, and stiffness and mass per area behind faces and nodes. Of a loft's point it is the least
/// mass that a force on it may find: that of its node, less because its node turns.
///   model  its blocks hold every element with a contact face
void add_penalty_properties(const Model& model, ContactMesh& contact_mesh);

}  // namespace contactsim
