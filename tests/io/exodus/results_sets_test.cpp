// SPDX-License-Identifier: BSD-3-Clause
#include "io/exodus/results_sets.hpp"

#include "io/exodus/drafted_file.hpp"
#include "io/exodus/sample_mesh.hpp"
#include "support/catch.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

using Numbers = std::vector<double>;

DraftedFile with_sets(const Mesh& mesh) {
  return DraftedFile([&](ExodusDraft& draft) {
    add_sets(mesh, draft);
    add_assemblies(mesh, draft);
  });
}

}  // namespace

TEST_CASE("sets are written with their factors, empty ones by their row alone", "[io][results]") {
  MeshParts parts = two_hexes().parts();
  parts.side_sets[0].distribution_factors.assign(8, 0.5);
  parts.node_sets[0].distribution_factors.clear();
  parts.node_sets.push_back({7, "none", {}, {}});
  const std::size_t n_nodes = parts.node_sets[0].nodes.size();
  const DraftedFile drafted = with_sets(Mesh(std::move(parts)));
  const NetcdfFile file = drafted.open();
  CHECK(DraftedFile::numbers(file, "elem_ss1") == Numbers{2, 1});
  CHECK(DraftedFile::numbers(file, "side_ss1") == Numbers{6, 1});
  CHECK(DraftedFile::numbers(file, "dist_fact_ss1") == Numbers(8, 0.5));
  CHECK(DraftedFile::numbers(file, "node_ns1").size() == n_nodes);
  CHECK_FALSE(file.find_variable("dist_fact_ns1"));
  CHECK(DraftedFile::numbers(file, "ns_status") == Numbers{1, 0});
  CHECK_FALSE(file.find_variable("node_ns2"));
}

TEST_CASE("an assembly names its members by their ids", "[io][results]") {
  MeshParts parts = two_hexes().parts();
  parts.assemblies = {{5, "solids", EntityKind::block, {1, 0}}};
  const DraftedFile drafted = with_sets(Mesh(std::move(parts)));
  const NetcdfFile file = drafted.open();
  CHECK(DraftedFile::numbers(file, "assembly_entity5") == Numbers{20, 10});
  const NetcdfVariable variable = file.find_variable("assembly_entity5").value();
  CHECK(file.find_integer(variable, "_id") == 5);
  CHECK(file.find_integer(variable, "_type") == 1);
  CHECK(file.find_text(variable, "_name") == "solids");
}

TEST_CASE("assemblies that nobody can write are left out", "[io][results]") {
  MeshParts parts = two_hexes().parts();
  parts.assemblies = {{1, "blobs", std::nullopt, {}},
                      {2, "of blobs", EntityKind::assembly, {0}},
                      {3, "mixed", EntityKind::assembly, {1, 3}},
                      {4, "solids", EntityKind::block, {0, 1}}};
  const DraftedFile drafted = with_sets(Mesh(std::move(parts)));
  const NetcdfFile file = drafted.open();
  CHECK(file.variable_names("assembly_entity") ==
        std::vector<std::string>{"assembly_entity3", "assembly_entity4"});
  CHECK(DraftedFile::numbers(file, "assembly_entity3") == Numbers{4});
}
