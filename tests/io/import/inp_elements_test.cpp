// SPDX-License-Identifier: BSD-3-Clause
#include "io/import/inp_elements.hpp"

#include <algorithm>

#include "support/catch.hpp"

using namespace contactsim;

TEST_CASE("types of elements are known by how they begin, faces as Abaqus counts them", "[io][import]") {
  CHECK(find_inp_type("S4R")->shape == Shape::shell4);
  CHECK(find_inp_type("C3D10M")->shape == Shape::tet10);
  CHECK(find_inp_type("S45") == nullptr);
  CHECK(find_inp_type("C3D20R") == nullptr);
  for (const Shape shape : {Shape::hex8, Shape::tet4, Shape::tet10, Shape::wedge6, Shape::pyramid5})
    CHECK(inp_faces(shape).size() == topology(shape).sides.size());
  CHECK(inp_faces(Shape::shell4).empty());
}

TEST_CASE("the longest family that fits a type of element is taken", "[io][import]") {
  struct Row {
    const char* type;
    Shape shape;
    int n_nodes, dimension;
  };
  for (const Row& row :
       {Row{"C3D8", Shape::hex8, 8, 3}, Row{"C3D8R", Shape::hex8, 8, 3}, Row{"C3D10", Shape::tet10, 10, 3},
        Row{"C3D4H", Shape::tet4, 4, 3}, Row{"C3D6", Shape::wedge6, 6, 3}, Row{"C3D5", Shape::pyramid5, 5, 3},
        Row{"COH3D8", Shape::hex8, 8, 3}, Row{"SC8R", Shape::hex8, 8, 3}, Row{"S3R", Shape::shell3, 3, 2},
        Row{"STRI3", Shape::shell3, 3, 2}, Row{"SFM3D4R", Shape::shell4, 4, 2},
        Row{"B31H", Shape::beam2, 2, 1}, Row{"T3D2", Shape::bar2, 2, 1}, Row{"SPRINGA", Shape::bar2, 2, 1},
        Row{"MASS", Shape::sphere, 1, 0}}) {
    INFO(row.type);
    const InpType* found = find_inp_type(row.type);
    REQUIRE(found != nullptr);
    CHECK(found->shape == row.shape);
    CHECK(found->n_nodes == row.n_nodes);
    CHECK(found->dimension == row.dimension);
  }
}

TEST_CASE("types of other numbers of nodes, in lower case or of no name are not read", "[io][import]") {
  for (const char* type :
       {"", "C3D", "C3D27", "C3D15", "c3d8", "S8R", "S4R5", "B32", "T3D3", "M3D8", "R3D"}) {
    INFO(type);
    // Of the shells of five degrees of freedom S4R5 is a shell of four nodes all the same.
    CHECK((find_inp_type(type) == nullptr) == (std::string_view(type) != "S4R5"));
  }
}

TEST_CASE("a face of a solid has corners of it, each once, and all faces go round each edge both ways",
          "[io][import]") {
  for (const Shape shape : {Shape::hex8, Shape::tet4, Shape::tet10, Shape::wedge6, Shape::pyramid5}) {
    std::vector<std::pair<int, int>> edges;
    for (const std::vector<int>& face : inp_faces(shape)) {
      for (std::size_t i = 0; i < face.size(); ++i) edges.emplace_back(face[i], face[(i + 1) % face.size()]);
    }
    for (const auto& [from, to] : edges) {
      INFO(topology(shape).name << " " << from << " " << to);
      CHECK(std::count(edges.begin(), edges.end(), std::pair(from, to)) == 1);
      CHECK(std::count(edges.begin(), edges.end(), std::pair(to, from)) == 1);
    }
  }
}
