// SPDX-License-Identifier: BSD-3-Clause
#include "core/mesh/mesh_digest.hpp"

#include <array>

#include "core/base/digest.hpp"

namespace contactsim {

std::uint64_t digest_of(const Mesh& mesh) {
  Digest digest;
  const Eigen::Matrix3Xd& x = mesh.coordinates();
  digest.add_values(std::span(x.data(), static_cast<std::size_t>(x.size())));
  for (const ElementBlock& block : mesh.blocks()) {
    const std::array<std::int64_t, 2> about{block.id, static_cast<std::int64_t>(block.shape)};
    digest.add_values(std::span<const std::int64_t>(about));
    digest.add_values(std::span<const NodeIndex>(block.nodes));
  }
  return digest.value();
}

}  // namespace contactsim
