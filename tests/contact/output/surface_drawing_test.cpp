// SPDX-License-Identifier: BSD-3-Clause
#include "contact/output/surface_drawing.hpp"

#include <fmt/format.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "support/catch.hpp"
#include "support/contact_deck.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

using Facet = std::array<std::uint32_t, 4>;

Eigen::Vector3d point(const FacetMesh& drawing, std::uint32_t column) {
  return drawing.coordinates.col(column);
}

/// Sum of the facets' areas times their unit normals, of which a closed surface has none, and of their areas.
Eigen::Vector4d area_sums(const FacetMesh& drawing, const FacetBlock& block) {
  Eigen::Vector4d sums = Eigen::Vector4d::Zero();
  for (const Facet& f : block.facets) {
    const Eigen::Vector3d diagonal = point(drawing, f[2]) - point(drawing, f[0]),
                          other = point(drawing, f[3]) - point(drawing, f[1]);
    const Eigen::Vector3d area = 0.5 * diagonal.cross(other);
    sums += Eigen::Vector4d(area.x(), area.y(), area.z(), area.norm());
  }
  return sums;
}

FacetMesh draw_all(const ContactModel& model, const Mesh& mesh) {
  return draw_surfaces(model, mesh, std::vector<SurfaceOptions>{});
}

/// The surfaces alone, without their edges.
FacetMesh draw_faces(const ContactModel& model, const Mesh& mesh) {
  FacetMesh drawing = draw_all(model, mesh);
  drawing.blocks.resize(model.surfaces.surfaces.size());
  return drawing;
}

/// The blocks as "name facets points", one a line.
std::string list_blocks(const FacetMesh& drawing) {
  std::string text;
  for (const FacetBlock& block : drawing.blocks)
    text += fmt::format("{} {} {}\n", block.name, block.facets.size(), block.points.size());
  return text;
}

/// Where a block's points stand: "(0 0 1) (1 0 1)".
std::string list_points(const FacetMesh& drawing, const FacetBlock& block) {
  std::string text;
  for (const std::uint32_t column : block.points) {
    const Eigen::Vector3d x = point(drawing, column);
    text += fmt::format("({} {} {})", x.x(), x.y(), x.z());
  }
  return text;
}

}  // namespace

TEST_CASE("every surface is drawn as one block of its name, empty ones too", "[contact][drawing]") {
  MeshBuilder b;
  b.add_hexes({.id = 1, .name = "Plate", .cells = {2, 1, 1}});
  b.add_side_set(1, "", {{{1}, 2}});
  b.add_node_set(2, "", {0, 4});
  const Mesh mesh = b.build();
  const auto model = make_model(mesh,
                                "contact surface end contains surface_1\n"
                                "skin all blocks = on\n"
                                "contact node set tips contains nodelist_2\n"
                                "contact surface again contains surface_1\n");
  REQUIRE(model.messages.empty());
  CHECK(list_blocks(draw_faces(model, mesh)) ==
        "end 1 0\n"
        "Plate 9 0\n"
        "tips 0 2\n"
        "again 0 0\n");
}

TEST_CASE("faces are drawn with the corners of the mesh, outwards, and share points", "[contact][drawing]") {
  const Mesh mesh = MeshBuilder().add_hexes({.id = 1, .origin = {1, 2, 3}, .size = {2, 3, 4}}).build();
  const auto model = make_model(mesh, "skin all blocks = on\n");
  const FacetMesh drawing = draw_all(model, mesh);
  CHECK(drawing.coordinates.cols() == 8);
  REQUIRE(drawing.blocks.at(0).facets.size() == 6);
  for (std::size_t i = 0; i < 6; ++i) {
    const auto nodes = mesh.side_nodes(model.surfaces.surfaces[{0}].faces[i]);
    for (std::size_t corner = 0; corner < 4; ++corner) {
      const Eigen::Vector3d drawn = point(drawing, drawing.blocks[0].facets[i][corner]);
      CHECK(drawn == mesh.coordinates().col(nodes[corner].value));
    }
  }
  const Eigen::Vector4d sums = area_sums(drawing, drawing.blocks[0]);
  CHECK(sums.head<3>().norm() == 0.0);
  CHECK(sums[3] == 52.0);  // 2 (2*3 + 3*4 + 2*4)
}

TEST_CASE("a triangle repeats its last point", "[contact][drawing]") {
  const Mesh mesh = MeshBuilder().add_tets({.id = 1}, 5).build();
  const FacetMesh drawing = draw_all(make_model(mesh, "skin all blocks = on\n"), mesh);
  REQUIRE(drawing.blocks.at(0).facets.size() == 12);
  for (const Facet& facet : drawing.blocks[0].facets) {
    CHECK(facet[3] == facet[2]);
    CHECK((facet[0] != facet[1] && facet[1] != facet[2] && facet[2] != facet[0]));
  }
}

TEST_CASE("lofts are drawn in their surfaces' blocks, behind the faces", "[contact][drawing]") {
  // Two shells of 1 x 1, 0.2 thick, in two surfaces; each has 5 facets: 2 of area 1, 3 of area 0.2.
  MeshBuilder b;
  b.add_hexes({.id = 1, .origin = {0, 0, 5}});
  b.add_shells({.id = 2, .cells = {2, 1}, .u = {2, 0, 0}});
  b.set_attributes(2, {"thickness"}, {0.2, 0.2});
  const Mesh mesh = b.build();
  const auto model = make_model(mesh,
                                "begin contact surface right\n block = block_1\n element = 3\nend\n"
                                "contact surface left contains block_2\n");
  REQUIRE(model.messages.empty());
  const FacetMesh drawing = draw_faces(model, mesh);
  CHECK(list_blocks(drawing) == "right 11 0\nleft 5 0\n");
  CHECK(drawing.coordinates.cols() == 8 + 16);
  CHECK(area_sums(drawing, drawing.blocks[1])[3] == Approx(2.6).epsilon(1e-14));
  for (const Facet& facet : drawing.blocks[1].facets) {
    for (const std::uint32_t corner : facet) {
      CHECK(point(drawing, corner).x() <= 1.0);
      CHECK(std::abs(point(drawing, corner).z()) == Approx(0.1).epsilon(1e-14));
    }
  }
  for (std::size_t i = 6; i < 11; ++i) CHECK(point(drawing, drawing.blocks[0].facets[i][0]).z() < 1.0);
}

TEST_CASE("a sphere is drawn closed and outwards by 24 quadrilaterals on it", "[contact][drawing]") {
  MeshBuilder b;
  b.add_spheres(1, "", {{1, 2, 3}});
  b.set_attributes(1, {"radius"}, {0.5});
  const Mesh mesh = b.build();
  const FacetMesh drawing = draw_all(make_model(mesh, "contact surface s contains block_1\n"), mesh);
  const FacetBlock& sphere = drawing.blocks.at(0);
  CHECK(sphere.facets.size() == 24);
  const Eigen::Vector3d centre(1, 2, 3);
  const auto key = [&](std::uint32_t column) {
    const Eigen::Vector3d x = point(drawing, column) * 1e6;
    return std::array{std::llround(x.x()), std::llround(x.y()), std::llround(x.z())};
  };
  std::map<std::pair<std::array<long long, 3>, std::array<long long, 3>>, int> edges;
  for (const Facet& facet : sphere.facets) {
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < 4; ++i) {
      const Eigen::Vector3d corner = point(drawing, facet[i]);
      CHECK((corner - centre).norm() == Approx(0.5).epsilon(1e-14));
      middle += corner / 4;
      ++edges[{key(facet[i]), key(facet[(i + 1) % 4])}];
    }
    const Eigen::Vector3d diagonal = point(drawing, facet[2]) - point(drawing, facet[0]),
                          other = point(drawing, facet[3]) - point(drawing, facet[1]);
    CHECK(diagonal.cross(other).dot(middle - centre) > 0.0);
  }
  CHECK(edges.size() == 96);  // 48 edges, each run through once in either direction
  for (const auto& [edge, n] : edges) {
    CHECK(n == 1);
    CHECK(edges.count({edge.second, edge.first}) == 1);
  }
}

TEST_CASE("nodes are drawn as points, which faces may share", "[contact][drawing]") {
  MeshBuilder b;
  b.add_hexes({.id = 1});
  b.add_node_set(2, "", [](const Eigen::Vector3d& x) { return x.z() > 0.5 && x.x() < 0.5; });
  const Mesh mesh = b.build();
  const auto model = make_model(mesh,
                                "contact node set n contains nodelist_2\n"
                                "skin all blocks = on\n");
  const FacetMesh drawing = draw_all(model, mesh);
  CHECK(list_points(drawing, drawing.blocks.at(0)) == "(0 0 1)(0 1 1)");
  CHECK(drawing.coordinates.cols() == 8);
}

TEST_CASE("a plane is drawn as a square three times as long as the mesh", "[contact][drawing]") {
  // The mesh's largest length is 4: the square has sides of 12, with SCALE FACTOR 0.5 of 6.
  const Mesh mesh = MeshBuilder().add_hexes({.id = 1, .size = {4, 1, 1}}).build();
  const bool is_scaled = GENERATE(false, true);
  const auto model =
      make_model(mesh, parse_region(std::string("begin analytic object floor\n"
                                                " normal direction = 0 3 4\n origin = 1 2 3\n") +
                                    (is_scaled ? " scale factor = 0.5\n" : "") +
                                    "end\n"
                                    "begin contact definition\n contact surface s contains floor\nend\n"));
  REQUIRE(model.messages.empty());
  const FacetMesh drawing = draw_faces(model, mesh);
  REQUIRE(list_blocks(drawing) == "s 1 0\n");
  const double side = is_scaled ? 6.0 : 12.0;
  const Facet& square = drawing.blocks[0].facets[0];
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < 4; ++i) {
    middle += point(drawing, square[i]) / 4;
    const Eigen::Vector3d edge = point(drawing, square[(i + 1) % 4]) - point(drawing, square[i]);
    CHECK(edge.norm() == Approx(side).epsilon(1e-14));
  }
  CHECK((middle - Eigen::Vector3d(1, 2, 3)).norm() < 1e-13);  // round-off at numbers of order 10
  const Eigen::Vector4d sums = area_sums(drawing, drawing.blocks[0]);
  CHECK((sums.head<3>() - side * side * Eigen::Vector3d(0, 0.6, 0.8)).norm() < 1e-12);
}

TEST_CASE("what dies is no longer drawn", "[contact][drawing][death]") {
  MeshBuilder b;
  b.add_hexes({.id = 1, .cells = {2, 1, 1}});
  b.add_spheres(2, "", {{0, 5, 0}});
  b.set_attributes(2, {"radius"}, {1});
  const Mesh mesh = b.build();
  const auto model = make_model(mesh, "skin all blocks = on\n", "", all_but(mesh, {2, 3}));
  const FacetMesh drawing = draw_faces(model, mesh);
  CHECK(list_blocks(drawing) == "block_1 6 0\nblock_2 0 0\n");
  CHECK(drawing.coordinates.cols() == 8);
}

TEST_CASE("edges that meet edges are drawn in blocks of their own, with names of their own",
          "[contact][drawing]") {
  MeshBuilder b;
  b.add_hexes({.id = 1, .name = "cube"})
      .add_bars({.id = 2, .name = "rod", .cells = 3, .from = {5, 0, 0}, .to = {8, 0, 0}});
  b.set_attributes(2, {"area"}, {0.01, 0.01, 0.01});
  b.add_hexes({.id = 3, .name = "cube_edges", .origin = {0, 0, 5}});
  const Mesh mesh = b.build();
  const auto model = make_model(mesh, "skin all blocks = on\n");
  REQUIRE(model.messages.empty());
  const FacetMesh drawing = draw_all(model, mesh);
  std::vector<std::string> names;
  std::vector<std::size_t> counts;
  for (std::size_t i = 3; i < drawing.blocks.size(); ++i) {
    names.push_back(drawing.blocks[i].name);
    counts.push_back(drawing.blocks[i].edges.size());
    for (const auto& edge : drawing.blocks[i].edges)
      CHECK((point(drawing, edge[0]) - point(drawing, edge[1])).norm() == Approx(1.0));
  }
  CHECK(names == std::vector<std::string>{"cube_edges_2", "rod_edges", "cube_edges_edges"});
  CHECK(counts == std::vector<std::size_t>{12, 3, 12});
}
