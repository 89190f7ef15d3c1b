// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/base/indices.hpp"
#include "core/mesh/topology.hpp"

namespace contactsim {

/// Elements of one shape that a file names together.
struct DraftGroup {
  std::string name;     ///< "" where the file has none
  std::int64_t id = 0;  ///< 0 where the file has none
  int dimension = 3;    ///< 0 points, 1 lines, 2 surfaces, 3 solids
  Shape shape = Shape::unknown;
  std::vector<std::int64_t> elements;  ///< ids
  std::vector<NodeIndex> nodes;        ///< row by row, in the order of Exodus
};

/// A face of an element by its corners; a triangle repeats its last.
using DraftFace = std::array<NodeIndex, 4>;

/// Faces, or nodes, that a file names.
struct DraftSet {
  std::string name;
  std::int64_t id = 0;           ///< 0 where the file has none
  std::vector<DraftFace> faces;  ///< of a side set
  std::vector<NodeIndex> nodes;  ///< of a node set
};

/// What a mesh generator wrote, before it is known what its groups are to a deck.
struct DraftMesh {
  std::string path;
  std::vector<std::int64_t> node_ids;
  std::vector<Eigen::Vector3d> coordinates;  ///< [length]
  std::vector<DraftGroup> groups;
  std::vector<DraftSet> side_sets, node_sets;
  std::vector<std::string> passed_over;  ///< what is named in the file and becomes nothing, and why
};

}  // namespace contactsim
