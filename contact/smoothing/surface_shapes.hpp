// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "contact/smoothing/round_shape.hpp"
#include "core/base/contact_indices.hpp"
#include "core/base/indexed_vector.hpp"

namespace contactsim {

/// A round shape that was fitted to nodes of a surface.
struct FittedShape {
  RoundShape shape;
  double radius = 0.0;      ///< mean of the nodes [length]
  double residual = 0.0;    ///< largest difference of a node's radius from it [length]
  std::size_t n_faces = 0;  ///< that lie on it
};

/// The round shapes of one surface.
struct SurfaceShapes {
  std::vector<RoundShape> given;    ///< of the deck: one at most
  std::vector<FittedShape> fitted;  ///< whose nodes lie on them, of AUTO
  std::size_t n_flat = 0;           ///< smooth parts of the surface that are flat, of AUTO
  std::size_t n_unfitted = 0;       ///< and those that are neither flat nor round
  double least_residual = 0.0;      ///< the smallest of these, over the radius [1]

  bool is_empty() const { return given.empty() && fitted.empty(); }
};

/// A smoothing: what the surfaces of a model stand for.
struct SmoothingShapes {
  std::string name;  ///< of the deck; AUTO
  bool is_automatic = false;
  IndexedVector<SurfaceIndex, SurfaceShapes> surfaces;
};

}  // namespace contactsim
