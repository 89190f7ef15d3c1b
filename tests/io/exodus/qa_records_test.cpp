// SPDX-License-Identifier: BSD-3-Clause
#include "io/exodus/qa_records.hpp"

#include "core/base/errors.hpp"
#include "io/exodus/results_writer.hpp"
#include "io/netcdf/netcdf_output.hpp"
#include "support/catch.hpp"
#include "support/temporary_directory.hpp"

using namespace contactsim;
using namespace contactsim::test;

TEST_CASE("the QA records of a file are read in order", "[io][results]") {
  const TemporaryDirectory directory;
  const std::vector<QaRecord> records{{"cubit", "16", "01/02/2025", "10:11:12"}, {"b", "", "", ""}};
  ResultsWriter(directory.file("r.e"), Mesh(), {"", records, {}}, {});
  CHECK(read_qa_records(directory.file("r.e")) == records);
}

TEST_CASE("a file without QA records, or with strange ones, has none", "[io][results]") {
  const TemporaryDirectory directory;
  ResultsWriter(directory.file("r.e"), Mesh(), {}, {});
  CHECK(read_qa_records(directory.file("r.e")).empty());
  NetcdfOutput strange(directory.file("s.e"), false);
  const int n = strange.define_dimension("n", 3);
  strange.define_variable("qa_records", NetcdfType::text, {n, n});
  strange.end_definitions();
  strange.commit();
  CHECK(read_qa_records(directory.file("s.e")).empty());
  CHECK_THROWS_AS(read_qa_records(directory.file("none.e")), FileError);
}
