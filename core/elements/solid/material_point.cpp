// SPDX-License-Identifier: BSD-3-Clause
#include "core/elements/solid/material_point.hpp"

#include <algorithm>

namespace contactsim {

namespace {

SymmetricLanes tensor_at(std::span<const Lanes> numbers) {
  SymmetricLanes tensor;
  std::copy_n(numbers.begin(), 6, tensor.components.begin());
  return tensor;
}

void store(const SymmetricLanes& tensor, std::span<Lanes> numbers) {
  std::copy_n(tensor.components.begin(), 6, numbers.begin());
}

/// Turns vectors that stand one after another.
void turn_each(const TensorLanes& rotation, std::span<Lanes> vectors) {
  for (std::size_t i = 0; i < vectors.size(); i += 3) {
    const std::array<Lanes, 3> v{vectors[i], vectors[i + 1], vectors[i + 2]};
    for (std::size_t k = 0; k < 3; ++k) vectors[i + k] = dot(rotation[k], v);
  }
}

/// The mean of a strain of the middle of a step and of what the step's rotation makes of it.
SymmetricLanes turned_half(const SymmetricLanes& strain, const TensorLanes& rotation) {
  SymmetricLanes mean = transformed(strain, rotation);
  for (std::size_t i = 0; i < 6; ++i) mean[i] = 0.5 * (mean[i] + strain[i]);
  return mean;
}

/// Brings a stress to the end of the step: what the law adds is added half before the rotation, half after.
LaneModuli advance_stress(const MaterialLaw& law, const StepMotion& motion, std::span<Lanes> material,
                          SymmetricLanes& stress) {
  if (law.kind().adds_stress) {  // the same, with one tensor less to turn
    SymmetricLanes growth = SymmetricLanes::zero();
    const LaneModuli moduli = law.update(motion.strain, growth, material);
    for (std::size_t i = 0; i < 6; ++i) stress[i] += growth[i] *= 0.5;
    stress = transformed(stress, motion.rotation);
    for (std::size_t i = 0; i < 6; ++i) stress[i] += growth[i];
    return moduli;
  }
  StrainStep step = motion.strain;
  step.strain = turned_half(motion.strain.strain, motion.rotation);
  stress = transformed(stress, motion.rotation);
  return law.update(step, stress, material);
}

}  // namespace

PointStep update_point(const MaterialLaw& law, const StepMotion& motion, std::span<Lanes> point) {
  const LawKind& kind = law.kind();
  const SymmetricLanes before = tensor_at(point);
  const std::span<Lanes> material = point.subspan(6);
  for (std::size_t i = 0; i < kind.n_tensors; ++i) {
    const std::span<Lanes> numbers = material.subspan(6 * i, 6);
    store(transformed(tensor_at(numbers), motion.rotation), numbers);
  }
  turn_each(motion.rotation, material.subspan(6 * kind.n_tensors, 3 * kind.n_vectors));
  PointStep step{before, {}, {}};
  step.moduli = advance_stress(law, motion, material, step.stress);
  store(step.stress, point);
  SymmetricLanes both_ends = before;
  for (std::size_t i = 0; i < 6; ++i) both_ends[i] += step.stress[i];
  step.work = 0.5 * contract(both_ends, motion.strain.strain);
  return step;
}

}  // namespace contactsim
