// SPDX-License-Identifier: BSD-3-Clause
#include "io/exodus/results_mesh.hpp"

#include <fmt/format.h>

#include <array>
#include <memory>
#include <string_view>

#include "io/exodus/exodus_conventions.hpp"
#include "io/exodus/file_order.hpp"

namespace contactsim {

namespace {

void add_nodes(const Mesh& mesh, ExodusDraft& draft) {
  constexpr std::array<const char*, 3> names{"coordx", "coordy", "coordz"};
  const int n_axes = draft.add_dimension("num_dim", 3);
  draft.add_texts("coor_names", {n_axes}, "len_name", {"x", "y", "z"});
  // A dimension of length 0 would be the record dimension.
  if (mesh.n_nodes() == 0) return;
  const int n_nodes = draft.add_dimension("num_nodes", mesh.n_nodes());
  const auto order = std::make_shared<const FileOrder>(FileOrder::of_nodes(mesh));
  for (std::size_t axis = 0; axis < 3; ++axis) {
    draft.add_reals(names[axis], {n_nodes}, [&mesh, order, axis] {
      const Eigen::Matrix3Xd& x = mesh.coordinates();
      return order->to_file(std::span(x.data(), static_cast<std::size_t>(x.size())), 3, axis, 1);
    });
  }
  if (is_counting<std::int64_t>(make_node_map(mesh))) return;
  draft.add_ids("node_num_map", n_nodes, [&mesh] { return make_node_map(mesh); });
}

void add_attributes(const Mesh& mesh, const ElementBlock& block, const std::string& number, int n_elements,
                    ExodusDraft& draft) {
  if (block.attribute_names.empty()) return;
  const int n_attributes = draft.add_dimension("num_att_in_blk" + number, block.attribute_names.size());
  draft.add_reals("attrib" + number, {n_elements, n_attributes}, [&mesh, &block] {
    const std::size_t n = block.attribute_names.size();
    return FileOrder::of_block(mesh, block).to_file(std::span(block.attributes), n, 0, n);
  });
  draft.add_texts("attrib_name" + number, {n_attributes}, "len_name", block.attribute_names);
}

void add_block(const Mesh& mesh, const ElementBlock& block, const std::string& number, ExodusDraft& draft) {
  if (block.n_elements == 0) return;
  const int n_elements = draft.add_dimension("num_el_in_blk" + number, block.n_elements);
  const int n_columns =
      draft.add_dimension("num_nod_per_el" + number, static_cast<std::size_t>(block.nodes_per_element));
  const int connectivity = draft.add_integers("connect" + number, {n_elements, n_columns}, [&mesh, &block] {
    const auto n = static_cast<std::size_t>(block.nodes_per_element);
    std::vector<std::int32_t> numbers;
    numbers.reserve(block.nodes.size());
    for (const NodeIndex node : FileOrder::of_block(mesh, block).to_file(std::span(block.nodes), n, 0, n))
      numbers.push_back(static_cast<std::int32_t>(mesh.node_place(node)) + 1);
    return numbers;
  });
  draft.file().set_text(connectivity, "elem_type", std::string(topology(block.shape).name));
  add_attributes(mesh, block, number, n_elements, draft);
}

}  // namespace

std::vector<std::int64_t> make_node_map(const Mesh& mesh) {
  std::vector<std::int64_t> ids(mesh.n_nodes());
  for (std::uint32_t n = 0; n < mesh.n_nodes(); ++n) ids[mesh.node_place({n})] = mesh.node_id({n});
  return ids;
}

std::vector<std::int64_t> make_element_map(const Mesh& mesh) {
  std::vector<std::int64_t> ids(mesh.n_elements());
  for (std::uint32_t e = 0; e < mesh.n_elements(); ++e) ids[mesh.element_place({e})] = mesh.element_id({e});
  return ids;
}

void add_mesh(const Mesh& mesh, ExodusDraft& draft) {
  add_nodes(mesh, draft);
  if (mesh.n_elements() > 0) {
    const int n_elements = draft.add_dimension("num_elem", mesh.n_elements());
    if (!is_counting<std::int64_t>(make_element_map(mesh))) {
      draft.add_ids("elem_num_map", n_elements, [&mesh] { return make_element_map(mesh); });
    }
  }
  IdRows rows;
  for (std::uint32_t b = 0; b < mesh.blocks().size(); ++b) {
    const ElementBlock& block = mesh.blocks()[b];
    rows.ids.push_back(block.id);
    rows.status.push_back(block.n_elements > 0 ? 1 : 0);
    rows.names.push_back(mesh.name({EntityKind::block, b}));
    add_block(mesh, block, fmt::to_string(b + 1), draft);
  }
  draft.add_id_rows("num_el_blk", "eb", rows);
}

}  // namespace contactsim
