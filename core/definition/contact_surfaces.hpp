// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <variant>
#include <vector>

#include "core/base/names.hpp"

namespace contactsim {

/// CONTACT SURFACE <name> CONTAINS <items>. Items are side sets, blocks, assemblies of either and analytic
/// objects. Source: Sierra/SM 5.22, 8.4.1.
struct ContactSurfaceLine {
  DeckLocation location;
  DeckName name;
  std::vector<DeckName> items;
};

/// CONTACT NODE SET <name> CONTAINS <items>. Items are node sets, side sets, blocks and assemblies of them.
/// Source: Sierra/SM 5.22, 8.4.2.
struct ContactNodeSetLine {
  DeckLocation location;
  DeckName name;
  std::vector<DeckName> items;
};

/// SUBSET <name> WITH NORMAL <x> <y> <z>: the faces that look along the normal become the surface
/// <surface>_<name>.
struct SurfaceSubset {
  DeckName name;
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  ///< not zero; need not be a unit vector [1]
};

/// One id of an ELEMENT line: a lofted element by its Exodus id.
struct ElementReference {
  std::int64_t id = 0;
  DeckLocation location;
};

/// BEGIN CONTACT SURFACE <name> ... END. Source: Sierra/SM 5.22, 8.4.3 and 8.4.4.1.
struct ContactSurfaceBlock {
  DeckName name;
  bool includes_all_blocks = false;
  std::vector<DeckName> blocks, side_sets, assemblies;
  std::vector<ElementReference> elements;
  std::vector<DeckName> removed_blocks, removed_side_sets;
  std::vector<SurfaceSubset> subsets;
};

/// SKIN ALL BLOCKS = ON [EXCLUDE <blocks or assemblies>]. Source: Sierra/SM 5.22, 8.4.5.
struct SkinAllBlocks {
  DeckLocation location;
  std::vector<DeckName> excluded;
};

/// A command that makes contact surfaces. Their order in the deck decides who owns a face.
using SurfaceCommand =
    std::variant<ContactSurfaceLine, ContactNodeSetLine, ContactSurfaceBlock, SkinAllBlocks>;

/// RESTRICT CONTACT TO SUBDOMAIN DEFINED BY RADIUS <r> AND POINT <x> <y> <z>. Source: Sierra/SM 5.22, 8.4.4.
struct ContactSphere {
  double radius = 0.0;                              ///< > 0 [length]
  Eigen::Vector3d point = Eigen::Vector3d::Zero();  ///< [length]
};

/// RESTRICT CONTACT TO BOX DEFINED BY <x> <y> <z> AND <x> <y> <z>: two opposite corners, its edges along the
/// axes. Source: Abaqus, contact in a box.
struct ContactBox {
  Eigen::Vector3d lower = Eigen::Vector3d::Zero();  ///< [length]
  Eigen::Vector3d upper = Eigen::Vector3d::Zero();  ///< not below `lower` anywhere [length]
};

/// The part of space, at the start, to which contact is restricted.
struct ContactSubdomain {
  DeckLocation location;
  std::variant<ContactSphere, ContactBox> shape;
};

/// BEGIN ANALYTIC OBJECT <name>, TYPE = PLANE. Source: Sierra/SM 5.22, analytic objects.
struct AnalyticPlane {
  DeckName name;
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  ///< towards the free side [1]; zero: not given
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();  ///< [length]
  double scale_factor =
      1.0;  ///< of the drawn square, whose side is three times the mesh's largest length [1]
};

}  // namespace contactsim
