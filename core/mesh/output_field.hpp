// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace contactsim {

/// Where the values of an output field live.
enum class FieldLocation : std::uint8_t { node, element, global };

/// "nodal", "element", "global".
std::string_view to_string(FieldLocation location);

/// What the components of a field are, and with that what they are called.
enum class FieldShape : std::uint8_t { scalar, vector, symmetric_tensor, full_tensor, list };

/// A result as a file knows it; its values follow step by step, entity by entity.
struct OutputField {
  std::string name;  ///< on the file, without components: "velocity"
  FieldLocation location = FieldLocation::node;
  FieldShape shape = FieldShape::scalar;
  int n_components = 1;         ///< 1, 3, 6, 9 by the shape, any number of a list
  std::uint32_t block = 0;      ///< position in the mesh of the block of an element field, else 0
  std::string separator = "_";  ///< between the name and a component
};

/// Number of components of a shape, 1 for a list.
int component_count(FieldShape shape);

/// The ending of one component, so that readers join what belongs together: x y z of vectors, xx yy zz xy yz
/// zx of symmetric tensors, these and yx zy xz of full ones, 1 2 ... of lists, padded with zeros to one
/// length; "" of scalars. Precondition: 0 <= component < n_components.
/// Source: tried with vtkExodusIIReader and vtkIOSSReader of VTK 9.1.
std::string component_ending(FieldShape shape, int component, int n_components);

/// Name, separator, ending; the name alone without an ending.
std::string with_ending(const std::string& name, const std::string& separator, const std::string& ending);

/// The name of one component on a file: name, separator, ending. A scalar has its name alone.
std::string component_name(const OutputField& field, int component);

}  // namespace contactsim
