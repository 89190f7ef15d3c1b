// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "core/dynamics/model.hpp"
#include "core/mesh/output_field.hpp"

namespace contactsim {

/// The block that results files of rigid bodies have besides those of the mesh: a sphere at the reference
/// point of every body, in the order of the deck. Source: Sierra/SM, results files of rigid bodies.
class RigidPart {
 public:
  static constexpr std::string_view name = "RigidBodyOutputPart";

  ///   model  must outlive the part
  explicit RigidPart(const Model& model) : model_(model) {}

  /// Adds the block to the parts_of() the mesh, but without rigid bodies or when it has such a block already.
  void add_to(MeshParts& parts) const;

  /// The values of a nodal field at the nodes of a mesh with the block; those of other fields as they
  /// are. At the references displacement, velocity, acceleration and coordinates are those of the bodies,
  /// whatever else is 0. Good until the next call.
  ///   values  of the run's own mesh, entity by entity
  std::span<const double> extended(const OutputField& field, std::span<const double> values,
                                   const State& state);

 private:
  bool exists() const;

  const Model& model_;
  std::vector<double> values_;
};

}  // namespace contactsim
