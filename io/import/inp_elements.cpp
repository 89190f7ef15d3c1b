// SPDX-License-Identifier: BSD-3-Clause
#include "io/import/inp_elements.hpp"

#include <algorithm>
#include <array>

namespace contactsim {

namespace {

// Names with more digits stand before those that they begin with.
constexpr std::array inp_types{
    InpType{"C3D10", 10, 3, Shape::tet10},  InpType{"C3D8", 8, 3, Shape::hex8},
    InpType{"C3D6", 6, 3, Shape::wedge6},   InpType{"C3D5", 5, 3, Shape::pyramid5},
    InpType{"C3D4", 4, 3, Shape::tet4},     InpType{"COH3D8", 8, 3, Shape::hex8},
    InpType{"COH3D6", 6, 3, Shape::wedge6}, InpType{"SC8", 8, 3, Shape::hex8},
    InpType{"SC6", 6, 3, Shape::wedge6},    InpType{"S4", 4, 2, Shape::shell4},
    InpType{"S3", 3, 2, Shape::shell3},     InpType{"STRI3", 3, 2, Shape::shell3},
    InpType{"M3D4", 4, 2, Shape::shell4},   InpType{"M3D3", 3, 2, Shape::shell3},
    InpType{"R3D4", 4, 2, Shape::shell4},   InpType{"R3D3", 3, 2, Shape::shell3},
    InpType{"SFM3D4", 4, 2, Shape::shell4}, InpType{"SFM3D3", 3, 2, Shape::shell3},
    InpType{"CPS4", 4, 2, Shape::shell4},   InpType{"CPS3", 3, 2, Shape::shell3},
    InpType{"CPE4", 4, 2, Shape::shell4},   InpType{"CPE3", 3, 2, Shape::shell3},
    InpType{"B31", 2, 1, Shape::beam2},     InpType{"T3D2", 2, 1, Shape::bar2},
    InpType{"SPRINGA", 2, 1, Shape::bar2},  InpType{"DASHPOTA", 2, 1, Shape::bar2},
    InpType{"MASS", 1, 0, Shape::sphere},   InpType{"PD3D", 1, 0, Shape::sphere},
};

const std::vector<std::vector<int>> hex_faces{{0, 1, 2, 3}, {4, 7, 6, 5}, {0, 4, 5, 1},
                                              {1, 5, 6, 2}, {2, 6, 7, 3}, {3, 7, 4, 0}};
const std::vector<std::vector<int>> tet_faces{{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}};
const std::vector<std::vector<int>> wedge_faces{
    {0, 1, 2}, {3, 5, 4}, {0, 3, 4, 1}, {1, 4, 5, 2}, {2, 5, 3, 0}};
const std::vector<std::vector<int>> pyramid_faces{{0, 1, 2, 3}, {0, 4, 1}, {1, 4, 2}, {2, 4, 3}, {3, 4, 0}};

}  // namespace

const InpType* find_inp_type(std::string_view type) {
  const auto found = std::find_if(inp_types.begin(), inp_types.end(), [&](const InpType& t) {
    if (!type.starts_with(t.begins_with)) return false;
    // S4R is of S4, S45 is not.
    const std::string_view rest = type.substr(t.begins_with.size());
    return rest.empty() || rest.front() < '0' || rest.front() > '9';
  });
  return found == inp_types.end() ? nullptr : &*found;
}

std::span<const std::vector<int>> inp_faces(Shape shape) {
  switch (shape) {
    case Shape::hex8:
      return hex_faces;
    case Shape::tet4:
    case Shape::tet10:
      return tet_faces;
    case Shape::wedge6:
      return wedge_faces;
    case Shape::pyramid5:
      return pyramid_faces;
    default:
      return {};
  }
}

}  // namespace contactsim
