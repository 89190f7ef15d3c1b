// SPDX-License-Identifier: BSD-3-Clause
#include "core/mesh/output_field.hpp"

#include <vector>

#include "support/catch.hpp"

using namespace contactsim;

namespace {

using Names = std::vector<std::string>;

OutputField field(const std::string& name, FieldShape shape, int n_components) {
  OutputField made;
  made.name = name;
  made.shape = shape;
  made.n_components = n_components;
  return made;
}

Names endings(FieldShape shape, int n_components) {
  Names names;
  for (int c = 0; c < n_components; ++c) names.push_back(component_name(field("", shape, n_components), c));
  return names;
}

}  // namespace

TEST_CASE("components are named so that readers join them", "[core][mesh]") {
  CHECK(component_name(field("mass", FieldShape::scalar, 1), 0) == "mass");
  CHECK(component_name(field("displ", FieldShape::vector, 3), 2) == "displ_z");
  CHECK(endings(FieldShape::vector, 3) == Names{"_x", "_y", "_z"});
  CHECK(endings(FieldShape::symmetric_tensor, 6) == Names{"_xx", "_yy", "_zz", "_xy", "_yz", "_zx"});
  CHECK(endings(FieldShape::full_tensor, 9) ==
        Names{"_xx", "_yy", "_zz", "_xy", "_yz", "_zx", "_yx", "_zy", "_xz"});
  CHECK(endings(FieldShape::list, 3) == Names{"_1", "_2", "_3"});
}

TEST_CASE("numbered components are padded to one length", "[core][mesh]") {
  CHECK(component_name(field("q", FieldShape::list, 10), 0) == "q_01");
  CHECK(component_name(field("q", FieldShape::list, 10), 9) == "q_10");
  CHECK(component_name(field("q", FieldShape::list, 8), 6) == "q_7");
}

TEST_CASE("the separator of components can be another, or none", "[core][mesh]") {
  OutputField displ = field("displ", FieldShape::vector, 3);
  displ.separator = "";
  CHECK(component_name(displ, 0) == "displx");
  displ.separator = "-";
  CHECK(component_name(displ, 1) == "displ-y");
}
