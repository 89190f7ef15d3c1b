// SPDX-License-Identifier: BSD-3-Clause
#include "io/import/make_mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "core/base/errors.hpp"
#include "core/base/names.hpp"
#include "core/base/pluralize.hpp"
#include "io/import/solid_faces.hpp"

namespace contactsim {

namespace {

/// Gives ids: the one wished for if it is free, else the next free one.
class FreeIds {
 public:
  std::int64_t take(std::int64_t wished) {
    std::int64_t id = wished > 0 && !taken_.contains(wished) ? wished : 1;
    while (taken_.contains(id)) ++id;
    taken_.insert(id);
    return id;
  }

 private:
  std::set<std::int64_t> taken_;
};

std::size_t nodes_per_element(const DraftGroup& group) {
  return group.elements.empty() ? 0 : group.nodes.size() / group.elements.size();
}

DraftFace face_of(const DraftGroup& group, std::size_t element) {
  const std::size_t n = nodes_per_element(group);
  DraftFace face;
  for (std::size_t c = 0; c < 4; ++c) face[c] = group.nodes[element * n + std::min(c, n - 1)];
  return face;
}

std::string called_as(const DraftGroup& group) {
  constexpr const char* words[] = {"points", "lines", "surface", "volume"};
  const std::string name = group.name.empty() ? std::to_string(group.id) : fmt::format("'{}'", group.name);
  return fmt::format("{} {}", words[group.dimension], name);
}

class MeshMaker {
 public:
  explicit MeshMaker(const DraftMesh& draft) : draft_(draft) {}

  MadeMesh make() {
    add_blocks_of(3);
    const SolidFaces faces(parts_.blocks);
    add_surfaces(faces);
    add_lines_and_points();
    for (const DraftSet& set : draft_.side_sets) add_side_set(set.name, set.id, sides_of(set, faces));
    for (const DraftSet& set : draft_.node_sets) add_node_set(set.name, set.id, set.nodes);
    if (parts_.blocks.empty()) throw FileError(draft_.path, "no group of elements is a block");
    parts_.path = draft_.path;
    notes_.insert(notes_.end(), draft_.passed_over.begin(), draft_.passed_over.end());
    drop_unused_nodes();
    return {Mesh(std::move(parts_)), std::move(notes_)};
  }

 private:
  /// A name for another shape of a group, or for a group of a name that is taken.
  std::string free_block_name(const DraftGroup& group) {
    if (group.name.empty()) return "";
    std::string name = group.name;
    if (block_names_.contains(fold(name))) name += "_" + fold(topology(group.shape).name);
    const std::string with_shape = name;
    for (int n = 2; !block_names_.insert(fold(name)).second; ++n) name = fmt::format("{}_{}", with_shape, n);
    return name;
  }

  void add_block(const DraftGroup& group) {
    ElementBlock block;
    block.id = block_ids_.take(group.id);
    block.name = free_block_name(group);
    block.shape = group.shape;
    block.type_name = topology(group.shape).name;
    block.n_elements = static_cast<std::uint32_t>(group.elements.size());
    block.nodes_per_element = static_cast<int>(nodes_per_element(group));
    block.nodes = group.nodes;
    parts_.element_ids.insert(parts_.element_ids.end(), group.elements.begin(), group.elements.end());
    meshed_.insert(group.nodes.begin(), group.nodes.end());
    notes_.push_back(fmt::format("{}: block {} of {}, {}", called_as(group), block.id, block.type_name,
                                 pluralize(group.elements.size(), "element")));
    parts_.blocks.push_back(std::move(block));
  }

  void add_blocks_of(int dimension) {
    for (const DraftGroup& group : draft_.groups) {
      if (group.dimension == dimension) add_block(group);
    }
  }

  /// All groups of one name and dimension: a surface may have triangles and quadrilaterals.
  std::map<std::pair<std::string, std::int64_t>, std::vector<const DraftGroup*>> groups_of(
      int dimension) const {
    std::map<std::pair<std::string, std::int64_t>, std::vector<const DraftGroup*>> groups;
    for (const DraftGroup& group : draft_.groups) {
      if (group.dimension == dimension) groups[{group.name, group.id}].push_back(&group);
    }
    return groups;
  }

  void add_surfaces(const SolidFaces& faces) {
    for (const auto& [name, groups] : groups_of(2)) {
      std::vector<ElementSide> sides;
      std::size_t n = 0;
      for (const DraftGroup* group : groups) {
        for (std::size_t i = 0; i < group->elements.size(); ++i, ++n) {
          if (const auto side = faces.find(face_of(*group, i))) sides.push_back(*side);
        }
      }
      if (sides.size() == n) {
        notes_.push_back(called_as(*groups[0]) + add_side_set(name.first, name.second, std::move(sides)));
      } else if (sides.empty()) {
        for (const DraftGroup* group : groups) add_shells(*group);
      } else {
        throw FileError(
            draft_.path,
            fmt::format("{}: {} of {} faces lie on solids, so that it is neither a side set nor a "
                        "block of shells: make two groups of it",
                        called_as(*groups[0]), sides.size(), n));
      }
    }
  }

  void add_shells(const DraftGroup& group) {
    if (group.shape == Shape::unknown)
      throw FileError(draft_.path,
                      called_as(group) + ": shells of second order are not read (Mesh.ElementOrder = 1)");
    add_block(group);
  }

  void add_lines_and_points() {
    for (const int dimension : {1, 0}) {
      for (const auto& [name, groups] : groups_of(dimension)) {
        std::vector<NodeIndex> nodes;
        for (const DraftGroup* group : groups)
          nodes.insert(nodes.end(), group->nodes.begin(), group->nodes.end());
        if (std::all_of(nodes.begin(), nodes.end(), [&](NodeIndex node) { return meshed_.contains(node); })) {
          notes_.push_back(called_as(*groups[0]) + add_node_set(name.first, name.second, std::move(nodes)));
        } else {
          for (const DraftGroup* group : groups) add_shells(*group);
        }
      }
    }
  }

  std::vector<ElementSide> sides_of(const DraftSet& set, const SolidFaces& faces) const {
    std::vector<ElementSide> sides;
    for (const DraftFace& face : set.faces) {
      const auto side = faces.find(face);
      if (!side)
        throw FileError(draft_.path, fmt::format("surface '{}' has a face that no solid has", set.name));
      sides.push_back(*side);
    }
    return sides;
  }

  /// Returns what to say of it.
  std::string add_side_set(const std::string& name, std::int64_t id, std::vector<ElementSide> sides) {
    SideSet set{side_set_ids_.take(id), name, std::move(sides), {}};
    const std::string note = fmt::format(": side set {}, {}", set.id, pluralize(set.sides.size(), "side"));
    parts_.side_sets.push_back(std::move(set));
    return note;
  }

  std::string add_node_set(const std::string& name, std::int64_t id, std::vector<NodeIndex> nodes) {
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    NodeSet set{node_set_ids_.take(id), name, std::move(nodes), {}};
    const std::string note = fmt::format(": node set {}, {}", set.id, pluralize(set.nodes.size(), "node"));
    parts_.node_sets.push_back(std::move(set));
    return note;
  }

  void drop_unused_nodes() {
    for (NodeSet& set : parts_.node_sets)
      std::erase_if(set.nodes, [&](NodeIndex node) { return !meshed_.contains(node); });
    std::vector<std::uint32_t> position(draft_.coordinates.size());
    parts_.coordinates.resize(3, static_cast<Eigen::Index>(meshed_.size()));
    std::uint32_t n = 0;
    for (const NodeIndex node : meshed_) {
      parts_.coordinates.col(n) = draft_.coordinates[node.value];
      parts_.node_ids.push_back(draft_.node_ids[node.value]);
      position[node.value] = n++;
    }
    for (ElementBlock& block : parts_.blocks) {
      for (NodeIndex& node : block.nodes) node.value = position[node.value];
    }
    for (NodeSet& set : parts_.node_sets) {
      for (NodeIndex& node : set.nodes) node.value = position[node.value];
    }
  }

  const DraftMesh& draft_;
  MeshParts parts_;
  std::vector<std::string> notes_;
  std::set<NodeIndex> meshed_;  ///< of elements, in the order of the file
  std::set<std::string> block_names_;
  FreeIds block_ids_, side_set_ids_, node_set_ids_;
};

}  // namespace

MadeMesh make_mesh(const DraftMesh& draft) { return MeshMaker(draft).make(); }

}  // namespace contactsim
