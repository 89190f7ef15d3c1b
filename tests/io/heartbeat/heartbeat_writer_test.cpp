// SPDX-License-Identifier: BSD-3-Clause
#include "io/heartbeat/heartbeat_writer.hpp"

#include "core/base/errors.hpp"
#include "support/catch.hpp"
#include "support/temporary_directory.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

using Format = HeartbeatOutput::Format;

/// The text of two lines with the values 1 and -0.25.
std::string lines(const HeartbeatOutput& definition) {
  std::string text;
  HeartbeatWriter writer([&](std::string_view more) { text += more; }, heartbeat_style(definition),
                         {"kinetic_energy", "displ_x"}, [] { return std::time_t{0}; });
  const std::vector<double> values{1.0, -0.25};
  writer.write(0.0, values);
  writer.write(1e-3, values);
  return text;
}

HeartbeatOutput in_format(Format format) {
  HeartbeatOutput definition;
  definition.format = format;
  return definition;
}

}  // namespace

TEST_CASE("a heartbeat is a table with named columns", "[io][heartbeat]") {
  CHECK(lines(in_format(Format::csv)) ==
        "Time, kinetic_energy, displ_x\n"
        "0.00000e+00, 1.00000e+00, -2.50000e-01\n"
        "1.00000e-03, 1.00000e+00, -2.50000e-01\n");
}

TEST_CASE("SpyHis begins with its mark and the names twice", "[io][heartbeat]") {
  const std::string text = lines(in_format(Format::spyhis));
  CHECK(text.starts_with("% Sierra SPYHIS Output "));
  CHECK(text.find("1970\n") != std::string::npos);
  CHECK(text.substr(text.find('\n') + 1) ==
        "TIME, kinetic_energy, displ_x\nTIME, kinetic_energy, displ_x\n"
        "0.00000e+00, 1.00000e+00, -2.50000e-01\n"
        "1.00000e-03, 1.00000e+00, -2.50000e-01\n");
}

TEST_CASE("the original format has names in its lines and the clock before them", "[io][heartbeat]") {
  HeartbeatOutput original = in_format(Format::original);
  original.timestamp_format = "[%Y]";
  CHECK(lines(original) ==
        "+[1970] kinetic_energy=1.00000e+00\tdispl_x=-2.50000e-01\n"
        "+[1970] kinetic_energy=1.00000e+00\tdispl_x=-2.50000e-01\n");
}

TEST_CASE("labels, legend, digits and timestamps are the deck's choice", "[io][heartbeat]") {
  HeartbeatOutput definition;
  definition.has_legend = false;
  definition.has_labels = true;
  definition.precision = 2;
  CHECK(lines(definition) ==
        "Time=0.0e+00, kinetic_energy=1.0e+00, displ_x=-2.5e-01\n"
        "Time=1.0e-03, kinetic_energy=1.0e+00, displ_x=-2.5e-01\n");
  definition.precision = 1000000;
  CHECK(heartbeat_style(definition).n_digits == 17);
}

TEST_CASE("a line is in the file as soon as it is written", "[io][heartbeat]") {
  const TemporaryDirectory directory;
  write_bytes(directory.file("h.csv"), "old\n");
  const TextSink sink = make_file_sink(directory.file("h.csv"), true);
  sink("one\n");
  CHECK(read_bytes(directory.file("h.csv")) == "old\none\n");
  make_file_sink(directory.file("h.csv"), false)("two\n");
  CHECK(read_bytes(directory.file("h.csv")) == "two\n");
}

TEST_CASE("a heartbeat that cannot be written is an error", "[io][heartbeat]") {
  CHECK_THROWS_AS(make_file_sink("/nowhere/h.csv", false), FileError);
  CHECK_THROWS_WITH(make_file_sink("/dev/full", false)("text"),
                    "/dev/full: cannot be written (No space left on device)");
}
