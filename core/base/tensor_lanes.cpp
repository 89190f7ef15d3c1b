// SPDX-License-Identifier: BSD-3-Clause
#include "core/base/tensor_lanes.hpp"

namespace contactsim {

SymmetricLanes transformed(const SymmetricLanes& a, const TensorLanes& f) {
  TensorLanes fa;
  for (std::size_t i = 0; i < 3; ++i) {
    fa[i] = {f[i][0] * a[0] + f[i][1] * a[3] + f[i][2] * a[5],
             f[i][0] * a[3] + f[i][1] * a[1] + f[i][2] * a[4],
             f[i][0] * a[5] + f[i][1] * a[4] + f[i][2] * a[2]};
  }
  const auto component = [&](std::size_t i, std::size_t j) -> Lanes {
    return fa[i][0] * f[j][0] + fa[i][1] * f[j][1] + fa[i][2] * f[j][2];
  };
  return {
      {component(0, 0), component(1, 1), component(2, 2), component(0, 1), component(1, 2), component(2, 0)}};
}

}  // namespace contactsim
