// SPDX-License-Identifier: BSD-3-Clause
#include "core/output/stored_variable.hpp"

#include "core/base/state_archive.hpp"
#include "support/catch.hpp"
#include "support/sample_run.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

using Values = std::vector<double>;

Values copied(std::span<const double> values) { return {values.begin(), values.end()}; }

}  // namespace

TEST_CASE("all entities of a stored variable begin alike", "[core][output]") {
  const SampleRun run;
  StoredValues values(run.model, FieldLocation::element, {1, 2});
  CHECK(values.n_components() == 2);
  CHECK(copied(values.at({0, 7, 2, {}})) == Values{1, 2, 1, 2});
  values.at({1, 0, 1, {}})[1] = 5;
  CHECK(copied(values.at({1, 0, 2, {}})) == Values{1, 5, 1, 2});
  CHECK(copied(StoredValues(run.model, FieldLocation::global, {3}).at({})) == Values{3});
  const StoredValues nodal(run.model, FieldLocation::node, {4});
  CHECK(nodal.at({0, 0, run.mesh.n_nodes(), {}}).size() == run.mesh.n_nodes());
}

TEST_CASE("stored values come back from a saved state; unsaved ones stay", "[core][output]") {
  const SampleRun run;
  StoredValues values(run.model, FieldLocation::element, {1});
  values.at({1, 1, 1, {}})[0] = 7;
  StateArchive archive;
  values.archive("peak", archive);
  const SavedState saved = archive.take();
  StoredValues other(run.model, FieldLocation::element, {0}), unknown(run.model, FieldLocation::node, {2});
  StateArchive restored(saved);
  other.archive("peak", restored);
  unknown.archive("new", restored);
  CHECK(copied(other.at({0, 8, 1, {}})) == Values{1});
  CHECK(copied(other.at({1, 1, 1, {}})) == Values{7});
  CHECK(copied(unknown.at({0, 0, 1, {}})) == Values{2});
}

TEST_CASE("a variable gives what is stored now, in all blocks unless some are named", "[core][output]") {
  const SampleRun run;
  OutputVariables variables(run.model);
  const auto values = std::make_shared<StoredValues>(run.model, FieldLocation::element, Values{0, 0, 0});
  OutputVariable own;
  own.name = "own";
  own.location = FieldLocation::element;
  const OutputVariable& added = add_stored_variable(variables, own, values);
  CHECK(variables.find(FieldLocation::element, "own") == &added);
  CHECK(added.n_components == 3);
  CHECK(added.in_blocks == std::vector<std::uint8_t>{1, 1});
  values->at({0, 2, 1, {}})[2] = 9;
  Values found(6);
  added.fill(run.context(), {0, 1, 2, {}}, found);
  CHECK(found == Values{0, 0, 0, 0, 0, 9});
  own.in_blocks = {0, 1};
  CHECK(add_stored_variable(variables, own, values).in_blocks == std::vector<std::uint8_t>{0, 1});
}
