// SPDX-License-Identifier: BSD-3-Clause
#include "io/exodus/results_variables.hpp"

#include <optional>
#include <stdexcept>

#include "io/exodus/drafted_file.hpp"
#include "io/exodus/results_mesh.hpp"
#include "io/exodus/sample_mesh.hpp"
#include "support/catch.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

using Numbers = std::vector<double>;

/// A file of two hexahedra with fields, and what writes them.
struct TwoHexFile {
  explicit TwoHexFile(const std::vector<OutputField>& fields)
      : drafted([&](ExodusDraft& draft) {
          add_mesh(mesh, draft);
          variables.emplace(mesh, fields, draft);
        }) {}

  /// A record with the values of each field.
  void write(const std::vector<Numbers>& values) const {
    RecordFile records(drafted.path());
    records.write("time_whole", Numbers{0.0});
    for (std::size_t i = 0; i < values.size(); ++i) variables->write(i, values[i], records);
    records.end_record();
  }
  Numbers numbers(const std::string& variable) const {
    return DraftedFile::numbers(drafted.open(), variable);
  }

  Mesh mesh = two_hexes().build();
  std::optional<ResultsVariables> variables;
  DraftedFile drafted;
};

OutputField field(const std::string& name, FieldLocation location, int n_components,
                  std::uint32_t block = 0) {
  const auto shape = n_components == 3 ? FieldShape::vector : FieldShape::scalar;
  return {name, location, shape, n_components, block};
}

}  // namespace

TEST_CASE("components are variables of their own, globals places in one", "[io][results]") {
  const TwoHexFile file({field("time_step", FieldLocation::global, 1),
                         field("momentum", FieldLocation::global, 3),
                         field("pull", FieldLocation::element, 3, 1)});
  CHECK(file.variables->size() == 3);
  file.write({{9}, {1, 2, 3}, {5, 6, 7}});
  CHECK(file.numbers("vals_glo_var") == Numbers{9, 1, 2, 3});
  CHECK(file.numbers("vals_elem_var2eb2") == Numbers{6});
}

TEST_CASE("element fields of one name are one variable, where the table says", "[io][results]") {
  const TwoHexFile file({field("eqps", FieldLocation::element, 1, 1),
                         field("mass", FieldLocation::element, 1, 0),
                         field("mass", FieldLocation::element, 1, 1)});
  const NetcdfFile opened = file.drafted.open();
  CHECK(opened.read_texts(*opened.find_variable("name_elem_var")) ==
        std::vector<std::string>{"eqps", "mass"});
  CHECK(DraftedFile::numbers(opened, "elem_var_tab") == Numbers{0, 1, 1, 1});
  CHECK(opened.variable_names("vals_elem") ==
        std::vector<std::string>{"vals_elem_var1eb2", "vals_elem_var2eb1", "vals_elem_var2eb2"});
}

TEST_CASE("values of another number than the entities are our mistake", "[io][results]") {
  const TwoHexFile file({field("velocity", FieldLocation::node, 3)});
  CHECK_THROWS_AS(file.write({Numbers(12)}), std::logic_error);
  file.write({Numbers(36, 2.0)});
  CHECK(file.numbers("vals_nod_var3") == Numbers(12, 2.0));
}
