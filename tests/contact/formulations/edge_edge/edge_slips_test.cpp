// SPDX-License-Identifier: BSD-3-Clause
#include "contact/formulations/edge_edge/edge_slips.hpp"

#include "core/base/state_archive.hpp"
#include "support/catch.hpp"

using namespace contactsim;
using Eigen::Vector3d;

namespace {

EdgeSlips some_slips() {
  EdgeSlips slips;
  slips.add({{0}, {4}, 0}, Vector3d(1, 0, 0));
  slips.add({{0}, {4}, 1}, Vector3d::Zero());
  slips.add({{1}, {3}, 1}, Vector3d(0, 2, 0));
  slips.add({{2}, {4}, 0}, Vector3d(0, 0, 3));
  return slips;
}

}  // namespace

TEST_CASE("slip of edges is known by pair and part; none is held elsewhere", "[contact][edges]") {
  const EdgeSlips slips = some_slips();
  CHECK(slips.find({{0}, {4}, 0}) == Vector3d(1, 0, 0));
  CHECK(slips.find({{0}, {4}, 1}) == Vector3d::Zero());
  CHECK(slips.find({{1}, {3}, 0}) == Vector3d::Zero());
  CHECK(slips.find({{1}, {3}, 1}) == Vector3d(0, 2, 0));
  CHECK(slips.find({{2}, {5}, 0}) == Vector3d::Zero());
  CHECK(EdgeSlips().find({{0}, {1}, 0}) == Vector3d::Zero());
}

TEST_CASE("slip goes over to the new numbers of edges, but of those that have changed their order",
          "[contact][edges]") {
  EdgeSlips slips = some_slips();
  ContactRemap remap;
  // Edge 4 is now before 2 but behind 0; 3 is gone.
  for (const std::uint32_t after : {1u, 0u, 3u}) remap.edges.push_back(EdgeIndex{after});
  remap.edges.push_back(std::nullopt);
  remap.edges.push_back(EdgeIndex{2});
  remap.n_edges_after = 4;
  slips.remap(remap);
  CHECK(slips.find({{1}, {2}, 0}) == Vector3d(1, 0, 0));
  CHECK(slips.find({{2}, {3}, 0}) == Vector3d::Zero());
  CHECK(slips.find({{3}, {2}, 0}) == Vector3d::Zero());
  CHECK(slips.find({{0}, {3}, 1}) == Vector3d::Zero());
}

TEST_CASE("slip of edges is restored as it was", "[contact][edges]") {
  EdgeSlips slips = some_slips(), restored;
  StateArchive saves;
  slips.archive(saves);
  const SavedState stored = saves.take();
  StateArchive restores(stored);
  restored.archive(restores);
  CHECK(restored.find({{1}, {3}, 1}) == Vector3d(0, 2, 0));
  CHECK(restored.find({{2}, {4}, 0}) == Vector3d(0, 0, 3));
}
