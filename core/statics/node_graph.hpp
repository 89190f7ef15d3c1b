// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/elements/model_block.hpp"

namespace contactsim {

/// Which nodes stand in one element: the pattern of the stiffness.
class NodeGraph {
 public:
  /// Of the elements that are not rigid.
  ///   n_nodes   of the mesh
  ///   n_bodies  whose pairs of nodes, each other's neighbours, follow those of the mesh
  ///   alive     [n_elements] 0 of elements that join nothing; empty: all do
  NodeGraph(std::uint32_t n_nodes, const Mesh& mesh, std::span<const ModelBlock> blocks,
            std::uint32_t n_bodies = 0, std::span<const std::uint8_t> alive = {});

  std::uint32_t n_nodes() const { return static_cast<std::uint32_t>(first_.size() - 1); }
  /// The nodes that share an element with one, itself included, ascending; empty without elements.
  std::span<const std::uint32_t> neighbours(std::uint32_t node) const {
    return std::span(neighbours_).subspan(first_[node], first_[node + 1] - first_[node]);
  }

 private:
  std::vector<std::size_t> first_;         // [n_nodes + 1] in neighbours_
  std::vector<std::uint32_t> neighbours_;  // node by node
};

/// How far apart nodes of one colour are at least.
enum class ColourDistance : std::uint8_t {
  one_element,  ///< none is in an element of another
  two_elements  ///< nor has a neighbour that another has
};

/// Groups of nodes that can be moved at once and whose effects can be distinguished.
struct NodeColours {
  std::vector<std::uint32_t> colour;  ///< [n_nodes]
  std::uint32_t n_colours = 0;        ///< nodes without elements have the colour n_colours
};

/// Colours in the order of the nodes, each with the first colour that is left. Source: Curtis, Powell and
/// Reid, J. Inst. Maths Applics 13 (1974) 117-119.
NodeColours colour_nodes(const NodeGraph& graph, ColourDistance distance);

}  // namespace contactsim
