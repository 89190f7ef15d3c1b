// SPDX-License-Identifier: BSD-3-Clause
#include "contact/mesh/mean_edge.hpp"

#include <array>

namespace contactsim {

namespace {

/// AUTO over the mean edge.
constexpr double automatic_edges = 2.0;

struct EdgeSum {
  double length = 0.0;
  std::size_t n = 0;
};

void add_edges(const ContactKinematics& start, SurfaceIndex surface, EdgeSum& sum) {
  const ContactMesh& contact_mesh = start.contact_mesh();
  for (const FaceIndex i : contact_mesh.faces_of(surface)) {
    const ContactFace& face = contact_mesh.faces[i];
    const std::size_t n_corners = face.is_triangle() ? 3 : 4;
    for (std::size_t k = 0; k < n_corners; ++k, ++sum.n)
      sum.length += (start.x(face.corners[(k + 1) % n_corners]) - start.x(face.corners[k])).norm();
  }
}

/// Rods count as their edges, particles as their diameters.
void add_lines(const ContactKinematics& start, SurfaceIndex surface, EdgeSum& sum) {
  for (const ContactEdge& edge : start.contact_mesh().edges) {
    if (edge.surface != surface || edge.is_sharp()) continue;
    sum.length +=
        edge.is_particle() ? 2.0 * edge.radius : (start.x(edge.nodes[1]) - start.x(edge.nodes[0])).norm();
    ++sum.n;
  }
}

}  // namespace

double mean_edge(const ContactKinematics& start, const SurfacePair& pair) {
  EdgeSum sum;
  for (const SurfaceIndex surface : std::array{pair.first, pair.second}) {
    if (pair.side_b != surface || pair.first == pair.second) add_edges(start, surface, sum);
  }
  if (sum.n == 0 && pair.side_b) add_edges(start, *pair.side_b, sum);
  if (sum.n == 0) {
    for (const SurfaceIndex surface : std::array{pair.first, pair.second}) add_lines(start, surface, sum);
  }
  return sum.n > 0 ? sum.length / static_cast<double>(sum.n) : 0.0;
}

double find_search_distance(const ContactKinematics& start, const SurfacePair& pair) {
  return pair.search_distance->given.value_or(automatic_edges * mean_edge(start, pair));
}

}  // namespace contactsim
