// SPDX-License-Identifier: BSD-3-Clause
#include "core/mesh/topology.hpp"

#include <algorithm>
#include <string>

#include "core/mesh/side_tables.hpp"

namespace contactsim {

using namespace side_tables;

namespace {

constexpr std::array table{
    Topology{Shape::hex8, "HEX8", Family::solid, 8, 8, hex_sides},
    Topology{Shape::hex20, "HEX20", Family::solid, 20, 8, hex_sides},
    Topology{Shape::hex27, "HEX27", Family::solid, 27, 8, hex_sides},
    Topology{Shape::tet4, "TETRA4", Family::solid, 4, 4, tet_sides},
    Topology{Shape::tet10, "TETRA10", Family::solid, 10, 4, tet_sides, tet10_faces},
    Topology{Shape::wedge6, "WEDGE6", Family::solid, 6, 6, wedge_sides},
    Topology{Shape::wedge15, "WEDGE15", Family::solid, 15, 6, wedge_sides},
    Topology{Shape::pyramid5, "PYRAMID5", Family::solid, 5, 5, pyramid_sides},
    Topology{Shape::pyramid13, "PYRAMID13", Family::solid, 13, 5, pyramid_sides},
    Topology{Shape::shell4, "SHELL4", Family::shell, 4, 4, shell_quad_sides},
    Topology{Shape::shell8, "SHELL8", Family::shell, 8, 4, shell_quad_sides},
    Topology{Shape::shell9, "SHELL9", Family::shell, 9, 4, shell_quad_sides},
    Topology{Shape::shell3, "SHELL3", Family::shell, 3, 3, shell_tri_sides},
    Topology{Shape::shell6, "SHELL6", Family::shell, 6, 3, shell_tri_sides},
    Topology{Shape::quad4, "QUAD4", Family::shell, 4, 4, quad_sides},
    Topology{Shape::quad8, "QUAD8", Family::shell, 8, 4, quad_sides},
    Topology{Shape::quad9, "QUAD9", Family::shell, 9, 4, quad_sides},
    Topology{Shape::bar2, "BAR2", Family::line, 2, 2, bar_sides},
    Topology{Shape::bar3, "BAR3", Family::line, 3, 2, bar_sides},
    Topology{Shape::beam2, "BEAM2", Family::line, 2, 2, beam_sides},
    Topology{Shape::beam3, "BEAM3", Family::line, 3, 2, beam_sides},
    Topology{Shape::sphere, "SPHERE", Family::particle, 1, 1, sphere_sides},
    Topology{Shape::cohesive8, "HEX8", Family::cohesive, 8, 8, hex_sides},
    Topology{Shape::cohesive6, "WEDGE6", Family::cohesive, 6, 6, wedge_sides},
    Topology{Shape::null, "NULL", Family::none, 0, 0, {}},
    Topology{Shape::unknown, "UNKNOWN", Family::none, 0, 0, {}},
};

constexpr bool rows_stand_in_order() {
  for (std::size_t i = 0; i < table.size(); ++i) {
    if (table[i].shape != static_cast<Shape>(i)) return false;
  }
  return table.back().shape == Shape::unknown;
}
static_assert(rows_stand_in_order());

// The Exodus library tells types apart by their first three letters; every spelling seen obeys that.
struct TypeName {
  std::string_view letters;
  Shape shape;
};

constexpr std::array type_names{
    TypeName{"HEX", Shape::hex8},    TypeName{"HEX", Shape::hex20},     TypeName{"HEX", Shape::hex27},
    TypeName{"TET", Shape::tet4},    TypeName{"TET", Shape::tet10},     TypeName{"WED", Shape::wedge6},
    TypeName{"WED", Shape::wedge15}, TypeName{"PRI", Shape::wedge6},    TypeName{"PRI", Shape::wedge15},
    TypeName{"PEN", Shape::wedge6},  TypeName{"PEN", Shape::wedge15},   TypeName{"PYR", Shape::pyramid5},
    TypeName{"SHE", Shape::shell4},  TypeName{"PYR", Shape::pyramid13}, TypeName{"SHE", Shape::shell8},
    TypeName{"SHE", Shape::shell9},  TypeName{"SHE", Shape::shell3},    TypeName{"SHE", Shape::shell6},
    TypeName{"TRI", Shape::shell3},  TypeName{"TRI", Shape::shell6},    TypeName{"QUA", Shape::quad4},
    TypeName{"QUA", Shape::quad8},   TypeName{"QUA", Shape::quad9},     TypeName{"BAR", Shape::bar2},
    TypeName{"BAR", Shape::bar3},    TypeName{"TRU", Shape::bar2},      TypeName{"TRU", Shape::bar3},
    TypeName{"EDG", Shape::bar2},    TypeName{"EDG", Shape::bar3},      TypeName{"ROD", Shape::bar2},
    TypeName{"ROD", Shape::bar3},    TypeName{"LIN", Shape::bar2},      TypeName{"LIN", Shape::bar3},
    TypeName{"BEA", Shape::beam2},   TypeName{"BEA", Shape::beam3},     TypeName{"SPH", Shape::sphere},
    TypeName{"CIR", Shape::sphere},  TypeName{"POI", Shape::sphere},    TypeName{"PAR", Shape::sphere},
    TypeName{"NUL", Shape::null},
};

std::string first_letters(std::string_view type_name) {
  std::string letters;
  for (char c : type_name) {
    if (c == ' ' || c == '\0' || c == '\t') continue;
    letters += c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  }
  return letters.substr(0, 3);
}

}  // namespace

const Topology& topology(Shape shape) { return table[static_cast<std::size_t>(shape)]; }

Shape find_shape(std::string_view type_name, int n_nodes_per_element) {
  const std::string letters = first_letters(type_name);
  const auto fits = [&](const TypeName& row) {
    return row.letters == letters && topology(row.shape).n_nodes == n_nodes_per_element;
  };
  const auto found = std::find_if(type_names.begin(), type_names.end(), fits);
  return found == type_names.end() ? Shape::unknown : found->shape;
}

}  // namespace contactsim
