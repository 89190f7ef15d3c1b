// SPDX-License-Identifier: BSD-3-Clause
#include "core/elements/element_batches.hpp"
#include "core/elements/elements.hpp"

namespace contactsim {

namespace {

/// Points have none; their density is their mass.
void unit_volumes(const ModelBlock&, const BatchChunk& chunk, const Eigen::Matrix3Xd&,
                  std::span<Lanes> volumes) {
  for (std::size_t i = chunk.first_batch; i < chunk.first_batch + chunk.n_batches; ++i)
    volumes[i].setConstant(1.0);
}

ChunkStep advance_point(const ModelBlock&, const BatchChunk&, const Motion&, ModelBlockState&) {
  return batches::no_step();
}

constexpr ElementFormulation point_mass(std::string_view formulation, bool has_rotations) {
  ElementFormulation element{Shape::sphere,  formulation,  1, 0, 0, &unit_volumes,
                             &advance_point, has_rotations};
  element.step_rule = StepRule::none;
  return element;
}

}  // namespace

const ElementFormulation sphere_point_mass = point_mass("point_mass", false);
const ElementFormulation sphere_point_inertia = point_mass("point_inertia", true);

}  // namespace contactsim
