// SPDX-License-Identifier: BSD-3-Clause
#include "io/import/inp_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <unordered_map>

#include "core/base/names.hpp"
#include "io/import/inp_elements.hpp"
#include "io/import/inp_lines.hpp"

namespace contactsim {

namespace {

using Ids = std::vector<std::int64_t>;

struct InpElement {
  const InpType* type;
  std::string elset;  ///< of its *ELEMENT line
  std::vector<NodeIndex> nodes;
};

/// A line of *SURFACE: all of an ELSET, or an element, and a face from 1.
struct InpFace {
  std::string elset_or_id;
  int face;
  int line;
};

class InpReader {
 public:
  explicit InpReader(const std::string& path) : lines_(path) { mesh_.path = path; }

  DraftMesh read() {
    InpKeyword keyword;
    while (lines_.next_keyword(keyword)) read_keyword(keyword);
    if (mesh_.coordinates.empty() || order_.empty())
      lines_.words().fail("the file has no *NODE or no *ELEMENT");
    make_groups();
    for (const auto& [name, faces] : surfaces_)
      mesh_.side_sets.push_back({name, 0, faces_of(name, faces), {}});
    for (const auto& [name, ids] : nsets_) mesh_.node_sets.push_back({name, 0, {}, nodes_of(name, ids)});
    return std::move(mesh_);
  }

 private:
  [[noreturn]] void fail(const std::string& what) const { lines_.words().fail(what); }
  std::int64_t integer(const std::string& cell) const { return integer_of(cell, lines_.words()); }

  void read_keyword(const InpKeyword& keyword) {
    const std::string& name = keyword.name;
    if (name == "NODE") {
      read_nodes(keyword.value("NSET"));
    } else if (name == "ELEMENT") {
      read_elements(keyword);
    } else if (name == "ELSET" || name == "NSET") {
      auto& sets = name == "ELSET" ? elsets_ : nsets_;
      if (keyword.value(name).empty()) fail(fmt::format("*{} has no name", name));
      read_ids(keyword.has("GENERATE"), sets, sets[fold(keyword.value(name))]);
    } else if (name == "SURFACE") {
      read_surface(keyword);
    } else if (name.ends_with("SECTION") && keyword.has("ELSET")) {
      sections_.push_back(keyword.value("ELSET"));
    } else if (name == "INSTANCE" && ++n_instances_ > 1) {
      fail(
          "several instances of parts are not read: write a flat input file (in Abaqus/CAE, "
          "model.setValues(noPartsInputFile=ON))");
    } else if (name == "INCLUDE") {
      fail(fmt::format("*INCLUDE is not followed: put the text of '{}' here", keyword.value("INPUT")));
    }
  }

  void read_nodes(const std::string& nset) {
    std::vector<std::string> cells;
    while (lines_.next_data(cells)) {
      const std::int64_t id = integer(cells[0]);
      if (cells.size() < 4)
        fail(fmt::format("node {} has {} coordinates, expected three", id, cells.size() - 1));
      if (!nodes_.emplace(id, NodeIndex{static_cast<std::uint32_t>(mesh_.coordinates.size())}).second)
        fail(fmt::format("node {} is there twice", id));
      mesh_.node_ids.push_back(id);
      mesh_.coordinates.emplace_back(real_of(cells[1], lines_.words()), real_of(cells[2], lines_.words()),
                                     real_of(cells[3], lines_.words()));
      if (!nset.empty()) nsets_[fold(nset)].push_back(id);
    }
  }

  NodeIndex node(std::int64_t id, const char* of, std::int64_t of_id) const {
    const auto found = nodes_.find(id);
    if (found == nodes_.end()) fail(fmt::format("{} {} has the node {}, which is not there", of, of_id, id));
    return found->second;
  }

  void read_elements(const InpKeyword& keyword) {
    std::string type = keyword.value("TYPE");
    std::transform(type.begin(), type.end(), type.begin(), [](unsigned char c) { return std::toupper(c); });
    const InpType* shape = find_inp_type(type);
    if (shape == nullptr) fail(fmt::format("elements of the type '{}' are not read", type));
    std::vector<std::string> cells, more;
    while (lines_.next_data(cells)) {
      while (static_cast<int>(cells.size()) < shape->n_nodes + 1 && lines_.next_data(more))
        cells.insert(cells.end(), more.begin(), more.end());
      const std::int64_t id = integer(cells[0]);
      if (static_cast<int>(cells.size()) < shape->n_nodes + 1)
        fail(fmt::format("element {} lacks nodes", id));
      InpElement element{shape, keyword.value("ELSET"), {}};
      for (int i = 1; i <= shape->n_nodes; ++i)
        element.nodes.push_back(node(integer(cells[static_cast<std::size_t>(i)]), "element", id));
      if (!elements_.emplace(id, std::move(element)).second)
        fail(fmt::format("element {} is there twice", id));
      order_.push_back(id);
      if (keyword.has("ELSET")) elsets_[fold(keyword.value("ELSET"))].push_back(id);
    }
  }

  void add_range(std::int64_t first, std::int64_t last, std::int64_t step, Ids& ids) const {
    constexpr std::int64_t max_count =
        100'000'000;  // more than meshes have; a wrong number must not fill the memory
    if (step <= 0) fail("the step of a set must be positive");
    if (first < 0 || last / step - first / step > max_count)
      fail(fmt::format("{} to {} by {} are not the ids of a set", first, last, step));
    for (std::int64_t id = first; id <= last; id += step) ids.push_back(id);
  }

  /// Adds numbers, ranges or the members of other sets.
  void read_ids(bool is_range, const std::map<std::string, Ids>& sets, Ids& ids) {
    std::vector<std::string> cells;
    while (lines_.next_data(cells)) {
      if (is_range) {
        if (cells.size() < 2) fail("expected first, last, step");
        add_range(integer(cells[0]), integer(cells[1]), cells.size() > 2 ? integer(cells[2]) : 1, ids);
        continue;
      }
      for (const std::string& cell : cells) {
        const auto other = sets.find(fold(cell));
        if (other != sets.end()) {
          const Ids members = other->second;
          ids.insert(ids.end(), members.begin(), members.end());
        } else {
          ids.push_back(integer(cell));
        }
      }
    }
  }

  void read_surface(const InpKeyword& keyword) {
    std::string kind = keyword.value("TYPE");
    if (!kind.empty() && fold(kind) != "element") {
      mesh_.passed_over.push_back(
          fmt::format("surface '{}': passed over, only TYPE=ELEMENT is read", keyword.value("NAME")));
      return;
    }
    auto& surface = surfaces_[keyword.value("NAME")];
    std::vector<std::string> cells;
    while (lines_.next_data(cells)) {
      const bool is_face =
          cells.size() > 1 && cells[1].size() == 2 && (cells[1][0] == 'S' || cells[1][0] == 's');
      if (!is_face || cells[1][1] < '1' || cells[1][1] > '6')
        fail("expected an element or an ELSET and a face S1 to S6; sides of shells are their own block");
      surface.push_back({cells[0], cells[1][1] - '0', lines_.words().line_number()});
    }
  }

  Ids members(const std::string& elset_or_id) const {
    const auto set = elsets_.find(fold(elset_or_id));
    return set != elsets_.end() ? set->second : Ids{integer(elset_or_id)};
  }

  std::vector<DraftFace> faces_of(const std::string& name, const std::vector<InpFace>& rows) const {
    std::vector<DraftFace> faces;
    for (const InpFace& row : rows) {
      for (const std::int64_t id : members(row.elset_or_id)) {
        const auto element = elements_.find(id);
        if (element == elements_.end())
          fail(fmt::format("*SURFACE {} at line {}: there is no element {}", name, row.line, id));
        const auto sides = inp_faces(element->second.type->shape);
        if (row.face > static_cast<int>(sides.size()))
          fail(fmt::format("*SURFACE {} at line {}: element {} has no face S{}", name, row.line, id,
                           row.face));
        DraftFace face;
        const std::vector<int>& corners = sides[static_cast<std::size_t>(row.face - 1)];
        for (std::size_t i = 0; i < 4; ++i)
          face[i] = element->second.nodes[static_cast<std::size_t>(corners[std::min(i, corners.size() - 1)])];
        faces.push_back(face);
      }
    }
    return faces;
  }

  std::vector<NodeIndex> nodes_of(const std::string& name, const Ids& ids) const {
    std::vector<NodeIndex> found;
    for (const std::int64_t id : ids) {
      const auto at = nodes_.find(id);
      if (at == nodes_.end()) fail(fmt::format("*NSET {}: there is no node {}", name, id));
      found.push_back(at->second);
    }
    return found;
  }

  /// The set that makes an element's block: that of the first section that has it, else that of its *ELEMENT
  /// line.
  std::unordered_map<std::int64_t, std::string> blocks_of_elements() const {
    std::unordered_map<std::int64_t, std::string> blocks;
    for (const std::string& section : sections_) {
      for (const std::int64_t id : members(section)) blocks.try_emplace(id, section);
    }
    return blocks;
  }

  void make_groups() {
    const auto blocks = blocks_of_elements();
    std::map<std::pair<std::string, Shape>, std::size_t> positions;
    for (const std::int64_t id : order_) {
      const InpElement& element = elements_.at(id);
      const auto block = blocks.find(id);
      const std::string& name = block == blocks.end() ? element.elset : block->second;
      const auto [place, is_new] = positions.try_emplace({name, element.type->shape}, mesh_.groups.size());
      if (is_new) mesh_.groups.push_back({name, 0, element.type->dimension, element.type->shape, {}, {}});
      DraftGroup& group = mesh_.groups[place->second];
      group.elements.push_back(id);
      group.nodes.insert(group.nodes.end(), element.nodes.begin(), element.nodes.end());
    }
    note_unused_sets();
  }

  void note_unused_sets() {
    std::set<std::string> used;
    for (const DraftGroup& group : mesh_.groups) used.insert(fold(group.name));
    for (const auto& [surface, faces] : surfaces_) {
      for (const InpFace& face : faces) used.insert(fold(face.elset_or_id));
    }
    for (const auto& [name, ids] : elsets_) {
      if (!used.contains(name))
        mesh_.passed_over.push_back(
            fmt::format("ELSET '{}': passed over, its elements are of other blocks", name));
    }
  }

  InpLines lines_;
  DraftMesh mesh_;
  int n_instances_ = 0;
  std::unordered_map<std::int64_t, NodeIndex> nodes_;  ///< looked up only, as is elements_
  std::unordered_map<std::int64_t, InpElement> elements_;
  Ids order_;                                  ///< of elements in the file
  std::map<std::string, Ids> elsets_, nsets_;  ///< by folded name
  std::map<std::string, std::vector<InpFace>> surfaces_;
  std::vector<std::string> sections_;
};

}  // namespace

DraftMesh read_inp(const std::string& path) { return InpReader(path).read(); }

}  // namespace contactsim
