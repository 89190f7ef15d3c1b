// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/base/optional_index.hpp"
#include "core/mesh/mesh.hpp"

namespace contactsim {

/// Which nodes move with which rigid body.
struct RigidNodes {
  std::vector<OptionalIndex<std::uint32_t>>
      body_of;                      ///< [n_nodes] position of the node's body; empty without bodies
  std::vector<std::size_t> counts;  ///< [n_bodies] of their nodes
  std::vector<std::string> names;   ///< [n_bodies]
  /// Node i is where body i is at the start; no elements. Held apart, so that conditions may point to it
  /// while the model moves.
  std::shared_ptr<const Mesh> references;

  bool is_free(NodeIndex node) const { return body_of.empty() || !body_of[node.value]; }
};

}  // namespace contactsim
