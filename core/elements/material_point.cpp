// SPDX-License-Identifier: BSD-3-Clause
#include "core/elements/material_point.hpp"

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

}  // namespace

PointStep update_point(const MaterialLaw& law, const StepMotion& motion, std::span<Lanes> point) {
  const auto update = [&](const auto& held) {
    using Law = std::decay_t<decltype(held)>;
    const SymmetricLanes before = transformed(tensor_at(point), motion.rotation);
    const std::span<Lanes> material = point.subspan(6);
    for (std::size_t i = 0; i < Law::n_tensors; ++i) {
      const std::span<Lanes> numbers = material.subspan(6 * i, 6);
      store(transformed(tensor_at(numbers), motion.rotation), numbers);
    }
    if constexpr (requires { Law::n_vectors; })
      turn_each(motion.rotation, material.subspan(6 * Law::n_tensors, 3 * Law::n_vectors));
    PointStep step{before, {}, {}};
    step.moduli = held.update(motion.strain, step.stress, material);
    store(step.stress, point);
    step.work = 0.5 * (contract(before, motion.strain.strain) + contract(step.stress, motion.strain.strain));
    return step;
  };
  return std::visit(update, law);
}

}  // namespace contactsim
