// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace contactsim {

/// Where the values of an output field live.
enum class FieldLocation : std::uint8_t { node, element, global };

/// "nodal", "element", "global".
std::string_view to_string(FieldLocation location);

/// A result as it goes to a file: a view of its values at one time.
struct OutputField {
  std::string name;  ///< on the file, without components: "velocity"
  FieldLocation location = FieldLocation::node;
  int n_components = 1;     ///< 1, 3 for vectors, 6 for symmetric tensors in the order xx yy zz xy yz zx, ...
  std::uint32_t block = 0;  ///< position in the mesh of the block of an element field, else 0
  std::span<const double>
      values;  ///< n_entities x n_components, entity by entity; of a global 1 x n_components
};

/// The name of one component on a file, so that readers join what belongs together: 3 components end in _x _y
/// _z, 6 in _xx _yy _zz _xy _yz _zx, 9 in these and _yx _zy _xz, other numbers in _1 _2 ..., padded with
/// zeros to one length. A scalar has no ending. Precondition: 0 <= component < n_components.
/// Source: tried with vtkExodusIIReader and vtkIOSSReader of VTK 9.1.
std::string component_name(std::string_view name, int component, int n_components);

}  // namespace contactsim
