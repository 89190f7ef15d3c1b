// SPDX-License-Identifier: BSD-3-Clause
#include "core/mesh/topology.hpp"

#include <Eigen/Geometry>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "support/catch.hpp"
#include "support/mesh_builder.hpp"

using namespace contactsim;

namespace {

// The sides of a shape as the manual prints them: "1 2 6 5 | 2 3 7 6".
std::string print_sides(Shape shape) {
  std::string text;
  for (const Side& side : topology(shape).sides) {
    if (!text.empty()) text += "| ";
    for (int i = 0; i < side.n_corners; ++i) {
      text += std::to_string(side.corners[static_cast<std::size_t>(i)] + 1) + " ";
    }
  }
  return text;
}

std::vector<Shape> all_shapes() {
  std::vector<Shape> shapes;
  for (int i = 0; i <= static_cast<int>(Shape::unknown); ++i) shapes.push_back(static_cast<Shape>(i));
  return shapes;
}

}  // namespace

TEST_CASE("sides are numbered as the Exodus manual prints them", "[core][topology]") {
  const std::string hex = "1 2 6 5 | 2 3 7 6 | 3 4 8 7 | 1 5 8 4 | 1 4 3 2 | 5 6 7 8 ";
  const std::string shell = "1 2 3 4 | 1 4 3 2 | 1 2 | 2 3 | 3 4 | 4 1 ";
  CHECK(print_sides(Shape::hex8) == hex);
  CHECK(print_sides(Shape::hex20) == hex);
  CHECK(print_sides(Shape::hex27) == hex);
  CHECK(print_sides(Shape::tet10) == "1 2 4 | 2 3 4 | 1 4 3 | 1 3 2 ");
  CHECK(print_sides(Shape::wedge6) == "1 2 5 4 | 2 3 6 5 | 1 4 6 3 | 1 3 2 | 4 5 6 ");
  CHECK(print_sides(Shape::pyramid13) == "1 2 5 | 2 3 5 | 3 4 5 | 1 5 4 | 1 4 3 2 ");
  CHECK(print_sides(Shape::shell4) == shell);
  CHECK(print_sides(Shape::shell9) == shell);
  CHECK(print_sides(Shape::shell6) == "1 2 3 | 1 3 2 | 1 2 | 2 3 | 3 1 ");
  CHECK(print_sides(Shape::quad8) == "1 2 | 2 3 | 3 4 | 4 1 ");
  CHECK(print_sides(Shape::bar2) == "1 | 2 ");
  CHECK(print_sides(Shape::beam3) == "1 2 | 2 1 ");
  CHECK(print_sides(Shape::sphere) == "1 ");
}

TEST_CASE("every shape's sides stay within its corners and repeat the last one", "[core][topology]") {
  for (Shape shape : all_shapes()) {
    const Topology& facts = topology(shape);
    INFO(facts.name);
    CHECK(facts.shape == shape);
    CHECK(facts.n_corners <= facts.n_nodes);
    CHECK(facts.sides.empty() == (facts.family == Family::none));
    for (const Side& side : facts.sides) {
      const std::set<int> allowed = side.kind == SideKind::face   ? std::set{3, 4}
                                    : side.kind == SideKind::edge ? std::set{2}
                                                                  : std::set{1};
      CHECK(allowed.count(side.n_corners) == 1);
      for (std::uint8_t corner : side.corners) CHECK(corner < facts.n_corners);
      for (std::size_t i = side.n_corners; i < 4; ++i)
        CHECK(side.corners[i] == side.corners[side.n_corners - 1u]);
    }
  }
}

TEST_CASE("the faces of every solid close: each edge is walked once each way", "[core][topology]") {
  for (Shape shape : all_shapes()) {
    if (topology(shape).family != Family::solid) continue;
    INFO(topology(shape).name);
    std::map<std::pair<int, int>, int> walked;
    for (const Side& side : topology(shape).sides) {
      for (std::size_t i = 0; i < side.n_corners; ++i) {
        ++walked[{side.corners[i], side.corners[(i + 1) % side.n_corners]}];
      }
    }
    for (const auto& [ends, times] : walked) {
      CHECK(times == 1);
      CHECK(walked.count({ends.second, ends.first}) == 1);
    }
  }
}

TEST_CASE("the faces of every solid look outward", "[core][topology]") {
  test::MeshBuilder builder;
  builder.add_hexes({.id = 1, .cells = {2, 1, 1}, .share_nodes = false})
      .add_tets({.id = 2, .cells = {2, 1, 1}, .share_nodes = false}, 5)
      .add_tets({.id = 3, .share_nodes = false}, 6)
      .add_wedges({.id = 4, .share_nodes = false})
      .add_pyramids({.id = 5, .share_nodes = false});
  // No face of a cell looks at its own element's centroid: interior faces would if they were reversed.
  const Mesh bare = builder.build();
  int n_faces = 0;
  builder.add_side_set(1, "", [&](const test::CandidateSide& face) {
    const auto nodes = bare.element_nodes(face.side.element());
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (NodeIndex node : nodes) middle += bare.coordinates().col(node.value) / double(nodes.size());
    CHECK((face.centroid - middle).dot(face.normal) > 0.0);
    ++n_faces;
    return true;
  });
  CHECK(n_faces == 2 * 6 + 10 * 4 + 6 * 4 + 2 * 5 + 6 * 5);
}

TEST_CASE("the facets of a six-node face are its triangles, each midside node between its corners",
          "[core][topology]") {
  const Mesh mesh = test::MeshBuilder().add_ten_node_tets({}).build();
  const auto& x = mesh.coordinates();
  for (std::uint32_t element = 0; element < mesh.n_elements(); ++element) {
    for (int side = 1; side <= 4; ++side) {
      const auto corners = mesh.side_nodes(ElementSide({element}, side));
      const auto at = [&](NodeIndex node) -> Eigen::Vector3d { return x.col(node.value); };
      const Eigen::Vector3d area =
          (at(corners[1]) - at(corners[0])).cross(at(corners[2]) - at(corners[0])) / 2;
      const SideFacets facets = mesh.side_facets(ElementSide({element}, side));
      REQUIRE(facets.n == 4);
      for (const auto& f : facets) {
        CHECK(f[2] == f[3]);
        const Eigen::Vector3d part = (at(f[1]) - at(f[0])).cross(at(f[2]) - at(f[0])) / 2;
        CHECK((part - area / 4).norm() < 1e-14);
      }
      for (std::size_t k = 0; k < 3; ++k) {
        CHECK(facets.corners[k][k] == corners[k]);
        CHECK((at(facets.corners[3][k]) - (at(corners[k]) + at(corners[(k + 1) % 3])) / 2).norm() < 1e-14);
      }
    }
  }
}

TEST_CASE("type names are read in every spelling seen in files", "[core][topology]") {
  CHECK(find_shape("HEX", 8) == Shape::hex8);
  CHECK(find_shape("hex8", 20) == Shape::hex20);  // the number of columns decides
  CHECK(find_shape("HEXAHEDRON_8", 8) == Shape::hex8);
  CHECK(find_shape("HEX27", 27) == Shape::hex27);
  CHECK(find_shape(" Hex ", 8) == Shape::hex8);
  CHECK(find_shape(std::string_view("TETRA\0\0", 7), 4) == Shape::tet4);
  CHECK(find_shape("tetra10", 10) == Shape::tet10);
  CHECK(find_shape("WEDGE", 6) == Shape::wedge6);
  CHECK(find_shape("PENTA", 15) == Shape::wedge15);
  CHECK(find_shape("PRISM", 6) == Shape::wedge6);
  CHECK(find_shape("PYRA5", 5) == Shape::pyramid5);
  CHECK(find_shape("SHELL", 4) == Shape::shell4);
  CHECK(find_shape("SHELL3", 3) == Shape::shell3);
  CHECK(find_shape("SHELL6", 6) == Shape::shell6);
  CHECK(find_shape("TRISHELL3", 3) == Shape::shell3);
  CHECK(find_shape("TRI6", 6) == Shape::shell6);
  CHECK(find_shape("quad", 4) == Shape::quad4);
  CHECK(find_shape("QUAD9", 9) == Shape::quad9);
  CHECK(find_shape("TRUSS", 2) == Shape::bar2);
  CHECK(find_shape("EDGE3", 3) == Shape::bar3);
  CHECK(find_shape("ROD", 2) == Shape::bar2);
  CHECK(find_shape("LINE", 2) == Shape::bar2);
  CHECK(find_shape("BEAM", 2) == Shape::beam2);
  CHECK(find_shape("BEAM3", 3) == Shape::beam3);
  CHECK(find_shape("sphere-mass", 1) == Shape::sphere);
  CHECK(find_shape("CIRCLE", 1) == Shape::sphere);
  CHECK(find_shape("NULL", 0) == Shape::null);
}

TEST_CASE("what no shape fits is unknown", "[core][topology]") {
  CHECK(find_shape("HEX", 9) == Shape::unknown);
  CHECK(find_shape("TETRA14", 14) == Shape::unknown);
  CHECK(find_shape("BEX_HEX", 8) == Shape::unknown);
  CHECK(find_shape("SUPER", 8) == Shape::unknown);
  CHECK(find_shape("SHELL2", 2) == Shape::unknown);
  CHECK(find_shape("NULL", 8) == Shape::unknown);
  CHECK(find_shape("", 8) == Shape::unknown);
  CHECK(find_shape("HE", 8) == Shape::unknown);
  CHECK(find_shape("HEX", -1) == Shape::unknown);
}
