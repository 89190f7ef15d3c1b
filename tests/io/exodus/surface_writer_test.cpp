// SPDX-License-Identifier: BSD-3-Clause
#include "io/exodus/surface_writer.hpp"

#include "core/base/errors.hpp"
#include "core/mesh/mesh.hpp"
#include "io/exodus/exodus_reader.hpp"
#include "support/catch.hpp"
#include "support/temporary_directory.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

const std::string long_name = "the_surface_of_the_third_bolt_of_the_second_flange";

// A unit square, a square beside it cut in two triangles, an empty surface, a mixture and two points.
FacetMesh some_surfaces() {
  FacetMesh mesh;
  mesh.coordinates.resize(3, 7);
  mesh.coordinates << 0, 1, 1, 0, 2, 2, 9,  //
      0, 0, 1, 1, 0, 1, 9,                  //
      0, 0, 0, 0, 0, 0, 9;
  mesh.blocks = {{"square", {{0, 1, 2, 3}}, {}},
                 {"triangles", {{1, 4, 5, 5}, {1, 5, 2, 2}}, {}},
                 {"nothing", {}, {}},
                 {long_name, {{0, 1, 2, 3}, {1, 4, 5, 5}}, {}},
                 {"two points", {}, {6, 0}}};
  return mesh;
}

Mesh write_and_read(const FacetMesh& surfaces, const std::string& title) {
  const TemporaryDirectory directory;
  write_facet_mesh(directory.file("surfaces.e"), surfaces, title);
  Diagnostics warnings;
  Mesh mesh = read_mesh(directory.file("surfaces.e"), warnings);
  CHECK(warnings.empty());
  return mesh;
}

}  // namespace

TEST_CASE("each surface comes back as a block of its name", "[io][surfaces]") {
  const Mesh found = write_and_read(some_surfaces(), "plate.i");
  CHECK(found.title() == "plate.i");
  CHECK(found.coordinates() == some_surfaces().coordinates);
  CHECK(found.names(EntityKind::block) ==
        std::vector<std::string>{"square", "triangles", "nothing", long_name, "two points"});
  std::vector<Shape> shapes;
  std::vector<std::int64_t> ids;
  std::vector<std::vector<NodeIndex>> nodes;
  for (const ElementBlock& block : found.blocks()) {
    shapes.push_back(block.shape);
    ids.push_back(block.id);
    nodes.push_back(block.nodes);
  }
  CHECK(shapes == std::vector{Shape::shell4, Shape::shell3, Shape::null, Shape::shell4, Shape::sphere});
  CHECK(ids == std::vector<std::int64_t>{1, 2, 3, 4, 5});
  CHECK(nodes == std::vector<std::vector<NodeIndex>>{{{0}, {1}, {2}, {3}},
                                                     {{1}, {4}, {5}, {1}, {5}, {2}},
                                                     {},
                                                     {{0}, {1}, {2}, {3}, {1}, {4}, {5}, {5}},
                                                     {{6}, {0}}});
}

TEST_CASE("no surfaces and only empty ones are legal files", "[io][surfaces]") {
  CHECK(write_and_read({Eigen::Matrix3Xd(3, 0), {}}, "").blocks().empty());
  const Mesh found = write_and_read({Eigen::Matrix3Xd(3, 0), {{"a", {}, {}}, {"b", {}, {}}}}, "");
  CHECK(found.names(EntityKind::block) == std::vector<std::string>{"a", "b"});
  CHECK(found.n_elements() == 0);
}

TEST_CASE("a long title is cut at 80 characters", "[io][surfaces]") {
  CHECK(write_and_read(some_surfaces(), std::string(200, 't')).title() == std::string(80, 't'));
}

TEST_CASE("the same surfaces give the same bytes", "[io][surfaces]") {
  const TemporaryDirectory directory;
  write_facet_mesh(directory.file("a.e"), some_surfaces(), "t");
  write_facet_mesh(directory.file("b.e"), some_surfaces(), "t");
  CHECK(read_bytes(directory.file("a.e")) == read_bytes(directory.file("b.e")));
  write_facet_mesh(directory.file("a.e"), some_surfaces(), "other");
  CHECK(read_bytes(directory.file("a.e")) != read_bytes(directory.file("b.e")));
}

TEST_CASE("a file that cannot be written is an error", "[io][surfaces]") {
  CHECK_THROWS_AS(write_facet_mesh("/nowhere/at/all.e", some_surfaces(), ""), FileError);
}

// Written here and looked at by surfaces_in_vtk.py, which CTest runs afterwards where VTK is installed.
TEST_CASE("surfaces for VTK to read", "[.][vtk]") {
  write_facet_mesh(std::string(CONTACTSIM_BINARY_DIR) + "/surfaces_for_vtk.e", some_surfaces(), "for VTK");
}

TEST_CASE("edges come back as bars", "[io][surfaces]") {
  FacetMesh surfaces = some_surfaces();
  surfaces.blocks.push_back({"square_edges", {}, {}, {{0, 1}, {1, 2}}});
  const Mesh found = write_and_read(surfaces, "plate.i");
  const ElementBlock& edges = found.blocks()[5];
  CHECK(edges.name == "square_edges");
  CHECK(edges.shape == Shape::bar2);
  CHECK(edges.nodes == std::vector<NodeIndex>{{0}, {1}, {1}, {2}});
}
