// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <span>

#include "core/base/indices.hpp"
#include "core/elements/element_vectors.hpp"
#include "core/mesh/topology.hpp"

namespace contactsim {

/// The nodes' columns of an array over the mesh.
ElementVectors gather(std::span<const NodeIndex> nodes, const Eigen::Matrix3Xd& values);

/// The derivatives of a solid's volume by its nodes' coordinates, which are also its volume times the mean
/// gradients of the shape functions. Of every face the mean of both ways to split it into triangles is taken:
/// exact for the bilinear face. Nodes that are no corners of facets get none.
///   x  coordinates [length]
/// Returns [length^2]. Source: Flanagan and Belytschko, Int. J. Numer. Meth. Eng. 17 (1981) 679-706, eq. 17.
ElementVectors volume_gradient(const Topology& topology, const ElementVectors& x);

/// The gradients of a shell's shape functions in its middle, along the surface [3 x n_nodes] [1/length].
ElementVectors surface_gradient(const Topology& topology, const ElementVectors& x);

/// The area of a shell's projection on its middle [length^2].
double surface_area(const Topology& topology, const ElementVectors& x);

/// The unit normal of a shell in its middle [1].
Eigen::Vector3d surface_normal(const Topology& topology, const ElementVectors& x);

/// The volume that has the gradient: of degree three in the coordinates [length^3].
double solid_volume(const ElementVectors& x, const ElementVectors& gradient);

}  // namespace contactsim
