// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "bench_meshes.hpp"
#include "contact/search/box_tree.hpp"

namespace contactsim::bench {

/// Two concentric spheres, one turning in the other: boxes of half a width of 0.2 around the nodes of the
/// inner one, boxes around the faces of the outer one. Their walls are whole floats, so that whatever works
/// in single precision finds the same pairs.
class SearchScene {
 public:
  ///   n_faces  about, of each sphere
  explicit SearchScene(std::int64_t n_faces);

  /// Turns the outer sphere a little and makes its boxes anew.
  void move();
  const std::vector<Box>& nodes() const { return nodes_; }
  const std::vector<Box>& faces() const { return faces_; }

 private:
  SpherePair pair_;
  std::vector<Box> nodes_, faces_;
};

}  // namespace contactsim::bench
