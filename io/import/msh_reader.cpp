// SPDX-License-Identifier: BSD-3-Clause
#include "io/import/msh_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <unordered_map>

#include "io/import/text_words.hpp"

namespace contactsim {

namespace {

/// A kind of element of Gmsh.
struct MshType {
  int number, dimension, n_nodes;
  Shape shape;  ///< unknown: only its nodes or corners count
  int n_corners;
};

// Faces and lines of second order are there to be found on solids of second order.
constexpr MshType msh_types[] = {
    {15, 0, 1, Shape::sphere, 1},  {1, 1, 2, Shape::beam2, 2},   {8, 1, 3, Shape::unknown, 2},
    {2, 2, 3, Shape::shell3, 3},   {3, 2, 4, Shape::shell4, 4},  {9, 2, 6, Shape::unknown, 3},
    {4, 3, 4, Shape::tet4, 4},     {5, 3, 8, Shape::hex8, 8},    {6, 3, 6, Shape::wedge6, 6},
    {7, 3, 5, Shape::pyramid5, 5}, {11, 3, 10, Shape::tet10, 4},
};

const MshType& find_type(std::int64_t number, const TextWords& words) {
  const auto* type = std::find_if(std::begin(msh_types), std::end(msh_types),
                                  [&](const MshType& t) { return t.number == number; });
  if (type == std::end(msh_types)) {
    words.fail(fmt::format(
        "elements of Gmsh's type {} are not read: take HEX8, TET4, TET10, WEDGE6, PYRAMID5 and their "
        "faces (Mesh.ElementOrder = 1, or 2 for tetrahedra)",
        number));
  }
  return *type;
}

/// A physical group, or an entity, by dimension and tag.
using Tag = std::pair<int, std::int64_t>;

class MshReader {
 public:
  explicit MshReader(const std::string& path) : words_(path) { mesh_.path = path; }

  DraftMesh read() {
    if (words_.is_at_end() || words_.word() != "$MeshFormat")
      words_.fail("expected $MeshFormat, as Gmsh's meshes begin");
    read_format();
    while (!words_.is_at_end()) read_section();
    if (mesh_.coordinates.empty()) words_.fail("the file has no nodes");
    return take_groups();
  }

 private:
  void read_format() {
    const std::string version(words_.word());
    if (version != "4.1" && version != "2.2")
      words_.fail(fmt::format("format {} is not read: save as 4.1 or 2.2 (gmsh -format msh41)", version));
    is_new_ = version == "4.1";
    if (words_.integer() != 0)
      words_.fail("the mesh is binary: save it in text (gmsh without -bin; Mesh.Binary = 0)");
    words_.integer();
    expect("$EndMeshFormat");
  }

  void expect(std::string_view word) {
    if (const std::string_view found = words_.word(); found != word)
      words_.fail(fmt::format("expected {}, found '{}'", word, found));
  }

  void read_section() {
    const std::string name(words_.word());
    if (!name.starts_with('$'))
      words_.fail(fmt::format("expected a section such as $Nodes, found '{}'", name));
    if (name == "$PhysicalNames") {
      read_names();
    } else if (name == "$Entities") {
      read_entities();
    } else if (name == "$Nodes") {
      is_new_ ? read_node_blocks() : read_node_list();
    } else if (name == "$Elements") {
      is_new_ ? read_element_blocks() : read_element_list();
    } else {
      while (words_.word() != "$End" + name.substr(1)) {
      }
      return;
    }
    expect("$End" + name.substr(1));
  }

  void read_names() {
    for (std::int64_t n = words_.integer(); n > 0; --n) {
      const int dimension = static_cast<int>(words_.integer());
      const std::int64_t tag = words_.integer();
      std::string_view name = words_.rest_of_line();
      if (name.size() >= 2 && name.front() == '"') name = name.substr(1, name.size() - 2);
      names_[{dimension, tag}] = name;
    }
  }

  /// What physical groups an entity belongs to.
  void read_entities() {
    std::int64_t counts[4];
    for (std::int64_t& count : counts) count = words_.integer();
    for (int dimension = 0; dimension < 4; ++dimension) {
      for (std::int64_t n = counts[dimension]; n > 0; --n) {
        const std::int64_t tag = words_.integer();
        for (int i = dimension == 0 ? 3 : 6; i > 0; --i) words_.real();
        for (std::int64_t n_groups = words_.integer(), i = 0; i < n_groups; ++i)
          groups_of_entities_[{dimension, tag}].push_back(std::abs(words_.integer()));
        for (std::int64_t n_bounds = dimension == 0 ? 0 : words_.integer(); n_bounds > 0; --n_bounds)
          words_.integer();
      }
    }
  }

  void add_node(std::int64_t id) {
    const NodeIndex index{static_cast<std::uint32_t>(mesh_.coordinates.size())};
    if (!nodes_.emplace(id, index).second) words_.fail(fmt::format("node {} is there twice", id));
    mesh_.node_ids.push_back(id);
    mesh_.coordinates.emplace_back(0, 0, 0);
  }

  void read_position(std::size_t node) {
    for (int i = 0; i < 3; ++i) mesh_.coordinates[node][i] = words_.real();
  }

  void read_node_list() {
    for (std::int64_t n = words_.integer(); n > 0; --n) {
      add_node(words_.integer());
      read_position(mesh_.coordinates.size() - 1);
    }
  }

  void read_node_blocks() {
    std::int64_t n_blocks = words_.integer();
    for (int i = 0; i < 3; ++i) words_.integer();
    for (; n_blocks > 0; --n_blocks) {
      const std::int64_t dimension = words_.integer();
      words_.integer();
      const std::int64_t n_more = words_.integer() != 0 ? dimension : 0;  // parameters on the entity
      const std::int64_t n = words_.integer();
      const std::size_t first = mesh_.coordinates.size();
      for (std::int64_t i = 0; i < n; ++i) add_node(words_.integer());
      for (std::size_t node = first; node < mesh_.coordinates.size(); ++node) {
        read_position(node);
        for (std::int64_t i = 0; i < n_more; ++i) words_.real();
      }
    }
  }

  DraftGroup& group_of(const Tag& tag, const MshType& type) {
    const auto [place, is_new] = positions_.try_emplace({tag, type.number}, mesh_.groups.size());
    if (is_new) {
      const auto name = names_.find(tag);
      mesh_.groups.push_back(
          {name == names_.end() ? "" : name->second, tag.second, type.dimension, type.shape, {}, {}});
    }
    return mesh_.groups[place->second];
  }

  /// Reads the nodes of an element into its groups.
  void read_element(std::int64_t id, const MshType& type, const std::vector<std::int64_t>& groups) {
    std::vector<NodeIndex> nodes;
    for (int i = 0; i < type.n_nodes; ++i) {
      const std::int64_t node = words_.integer();
      const auto found = nodes_.find(node);
      if (found == nodes_.end())
        words_.fail(fmt::format("element {} has the node {}, which is not there", id, node));
      nodes.push_back(found->second);
    }
    if (type.shape == Shape::tet10) std::swap(nodes[8], nodes[9]);
    if (type.shape == Shape::unknown) nodes.resize(static_cast<std::size_t>(type.n_corners));
    for (const std::int64_t group : groups) {
      DraftGroup& into = group_of({type.dimension, group}, type);
      into.elements.push_back(id);
      into.nodes.insert(into.nodes.end(), nodes.begin(), nodes.end());
    }
  }

  void read_element_list() {
    for (std::int64_t n = words_.integer(); n > 0; --n) {
      const std::int64_t id = words_.integer();
      const MshType& type = find_type(words_.integer(), words_);
      std::vector<std::int64_t> tags;
      for (std::int64_t n_tags = words_.integer(); n_tags > 0; --n_tags) tags.push_back(words_.integer());
      const std::int64_t physical = tags.empty() ? 0 : tags[0];
      has_physical_ = has_physical_ || physical != 0;
      const bool has_entity = physical == 0 && tags.size() > 1;
      read_element(id, type, {physical != 0 ? physical : has_entity ? -tags[1] : -1});
    }
  }

  void read_element_blocks() {
    std::int64_t n_blocks = words_.integer();
    for (int i = 0; i < 3; ++i) words_.integer();
    for (; n_blocks > 0; --n_blocks) {
      const int dimension = static_cast<int>(words_.integer());
      const std::int64_t entity = words_.integer();
      const MshType& type = find_type(words_.integer(), words_);
      const auto groups = groups_of_entities_.find({dimension, entity});
      const bool has_groups = groups != groups_of_entities_.end() && !groups->second.empty();
      has_physical_ = has_physical_ || has_groups;
      if (dimension == 3 && has_groups && groups->second.size() > 1) {
        words_.fail(
            fmt::format("volume {} is in the physical groups {} and {}: an element belongs to one block",
                        entity, groups->second[0], groups->second[1]));
      }
      const std::vector<std::int64_t> own = has_groups ? groups->second : std::vector{-std::abs(entity)};
      for (std::int64_t n = words_.integer(); n > 0; --n) read_element(words_.integer(), type, own);
    }
  }

  /// Physical groups alone where there are any, else the entities of the highest dimension.
  DraftMesh take_groups() {
    int highest = 0;
    for (const DraftGroup& group : mesh_.groups) highest = std::max(highest, group.dimension);
    std::erase_if(mesh_.groups,
                  [&](const DraftGroup& g) { return has_physical_ ? g.id < 0 : g.dimension < highest; });
    for (DraftGroup& group : mesh_.groups) group.id = std::abs(group.id);
    std::stable_sort(mesh_.groups.begin(), mesh_.groups.end(),
                     [](const DraftGroup& a, const DraftGroup& b) { return a.id < b.id; });
    return std::move(mesh_);
  }

  TextWords words_;
  DraftMesh mesh_;
  bool is_new_ = false, has_physical_ = false;
  std::map<Tag, std::string> names_;
  std::map<Tag, std::vector<std::int64_t>> groups_of_entities_;
  std::map<std::pair<Tag, int>, std::size_t> positions_;  ///< in mesh_.groups; entities have tags < 0
  std::unordered_map<std::int64_t, NodeIndex> nodes_;     ///< looked up only
};

}  // namespace

DraftMesh read_msh(const std::string& path) { return MshReader(path).read(); }

}  // namespace contactsim
