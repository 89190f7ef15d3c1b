// SPDX-License-Identifier: BSD-3-Clause
#include "io/exodus/exodus_variables.hpp"

#include <cmath>

#include "core/base/errors.hpp"
#include "io/exodus/sample_mesh.hpp"
#include "support/catch.hpp"
#include "support/temporary_directory.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

using Values = std::vector<double>;

/// 0, 1, 2, ...
Values count(std::size_t n) {
  Values values(n);
  for (std::size_t i = 0; i < n; ++i) values[i] = static_cast<double>(i);
  return values;
}

/// Gives the file of two_hexes the times 0.5 and 2, the nodal variables "temp" and "Vel_x" (24 numbers each,
/// the second from 100 on) and the element variable "eqps" on the upper block only.
void add_results(ExodusEditor& file, bool is_combined) {
  Values second = count(24);
  for (double& value : second) value += 100.0;
  file.add_dimension("time_step", 2).add_dimension("num_nod_var", 2).add_dimension("num_elem_var", 1);
  file.add_reals("time_whole", {"time_step"}, {0.5, 2.0});
  file.add_texts("name_nod_var", "num_nod_var", {"temp", "Vel_x"});
  file.add_texts("name_elem_var", "num_elem_var", {"eqps"});
  if (is_combined) {
    file.add_reals("vals_nod_var", {"time_step", "num_nod_var", "num_nodes"}, count(48));
  } else {
    file.add_reals("vals_nod_var1", {"time_step", "num_nodes"}, count(24));
    file.add_reals("vals_nod_var2", {"time_step", "num_nodes"}, second);
  }
  file.add_reals("vals_elem_var1eb2", {"time_step", "num_el_in_blk2"}, {7.0, 8.0});
}

/// The mesh of two_hexes in a file that `change` has worked on.
struct Stored {
  explicit Stored(const std::function<void(ExodusEditor&)>& change) : path(directory.file("m.e")) {
    write_exodus(path, mesh);
    ExodusEditor editor(path);
    change(editor);
  }

  TemporaryDirectory directory;
  std::string path;
  Mesh mesh = two_hexes().build();
};

/// How the file refuses to be read, without its path.
std::string refusal_of(const std::function<void(ExodusEditor&)>& change) {
  const Stored stored(change);
  try {
    const StoredVariables found = read_stored_variables(stored.path, stored.mesh);
    found.nodal.read(0, 1);
    found.element.read(0, 1);
  } catch (const FileError& error) {
    return std::string(error.what()).substr(stored.path.size() + 2);
  }
  return "";
}

}  // namespace

TEST_CASE("stored variables are read by name, time and block", "[io][variables]") {
  const Stored stored([](ExodusEditor& file) { add_results(file, false); });
  const StoredVariables found = read_stored_variables(stored.path, stored.mesh);
  CHECK(found.times == Values{0.5, 2.0});
  CHECK(found.nodal.names == std::vector<std::string>{"temp", "Vel_x"});
  CHECK(found.element.names == std::vector<std::string>{"eqps"});
  CHECK(found.nodal.read(0, 0) == count(12));
  CHECK(found.nodal.read(1, 1).front() == 112.0);
  const Values eqps = found.element.read(0, 1);
  CHECK(std::isnan(eqps[0]));
  CHECK(eqps[1] == 8.0);
}

TEST_CASE("nodal variables in one array are taken apart", "[io][variables]") {
  const Stored stored([](ExodusEditor& file) { add_results(file, true); });
  const StoredVariables found = read_stored_variables(stored.path, stored.mesh);
  CHECK(found.nodal.read(0, 0).back() == 11.0);
  CHECK(found.nodal.read(1, 1).front() == 36.0);
}

TEST_CASE("a mesh without results has no stored variables", "[io][variables]") {
  const Stored stored([](ExodusEditor&) {});
  const StoredVariables found = read_stored_variables(stored.path, stored.mesh);
  CHECK(found.times.empty());
  CHECK(found.nodal.names.empty());
  CHECK(found.element.names.empty());
}

TEST_CASE("stored variables that do not match are refused", "[io][variables]") {
  CHECK(refusal_of([](ExodusEditor& file) { add_results(file, false); }) == "");
  CHECK(refusal_of([](ExodusEditor& file) {
          add_results(file, false);
          file.set_value("time_whole", 1, 0.5);
        }) == "its stored times do not rise");
  CHECK(refusal_of([](ExodusEditor& file) {
          add_results(file, false);
          file.rename_variable("vals_nod_var1", "gone");
        }) == "has no variable vals_nod_var1");
  CHECK(refusal_of([](ExodusEditor& file) {
          add_results(file, false);
          file.rename_variable("vals_nod_var1", "gone");
          file.add_reals("vals_nod_var1", {"time_step", "num_el_in_blk1"}, {1.0, 2.0});
        }) == "variable vals_nod_var1 does not match the mesh and its 2 times");
  CHECK(refusal_of([](ExodusEditor& file) {
          add_results(file, false);
          file.rename_variable("vals_elem_var1eb2", "gone");
          file.add_reals("vals_elem_var1eb2", {"time_step", "num_nodes"}, count(24));
        }) == "variable vals_elem_var1eb2 does not match the mesh and its 2 times");
}
