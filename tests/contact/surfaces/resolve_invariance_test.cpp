// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <omp.h>

#include <algorithm>
#include <set>

#include "contact/surfaces/resolve_surfaces.hpp"
#include "support/catch.hpp"
#include "support/contact_deck.hpp"
#include "support/random_contact.hpp"

// What must not change ownership: numbering, unrelated commands, threads; and what death must come to.

using namespace contactsim;
using namespace contactsim::test;

namespace {

/// Surfaces with sorted entries, so that they can be compared whatever the numbering.
std::string describe_sorted(const Mesh& mesh, const Resolved& result) {
  const auto sorted = [](std::string list) {
    std::replace(list.begin(), list.end(), ' ', '\n');
    std::set<std::string> words;
    for (std::size_t at = 0; at < list.size();) {
      const std::size_t end = std::min(list.find('\n', at), list.size());
      words.insert(list.substr(at, end - at));
      at = end + 1;
    }
    return fmt::format("{}", fmt::join(words, " "));
  };
  std::string text;
  for (const ContactSurface& surface : result.surfaces) {
    text += fmt::format("{} | {} | {} | {} | {}\n", surface.name, sorted(list_faces(mesh, surface)),
                        sorted(list_lofted(mesh, surface)), sorted(list_nodes(mesh, surface)),
                        list_lost(result, surface));
  }
  return text + list_warnings(result);
}

std::vector<std::uint32_t> random_order(std::uint32_t n, Random& random) {
  std::vector<std::uint32_t> order(n);
  std::iota(order.begin(), order.end(), 0u);
  std::shuffle(order.begin(), order.end(), random);
  return order;
}

/// The same mesh with its nodes, and the elements of each block, in another order; ids stay with them.
MeshParts renumbered(const Mesh& mesh, const MeshParts& old, Random& random) {
  MeshParts parts = old;
  const auto new_node = random_order(mesh.n_nodes(), random);
  parts.node_ids.resize(mesh.n_nodes());
  for (std::uint32_t n = 0; n < mesh.n_nodes(); ++n) {
    parts.coordinates.col(new_node[n]) = old.coordinates.col(n);
    parts.node_ids[new_node[n]] = mesh.node_id({n});
  }
  parts.element_ids.resize(mesh.n_elements());
  std::vector<std::uint32_t> new_element(mesh.n_elements());
  for (std::size_t b = 0; b < parts.blocks.size(); ++b) {
    const ElementBlock& from = mesh.blocks()[b];
    ElementBlock& to = parts.blocks[b];
    const auto order = random_order(from.n_elements, random);
    for (std::uint32_t i = 0; i < from.n_elements; ++i) {
      new_element[from.first_element.value + i] = from.first_element.value + order[i];
      parts.element_ids[from.first_element.value + order[i]] =
          mesh.element_id({from.first_element.value + i});
      const auto nodes = from.element_nodes(i);
      const auto width = static_cast<std::uint32_t>(nodes.size());
      for (std::uint32_t k = 0; k < width; ++k) to.nodes[order[i] * width + k] = {new_node[nodes[k].value]};
    }
  }
  for (SideSet& set : parts.side_sets) {
    for (ElementSide& side : set.sides) side = ElementSide({new_element[side.element().value]}, side.side());
    std::shuffle(set.sides.begin(), set.sides.end(), random);
  }
  for (NodeSet& set : parts.node_sets) {
    for (NodeIndex& node : set.nodes) node = {new_node[node.value]};
    std::shuffle(set.nodes.begin(), set.nodes.end(), random);
  }
  return parts;
}

/// The mesh as if its dead elements had never been; ids stay with the others.
Mesh without_dead(const Mesh& mesh, const MeshParts& old, const std::vector<std::uint8_t>& alive) {
  MeshParts parts = old;
  parts.element_ids.clear();
  std::vector<std::uint32_t> new_element(mesh.n_elements());
  for (std::size_t b = 0; b < parts.blocks.size(); ++b) {
    ElementBlock& block = parts.blocks[b];
    const ElementBlock& from = mesh.blocks()[b];
    block.nodes.clear();
    block.n_elements = 0;
    for (std::uint32_t i = 0; i < from.n_elements; ++i) {
      const ElementIndex element{from.first_element.value + i};
      if (!alive[element.value]) continue;
      new_element[element.value] = static_cast<std::uint32_t>(parts.element_ids.size());
      parts.element_ids.push_back(mesh.element_id(element));
      const auto nodes = from.element_nodes(i);
      block.nodes.insert(block.nodes.end(), nodes.begin(), nodes.end());
      ++block.n_elements;
    }
  }
  for (SideSet& set : parts.side_sets) {
    std::erase_if(set.sides, [&](ElementSide side) { return !alive[side.element().value]; });
    for (ElementSide& side : set.sides) side = ElementSide({new_element[side.element().value]}, side.side());
  }
  return Mesh(parts);
}

}  // namespace

TEST_CASE("the order of nodes and elements does not change who owns what", "[contact][properties]") {
  Random random(3);
  for (int round = 0; round < 20; ++round) {
    MeshBuilder b = random_mesh_or_blocking(random);
    const Mesh mesh = b.build();
    const Mesh other(renumbered(mesh, b.parts(), random));
    const std::string lines =
        join(random_lines(random)) + "restrict contact to subdomain defined by radius 3.3 and point 0 0 0\n";
    CHECK(describe_sorted(other, resolve(other, lines)) == describe_sorted(mesh, resolve(mesh, lines)));
  }
}

TEST_CASE("commands that make no surface may stand anywhere", "[contact][properties]") {
  Random random(4);
  const Mesh mesh = random_mesh_or_blocking(random).build();
  const auto lines = random_lines(random);
  const std::string expected = describe(mesh, resolve(mesh, join(lines)));
  const std::vector<std::string> others{
      "begin constant friction model slippery\n friction coefficient = 0.1\nend\n",
      "begin interaction defaults\n general contact = on\nend\n", "search = dash\n",
      "begin surface options\n beam radius = 0.1\nend\n", "compute contact variables = on\n"};
  for (int round = 0; round < 10; ++round) {
    std::vector<std::string> mixed = lines;
    for (const std::string& other : others) {
      const auto at = static_cast<std::ptrdiff_t>(random() % (mixed.size() + 1));
      mixed.insert(mixed.begin() + at, other);
    }
    CHECK(describe(mesh, resolve(mesh, join(mixed))) == expected);
  }
}

TEST_CASE("after every death ownership is that of a mesh without the dead elements",
          "[contact][properties][death]") {
  Random random(5);
  for (int round = 0; round < 6; ++round) {
    const MeshBuilder b = random_mesh_or_blocking(random);
    const Mesh mesh = b.build();
    const std::string lines =
        join(random_lines(random)) + "begin contact surface last\n include all blocks\nend\n";
    std::vector<std::uint8_t> alive(mesh.n_elements(), 1);
    for (const std::uint32_t dying : random_order(mesh.n_elements(), random)) {
      alive[dying] = 0;
      const Mesh fresh = without_dead(mesh, b.parts(), alive);
      const auto now = resolve(mesh, lines, alive);
      const auto expected = resolve(fresh, lines);
      REQUIRE(describe(mesh, now) == describe(fresh, expected));
      REQUIRE(list_warnings(now) == list_warnings(expected));
      REQUIRE(now.interior_faces_ignored == expected.interior_faces_ignored);
    }
  }
}

TEST_CASE("ownership does not depend on the number of threads", "[contact][properties]") {
  Random random(6);
  const Mesh mesh = random_mesh_or_blocking(random).build();
  const std::string lines = join(random_lines(random));
  const int n_threads = omp_get_max_threads();
  omp_set_num_threads(1);
  const auto one = resolve(mesh, lines);
  for (const int n : {2, 5}) {
    omp_set_num_threads(n);
    const auto many = resolve(mesh, lines);
    CHECK(describe(mesh, many) == describe(mesh, one));
    CHECK(list_warnings(many) == list_warnings(one));
  }
  omp_set_num_threads(n_threads);
}
