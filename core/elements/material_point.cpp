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
    PointStep step{before, {}, {}};
    step.moduli = held.update(motion.strain, step.stress, material);
    store(step.stress, point);
    step.work = 0.5 * (contract(before, motion.strain.strain) + contract(step.stress, motion.strain.strain));
    return step;
  };
  return std::visit(update, law);
}

}  // namespace contactsim
