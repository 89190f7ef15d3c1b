// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "core/mesh/topology.hpp"

/// The sides of every element shape, for the shape table and for loops that must know them when they are
/// compiled. Source: Exodus II side numbering (Sandia report SAND92-2137, chapter 4).
namespace contactsim::side_tables {

constexpr std::uint8_t at(int node) { return static_cast<std::uint8_t>(node - 1); }

// Nodes from 1, as the manual prints them.
constexpr Side quad_face(int a, int b, int c, int d) {
  return {SideKind::face, 4, {at(a), at(b), at(c), at(d)}};
}
constexpr Side tri_face(int a, int b, int c) { return {SideKind::face, 3, {at(a), at(b), at(c), at(c)}}; }
constexpr Side edge(int a, int b) { return {SideKind::edge, 2, {at(a), at(b), at(b), at(b)}}; }
constexpr Side node(int a) { return {SideKind::node, 1, {at(a), at(a), at(a), at(a)}}; }

inline constexpr std::array hex_sides{quad_face(1, 2, 6, 5), quad_face(2, 3, 7, 6), quad_face(3, 4, 8, 7),
                                      quad_face(1, 5, 8, 4), quad_face(1, 4, 3, 2), quad_face(5, 6, 7, 8)};
inline constexpr std::array tet_sides{tri_face(1, 2, 4), tri_face(2, 3, 4), tri_face(1, 4, 3),
                                      tri_face(1, 3, 2)};

/// The facets of a face of six nodes: corners a, b, c and midside nodes ab, bc, ca.
constexpr SplitFace split_face(int a, int b, int c, int ab, int bc, int ca) {
  return {{tri_face(a, ab, ca).corners, tri_face(ab, b, bc).corners, tri_face(ca, bc, c).corners,
           tri_face(ab, bc, ca).corners}};
}
inline constexpr std::array tet10_faces{split_face(1, 2, 4, 5, 9, 8), split_face(2, 3, 4, 6, 10, 9),
                                        split_face(1, 4, 3, 8, 10, 7), split_face(1, 3, 2, 7, 6, 5)};

inline constexpr std::array wedge_sides{quad_face(1, 2, 5, 4), quad_face(2, 3, 6, 5), quad_face(1, 4, 6, 3),
                                        tri_face(1, 3, 2), tri_face(4, 5, 6)};
inline constexpr std::array pyramid_sides{tri_face(1, 2, 5), tri_face(2, 3, 5), tri_face(3, 4, 5),
                                          tri_face(1, 5, 4), quad_face(1, 4, 3, 2)};
inline constexpr std::array shell_quad_sides{
    quad_face(1, 2, 3, 4), quad_face(1, 4, 3, 2), edge(1, 2), edge(2, 3), edge(3, 4), edge(4, 1)};
inline constexpr std::array shell_tri_sides{tri_face(1, 2, 3), tri_face(1, 3, 2), edge(1, 2), edge(2, 3),
                                            edge(3, 1)};
inline constexpr std::array quad_sides{edge(1, 2), edge(2, 3), edge(3, 4), edge(4, 1)};
inline constexpr std::array bar_sides{node(1), node(2)};
inline constexpr std::array beam_sides{edge(1, 2), edge(2, 1)};
inline constexpr std::array sphere_sides{node(1)};

}  // namespace contactsim::side_tables
