// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "core/elements/element_table.hpp"
#include "core/materials/elastic.hpp"
#include "core/materials/linear_hardening.hpp"
#include "support/condition_deck.hpp"
#include "support/mesh_builder.hpp"

namespace contactsim::test {

/// A plastic block of 9 hexahedra, more than a batch, and an elastic one.
inline const Mesh& two_rows() {
  static const Mesh mesh = MeshBuilder()
                               .add_hexes({.id = 1, .cells = {9, 1, 1}, .size = {9, 1, 1}})
                               .add_hexes({.id = 2, .origin = {0, 5, 0}})
                               .build();
  return mesh;
}

inline std::vector<ModelBlock> blocks_of_two_rows() {
  const ElementFormulation& element = *find_solid_element(Shape::hex8, "mean_quadrature");
  ElementProperties plastic, elastic;
  plastic.law = PlasticLaw<LinearHardening>{};
  elastic.law = ElasticLaw{};
  plastic.density = elastic.density = 1.0;
  std::vector<ModelBlock> blocks;
  blocks.push_back(make_solid_block(two_rows(), 0, element, plastic));
  blocks.push_back(make_solid_block(two_rows(), 1, element, elastic));
  return blocks;
}

/// A file with the times 0, 1, 3: v_x to v_z are 1, 2 and 3 times the time, p is the node's position plus
/// ten times the time; s_xx to s_zx are all the element's position, e has no value at the last element.
inline StoredVariables stored_results() {
  StoredVariables stored;
  stored.times = {0.0, 1.0, 3.0};
  stored.nodal.names = {"p", "V_X", "v_y", "v_z"};
  stored.nodal.read = [times = stored.times](std::size_t variable, std::size_t time) {
    std::vector<double> values(two_rows().n_nodes(), static_cast<double>(variable) * times[time]);
    for (std::size_t i = 0; variable == 0 && i < values.size(); ++i)
      values[i] = static_cast<double>(i) + 10.0 * times[time];
    return values;
  };
  stored.element.names = {"sxx", "syy", "szz", "sxy", "syz", "szx", "e"};
  stored.element.read = [](std::size_t variable, std::size_t) {
    std::vector<double> values(two_rows().n_elements());
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<double>(i);
    if (variable == 6) values.back() = std::nan("");
    return values;
  };
  return stored;
}

/// Lines of an INITIAL CONDITION of nodes, or elements, of a block.
inline std::string nodal(const std::string& variable) {
  return "block = block_1\nvariable type = node\ninitialize variable name = " + variable + "\n";
}

inline std::string elemental(const std::string& variable, const std::string& block = "block_1") {
  return "block = " + block + "\nvariable type = element\ninitialize variable name = " + variable + "\n";
}

}  // namespace contactsim::test
