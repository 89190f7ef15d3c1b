// SPDX-License-Identifier: BSD-3-Clause
#include "core/mesh/element_checks.hpp"

#include <Eigen/LU>
#include <cmath>
#include <random>

#include "core/base/errors.hpp"
#include "support/catch.hpp"
#include "support/mesh_builder.hpp"

using namespace contactsim;
using Catch::Matchers::Contains;
using test::MeshBuilder;

namespace {

double volume_of(const Mesh& mesh, std::uint32_t element) {
  const ElementBlock& block = mesh.blocks()[mesh.block_of({element})];
  return solid_volume(mesh.coordinates(), mesh.element_nodes({element}), topology(block.shape));
}

// Two-point Gauss quadrature of the trilinear map's Jacobian, exact because that is quadratic in each
// direction.
double integrate_hex(const Eigen::Matrix3Xd& x) {
  const double corners[8][3] = {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1},
                                {-1, -1, 1},  {1, -1, 1},  {1, 1, 1},  {-1, 1, 1}};
  double sum = 0.0;
  for (const auto& point : corners) {
    const Eigen::Vector3d p = Eigen::Vector3d(point[0], point[1], point[2]) / std::sqrt(3.0);
    Eigen::Matrix3d jacobian = Eigen::Matrix3d::Zero();
    for (int a = 0; a < 8; ++a) {
      const Eigen::Vector3d c(corners[a][0], corners[a][1], corners[a][2]);
      const Eigen::Vector3d f = Eigen::Vector3d::Ones() + c.cwiseProduct(p);
      const Eigen::Vector3d gradient(c[0] * f[1] * f[2], f[0] * c[1] * f[2], f[0] * f[1] * c[2]);
      jacobian += x.col(a) * gradient.transpose() / 8.0;
    }
    sum += jacobian.determinant();
  }
  return sum;
}

// The refusal of all blocks together.
std::string complaints(const Mesh& mesh) {
  std::vector<std::uint32_t> all;
  for (std::uint32_t b = 0; b < mesh.blocks().size(); ++b) all.push_back(b);
  try {
    check_elements(mesh, all);
  } catch (const FileError& error) {
    return std::string(error.what()) + "\n";
  }
  return "";
}

}  // namespace

TEST_CASE("the volumes of a box's solids sum to the box", "[core][elements]") {
  MeshBuilder builder;
  const test::Box box{.cells = {2, 3, 4}, .origin = {100, -7, 3}, .size = {2, 1, 0.5}};
  SECTION("hexes") { builder.add_hexes(box); }
  SECTION("five tets") { builder.add_tets(box, 5); }
  SECTION("six tets") { builder.add_tets(box, 6); }
  SECTION("ten-node tets") { builder.add_ten_node_tets(box); }
  SECTION("wedges") { builder.add_wedges(box); }
  SECTION("pyramids") { builder.add_pyramids(box); }
  const Mesh mesh = builder.build();
  double sum = 0.0;
  for (std::uint32_t e = 0; e < mesh.n_elements(); ++e) {
    CHECK(volume_of(mesh, e) > 0.0);
    sum += volume_of(mesh, e);
  }
  CHECK(sum == Approx(1.0).epsilon(1e-12));
  CHECK(complaints(mesh).empty());
}

TEST_CASE("the volume of a warped hex is the integral of its Jacobian", "[core][elements]") {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> shift(-0.3, 0.3);
  for (int i = 0; i < 50; ++i) {
    MeshParts parts = MeshBuilder().add_hexes({}).parts();
    for (Eigen::Index n = 0; n < 8; ++n) {
      for (int axis = 0; axis < 3; ++axis) parts.coordinates(axis, n) += shift(random);
    }
    const Mesh mesh(parts);
    Eigen::Matrix3Xd x(3, 8);
    for (int a = 0; a < 8; ++a)
      x.col(a) = mesh.coordinates().col(mesh.element_nodes({0})[std::size_t(a)].value);
    // Round-off of about a hundred sums of order one.
    CHECK(volume_of(mesh, 0) == Approx(integrate_hex(x)).epsilon(1e-13));
  }
}

TEST_CASE("elements inside out or flat are listed by block, id and volume", "[core][elements]") {
  MeshParts parts = MeshBuilder()
                        .add_hexes({.id = 10, .name = "lower", .cells = {3, 1, 1}})
                        .add_tets({.id = 20, .origin = {0, 0, 5}})
                        .add_shells({.id = 30, .origin = {0, 0, 9}})
                        .set_element_ids({11, 12, 13, 21, 22, 23, 24, 25, 26, 31})
                        .parts();
  parts.path = "plate.g";
  auto& hexes = parts.blocks[0].nodes;
  for (std::size_t i = 0; i < 4; ++i)
    std::swap(hexes[8 + i], hexes[8 + i + 4]);  // element 12: bottom and top swapped
  auto& tets = parts.blocks[1].nodes;
  tets[3] = tets[2];  // element 21: flat
  CHECK(complaints(Mesh(parts)) ==
        "plate.g: 1 element is inside out:\n"
        "  lower: element 12: volume -0.333333\n"
        "1 element is without volume:\n"
        "  block_20: element 21: volume 0\n");
}

TEST_CASE("many bad elements are counted, and the first five shown", "[core][elements]") {
  MeshParts parts = MeshBuilder().add_hexes({.cells = {10, 10, 10}}).parts();
  parts.coordinates.row(2) *= -1.0;
  const std::string text = complaints(Mesh(parts));
  CHECK(text.find("1000 elements are inside out") != std::string::npos);
  CHECK(text.find("element 5:") != std::string::npos);
  CHECK(text.find("element 6:") == std::string::npos);
  CHECK(text.find("and 995 more") != std::string::npos);
}

TEST_CASE("only the blocks asked for are checked", "[core][elements]") {
  MeshParts parts = MeshBuilder().add_hexes({.id = 1}).add_hexes({.id = 2, .origin = {5, 0, 0}}).parts();
  std::swap(parts.blocks[1].nodes[0], parts.blocks[1].nodes[6]);
  const Mesh mesh(parts);
  const std::uint32_t first[] = {0}, second[] = {1};
  CHECK_NOTHROW(check_elements(mesh, first));
  CHECK_THROWS_AS(check_elements(mesh, second), FileError);
}

TEST_CASE("a hex collapsed to a wedge is legal, one collapsed to a plane is not", "[core][elements]") {
  MeshParts parts = MeshBuilder().add_hexes({}).parts();
  auto& nodes = parts.blocks[0].nodes;
  nodes[3] = nodes[2];
  nodes[7] = nodes[6];
  CHECK(complaints(Mesh(parts)).empty());
  for (std::size_t i = 0; i < 4; ++i) nodes[4 + i] = nodes[i];
  CHECK(complaints(Mesh(parts)).find("is without volume") != std::string::npos);
}

TEST_CASE("thin elements far from the origin pass, round-off does not", "[core][elements]") {
  const auto slab = [](double thickness) {
    return MeshBuilder()
        .add_hexes({.origin = {1000, 1000, 1000}, .size = {1, 1, thickness}, .share_nodes = false})
        .build();
  };
  CHECK(complaints(slab(1e-9)).empty());
  // The coordinates themselves are good to 1e-13.
  CHECK(complaints(slab(1e-13)).find("is without volume") != std::string::npos);
}

TEST_CASE("shells without area and elements beyond all numbers are refused", "[core][elements]") {
  const auto sheet = [](double width, double size) {
    MeshParts parts = MeshBuilder().add_shells({.cells = {2, 1}}).parts();
    parts.coordinates.row(1) *= width;
    parts.coordinates *= size;
    return complaints(Mesh(parts));
  };
  CHECK(sheet(1.0, 1.0) == "");
  CHECK(sheet(1e-9, 1.0) == "");
  CHECK_THAT(sheet(0.0, 1.0), Contains("2 elements are without area:\n  block_1: element 1: area 0"));
  CHECK_THAT(sheet(1.0, 1e-200), Contains("2 elements are without area"));
  CHECK_THAT(sheet(1.0, 1e200), Contains("2 elements are so large that their size is no number"));
  MeshParts cube = MeshBuilder().add_hexes({}).parts();
  cube.coordinates *= 1e150;
  CHECK_THAT(complaints(Mesh(cube)), Contains("1 element is so large"));
}

TEST_CASE("solids are told where their volume is not positive, however warped, far or small",
          "[core][elements]") {
  const double size = GENERATE(1.0, 1e-9, 1e6), far = GENERATE(0.0, 1e3);
  std::mt19937 random(11);
  std::uniform_real_distribution<double> shift(-0.9, 0.9);
  std::size_t n_told = 0;
  for (int i = 0; i < 200; ++i) {
    MeshParts parts = MeshBuilder().add_hexes({}).add_wedges({.id = 2, .origin = {3, 0, 0}}).parts();
    for (Eigen::Index n = 0; n < parts.coordinates.cols(); ++n) {
      for (int axis = 0; axis < 3; ++axis) parts.coordinates(axis, n) += shift(random);
    }
    parts.coordinates = (parts.coordinates.array() + far) * size;
    const Mesh mesh(parts);
    std::size_t n_bad = 0;
    for (std::uint32_t e = 0; e < mesh.n_elements(); ++e) n_bad += volume_of(mesh, e) > 0.0 ? 0 : 1;
    const std::string text = complaints(mesh);
    CHECK(text.empty() == (n_bad == 0));
    if (n_bad > 0) CHECK_THAT(text, Contains(std::to_string(n_bad) + " element"));
    n_told += n_bad;
  }
  CHECK(n_told > 20);
}
