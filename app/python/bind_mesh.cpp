// SPDX-License-Identifier: BSD-3-Clause
#include <pybind11/stl.h>

#include "app/python/arrays.hpp"
#include "app/python/bindings.hpp"
#include "core/mesh/mesh.hpp"
#include "io/exodus/exodus_reader.hpp"
#include "io/exodus/exodus_variables.hpp"
#include "io/exodus/results_mesh.hpp"

namespace py = pybind11;

namespace contactsim {

namespace {

using Ids = std::vector<std::int64_t>;

py::dict blocks_of(const Mesh& mesh) {
  py::dict blocks;
  for (std::uint32_t b = 0; b < mesh.blocks().size(); ++b) {
    const ElementBlock& block = mesh.blocks()[b];
    const FileOrder order = FileOrder::of_block(mesh, block);
    Ids ids;
    for (std::uint32_t place = 0; place < block.n_elements; ++place)
      ids.push_back(mesh.element_id({block.first_element.value + order.position(place)}));
    const auto n = static_cast<std::size_t>(std::max(1, block.nodes_per_element));
    std::vector<std::uint32_t> nodes;
    if (!block.nodes.empty()) {
      for (const NodeIndex node : order.to_file(std::span(block.nodes), n, 0, n))
        nodes.push_back(mesh.node_place(node));
    }
    py::dict row;
    row["type"] = block.type_name;
    row["elements"] = array_of(ids);
    row["nodes"] = table_of(nodes, n);
    blocks[py::str(mesh.name({EntityKind::block, b}))] = row;
  }
  return blocks;
}

py::dict side_sets_of(const Mesh& mesh) {
  py::dict sets;
  for (std::uint32_t s = 0; s < mesh.side_sets().size(); ++s) {
    Ids rows;
    for (const ElementSide side : mesh.side_sets()[s].sides) {
      rows.push_back(mesh.element_id(side.element()));
      rows.push_back(side.side());
    }
    sets[py::str(mesh.name({EntityKind::side_set, s}))] = table_of(rows, 2);
  }
  return sets;
}

py::dict node_sets_of(const Mesh& mesh) {
  py::dict sets;
  for (std::uint32_t s = 0; s < mesh.node_sets().size(); ++s) {
    Ids ids;
    for (const NodeIndex node : mesh.node_sets()[s].nodes) ids.push_back(mesh.node_id(node));
    sets[py::str(mesh.name({EntityKind::node_set, s}))] = array_of(ids);
  }
  return sets;
}

/// An Exodus file with what it stores at its times.
struct Results {
  Mesh mesh;
  StoredVariables stored;
};

/// Reads a variable, or its components as columns, at the position of a time; < 0 counts from the last.
py::array_t<double> read(const StoredVariables& stored, const StoredVariableKind& kind,
                         const std::string& name, py::ssize_t time) {
  const auto n_times = static_cast<py::ssize_t>(stored.times.size());
  if (time < -n_times || time >= n_times)
    throw py::index_error("there are " + std::to_string(n_times) + " times");
  const auto at = static_cast<std::size_t>(time < 0 ? time + n_times : time);
  for (const std::size_t n_components : {1, 3, 6}) {
    const auto found = find_stored(kind, name, n_components);
    if (!found) continue;
    if (n_components == 1) return array_of(kind.read(found->front(), at));
    py::list columns;
    for (const std::size_t variable : *found) columns.append(array_of(kind.read(variable, at)));
    return py::module_::import("numpy").attr("column_stack")(columns);
  }
  throw py::key_error(name);
}

}  // namespace

void bind_mesh(py::module_& module) {
  py::class_<Mesh>(module, "Mesh", "Nodes, element blocks and sets, in the order of the file; immutable")
      .def_property_readonly("n_nodes", &Mesh::n_nodes)
      .def_property_readonly("n_elements", &Mesh::n_elements)
      .def_property_readonly(
          "coordinates", [](const Mesh& mesh) { return rows_of(mesh, mesh.coordinates()); },
          "[n_nodes, 3] [length]")
      .def_property_readonly(
          "node_ids", [](const Mesh& mesh) { return array_of(make_node_map(mesh)); }, "of the file, from 1")
      .def_property_readonly("blocks", &blocks_of,
                             "by name: type, elements (ids), nodes (positions from 0, a row per element)")
      .def_property_readonly("side_sets", &side_sets_of, "by name: rows of element id and side from 1")
      .def_property_readonly("node_sets", &node_sets_of, "by name: node ids");
  module.def(
      "read_mesh",
      [](const std::string& path) {
        Diagnostics discarded;
        return read_mesh(path, discarded);
      },
      py::arg("path"), "Reads an Exodus mesh. Raises FileError");
}

void bind_results(py::module_& module) {
  py::class_<Results>(module, "Results", "What an Exodus file stores at its times")
      .def(py::init([](const std::string& path) {
             Diagnostics discarded;
             Mesh mesh = read_mesh(path, discarded);
             StoredVariables stored = read_stored_variables(path, mesh);
             return Results{std::move(mesh), std::move(stored)};
           }),
           py::arg("path"), "Opens a file. Raises FileError")
      .def_readonly("mesh", &Results::mesh)
      .def_property_readonly("times", [](const Results& results) { return array_of(results.stored.times); })
      .def_property_readonly("nodal_names", [](const Results& results) { return results.stored.nodal.names; })
      .def_property_readonly("element_names",
                             [](const Results& results) { return results.stored.element.names; })
      .def(
          "nodal",
          [](const Results& results, const std::string& name, py::ssize_t time) {
            return read(results.stored, results.stored.nodal, name, time);
          },
          py::arg("name"), py::arg("time") = -1,
          "Values at the nodes, [n_nodes] or [n_nodes, 3]; time is a position in times. Raises KeyError")
      .def(
          "element",
          [](const Results& results, const std::string& name, py::ssize_t time) {
            return read(results.stored, results.stored.element, name, time);
          },
          py::arg("name"), py::arg("time") = -1,
          "Values of the elements in the order of blocks, NaN where a block does not have the variable");
}

}  // namespace contactsim
