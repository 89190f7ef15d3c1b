// SPDX-License-Identifier: BSD-3-Clause
#include "core/mesh/omit_blocks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "core/base/names.hpp"
#include "core/mesh/block_names.hpp"
#include "core/mesh/mesh_parts.hpp"

namespace contactsim {

namespace {

/// Old positions to new ones; nothing for what is gone.
class Renumbering {
 public:
  explicit Renumbering(const std::vector<std::uint8_t>& is_kept) : position_(is_kept.size()) {
    for (std::size_t i = 0; i < is_kept.size(); ++i) {
      if (is_kept[i] != 0) position_[i] = n_kept_++;
    }
  }
  std::optional<std::uint32_t> operator[](std::uint32_t old) const { return position_[old]; }
  std::uint32_t n_kept() const { return n_kept_; }

  /// Drops the items of what is gone.
  template <class Item>
  void drop(std::vector<Item>& items) const {
    std::vector<Item> kept;
    for (std::size_t i = 0; i < position_.size(); ++i) {
      if (position_[i]) kept.push_back(std::move(items[i]));
    }
    items = std::move(kept);
  }

 private:
  std::vector<std::optional<std::uint32_t>> position_;
  std::uint32_t n_kept_ = 0;
};

/// The members of a set that are left, with their distribution factors where there is one for each.
template <class Member, class Renumber>
void drop_members(std::vector<Member>& members, std::vector<double>& factors, const Renumber& renumber) {
  const bool has_factors = factors.size() == members.size();
  std::vector<Member> kept;
  std::vector<double> kept_factors;
  for (std::size_t i = 0; i < members.size(); ++i) {
    const std::optional<Member> member = renumber(members[i]);
    if (!member) continue;
    kept.push_back(*member);
    if (has_factors) kept_factors.push_back(factors[i]);
  }
  members = std::move(kept);
  factors = std::move(kept_factors);
}

/// Whether each node stays: those of other elements, and those of none.
std::vector<std::uint8_t> kept_nodes(const Mesh& mesh, const std::vector<std::uint8_t>& keeps_block) {
  std::vector<std::uint8_t> is_of_omitted(mesh.n_nodes(), 0), is_of_kept(mesh.n_nodes(), 0);
  for (std::size_t b = 0; b < keeps_block.size(); ++b) {
    for (const NodeIndex node : mesh.blocks()[b].nodes)
      (keeps_block[b] != 0 ? is_of_kept : is_of_omitted)[node.value] = 1;
  }
  std::vector<std::uint8_t> is_kept(mesh.n_nodes());
  for (std::size_t i = 0; i < is_kept.size(); ++i) is_kept[i] = is_of_kept[i] != 0 || is_of_omitted[i] == 0;
  return is_kept;
}

std::vector<std::uint8_t> kept_elements(const Mesh& mesh, const std::vector<std::uint8_t>& keeps_block) {
  std::vector<std::uint8_t> is_kept(mesh.n_elements(), 0);
  for (std::size_t b = 0; b < keeps_block.size(); ++b) {
    const ElementBlock& block = mesh.blocks()[b];
    std::fill_n(is_kept.begin() + block.first_element.value, block.n_elements, keeps_block[b]);
  }
  return is_kept;
}

void drop_nodes(const Renumbering& nodes, MeshParts& parts) {
  Eigen::Matrix3Xd coordinates(3, nodes.n_kept());
  for (std::uint32_t i = 0; i < parts.coordinates.cols(); ++i) {
    if (const auto position = nodes[i]) coordinates.col(*position) = parts.coordinates.col(i);
  }
  parts.coordinates = std::move(coordinates);
  nodes.drop(parts.node_ids);
  for (ElementBlock& block : parts.blocks) {
    for (NodeIndex& node : block.nodes) node.value = nodes[node.value].value();
  }
  for (NodeSet& set : parts.node_sets) {
    drop_members(set.nodes, set.distribution_factors, [&](NodeIndex node) -> std::optional<NodeIndex> {
      const auto position = nodes[node.value];
      return position ? std::optional(NodeIndex{*position}) : std::nullopt;
    });
  }
}

}  // namespace

Mesh without_blocks(const Mesh& mesh, std::span<const std::uint32_t> blocks) {
  std::vector<std::uint8_t> keeps_block(mesh.blocks().size(), 1);
  for (const std::uint32_t block : blocks) keeps_block[block] = 0;
  const Renumbering kept_blocks(keeps_block), nodes(kept_nodes(mesh, keeps_block)),
      elements(kept_elements(mesh, keeps_block));
  MeshParts parts = parts_of(mesh);
  parts.node_places.clear();
  parts.element_places.clear();
  kept_blocks.drop(parts.blocks);
  elements.drop(parts.element_ids);
  drop_nodes(nodes, parts);
  for (SideSet& set : parts.side_sets) {
    drop_members(set.sides, set.distribution_factors, [&](ElementSide side) -> std::optional<ElementSide> {
      const auto position = elements[side.element().value];
      return position ? std::optional(ElementSide({*position}, side.side())) : std::nullopt;
    });
  }
  for (Assembly& assembly : parts.assemblies) {
    if (assembly.member_kind != EntityKind::block) continue;
    std::vector<std::uint32_t> members;
    for (const std::uint32_t member : assembly.members) {
      if (const auto position = kept_blocks[member]) members.push_back(*position);
    }
    assembly.members = std::move(members);
  }
  return Mesh(std::move(parts));
}

Mesh omit_blocks(const FiniteElementModel& model, Mesh mesh, Diagnostics& diagnostics) {
  if (model.omitted.empty()) return mesh;
  const auto names = find_block_names(mesh, model.aliases);
  std::set<std::uint32_t> omitted;
  for (const DeckName& name : model.omitted) {
    bool is_known = false;
    for (std::uint32_t block = 0; block < names.size(); ++block) {
      const bool is_meant = std::ranges::any_of(
          names[block], [&](const std::string& own) { return fold(own) == fold(name.text); });
      is_known |= is_meant;
      if (is_meant) omitted.insert(block);
    }
    if (is_known) continue;
    std::vector<std::string> known;
    for (const auto& of_block : names) known.insert(known.end(), of_block.begin(), of_block.end());
    diagnostics.add_error(name.location, fmt::format("there is no block or assembly '{}' to omit", name.text),
                          suggest(name.text, known), static_cast<int>(name.text.size()));
  }
  if (omitted.size() == names.size()) {
    diagnostics.add_error(model.omitted.front().location, "no block of the mesh is left");
    return mesh;
  }
  return without_blocks(mesh, std::vector(omitted.begin(), omitted.end()));
}

}  // namespace contactsim
