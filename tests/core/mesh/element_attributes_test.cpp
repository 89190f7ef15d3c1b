// SPDX-License-Identifier: BSD-3-Clause
#include "core/mesh/element_attributes.hpp"

#include "support/catch.hpp"

using namespace contactsim;

namespace {

/// Two elements with these attributes, 1 2 3 ... in the order of the file.
ElementBlock block_with(Shape shape, const std::vector<std::string>& names) {
  ElementBlock block;
  block.shape = shape;
  block.n_elements = 2;
  block.nodes_per_element = shape == Shape::shell4 ? 4 : shape == Shape::shell3 ? 3 : 2;
  block.attribute_names = names;
  for (std::size_t i = 1; i <= 2 * names.size(); ++i) block.attributes.push_back(static_cast<double>(i));
  return block;
}

}  // namespace

TEST_CASE("attributes are found by name without case, the first of a name", "[core][mesh]") {
  const ElementBlock block = block_with(Shape::beam2, {"Area", "", "AREA", "i1"});
  CHECK(has_attribute_names(block));
  CHECK(find_named_attribute(block, 0, "area") == 1.0);
  CHECK(find_named_attribute(block, 1, "I1") == 8.0);
  CHECK_FALSE(find_named_attribute(block, 0, "thickness"));
  CHECK_FALSE(has_attribute_names(block_with(Shape::beam2, {"", ""})));
  CHECK_FALSE(has_attribute_names(block_with(Shape::beam2, {})));
}

TEST_CASE("without the usual name the first column counts, of shells the mean of their nodes",
          "[core][mesh]") {
  CHECK(find_usual_attribute(block_with(Shape::beam2, {"i1", "area"}), 1, "area") == 4.0);
  CHECK(find_usual_attribute(block_with(Shape::beam2, {"", ""}), 1, "area") == 3.0);
  CHECK(find_usual_attribute(block_with(Shape::shell4, {"", "", "", ""}), 1, "thickness") == 6.5);
  CHECK(find_usual_attribute(block_with(Shape::shell3, {"a", "b", "c"}), 0, "thickness") == 2.0);
  CHECK(find_usual_attribute(block_with(Shape::shell4, {"a", "thickness", "b", "c"}), 0, "thickness") == 2.0);
  CHECK(find_usual_attribute(block_with(Shape::shell4, {"", "", ""}), 1, "thickness") ==
        4.0);                                                                         // not one a node
  CHECK(find_usual_attribute(block_with(Shape::beam2, {"", ""}), 0, "area") == 1.0);  // nor of a line
  CHECK_FALSE(find_usual_attribute(block_with(Shape::beam2, {}), 0, "area"));
}
