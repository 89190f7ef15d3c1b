// SPDX-License-Identifier: BSD-3-Clause
#include "io/exodus/run_records.hpp"

#include "core/base/errors.hpp"
#include "io/exodus/results_writer.hpp"
#include "io/netcdf/netcdf_output.hpp"
#include "support/catch.hpp"
#include "support/temporary_directory.hpp"

using namespace contactsim;
using namespace contactsim::test;

TEST_CASE("lines of information are read as they were written, long ones too", "[io][results]") {
  const TemporaryDirectory directory;
  const std::vector<std::string> lines{
      "contactsim a.i", "  begin sierra", "", std::string(79, 'a'), std::string(200, 'b') + " c", "end"};
  ResultsWriter(directory.file("r.e"), Mesh(), {"", {}, lines}, {});
  CHECK(read_info_lines(directory.file("r.e")) == lines);
  ResultsWriter(directory.file("n.e"), Mesh(), {}, {});
  CHECK(read_info_lines(directory.file("n.e")).empty());
  CHECK_THROWS_AS(read_info_lines(directory.file("none.e")), FileError);
}

TEST_CASE("global variables are read as columns over time", "[io][results]") {
  const TemporaryDirectory directory;
  const std::vector<OutputField> fields{{"kinetic", FieldLocation::global},
                                        {"force", FieldLocation::global, FieldShape::vector, 3}};
  ResultsWriter writer(directory.file("r.e"), Mesh(), {}, fields);
  for (const double time : {0.0, 0.5}) {
    const std::vector<double> kinetic{10.0 + time}, force{1.0, 2.0, 3.0 + time};
    writer.write_step(
        time, [&](std::size_t field) { return std::span<const double>(field == 0 ? kinetic : force); });
  }
  const GlobalHistory history = read_global_history(directory.file("r.e"));
  CHECK(history.names == std::vector<std::string>{"kinetic", "force_x", "force_y", "force_z"});
  CHECK(history.times == std::vector<double>{0.0, 0.5});
  CHECK(history.columns ==
        std::vector<std::vector<double>>{{10.0, 10.5}, {1.0, 1.0}, {2.0, 2.0}, {3.0, 3.5}});
}

TEST_CASE("a file without global variables has no history, one of another shape is refused",
          "[io][results]") {
  const TemporaryDirectory directory;
  ResultsWriter(directory.file("r.e"), Mesh(), {}, {});
  CHECK(read_global_history(directory.file("r.e")).names.empty());
  NetcdfOutput strange(directory.file("s.e"), false);
  const int n = strange.define_dimension("n", 3), length = strange.define_dimension("length", 33);
  strange.define_variable("name_glo_var", NetcdfType::text, {n, length});
  strange.define_variable("vals_glo_var", NetcdfType::float64, {n, length});
  strange.define_variable("time_whole", NetcdfType::float64, {n});
  strange.end_definitions();
  strange.commit();
  CHECK_THROWS_WITH(read_global_history(directory.file("s.e")), Catch::Matchers::Contains("vals_glo_var"));
}
