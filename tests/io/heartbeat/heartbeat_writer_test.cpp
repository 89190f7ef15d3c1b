// SPDX-License-Identifier: BSD-3-Clause
#include "io/heartbeat/heartbeat_writer.hpp"

#include "core/base/errors.hpp"
#include "support/catch.hpp"
#include "support/temporary_directory.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

/// The text of two lines with the values 1 and -0.25.
std::string lines(const HeartbeatStyle& style) {
  std::string text;
  HeartbeatWriter writer([&](std::string_view more) { text += more; }, style, {"kinetic_energy", "displ_x"},
                         [] { return std::time_t{0}; });
  const std::vector<double> values{1.0, -0.25};
  writer.write(0.0, values);
  writer.write(1e-3, values);
  return text;
}

}  // namespace

TEST_CASE("a heartbeat is a table with named columns", "[io][heartbeat]") {
  CHECK(lines({}) ==
        "Time, kinetic_energy, displ_x\n"
        "0.00000e+00, 1.00000e+00, -2.50000e-01\n"
        "1.00000e-03, 1.00000e+00, -2.50000e-01\n");
}

TEST_CASE("SpyHis begins with its mark and the names twice", "[io][heartbeat]") {
  HeartbeatStyle spyhis;
  spyhis.is_spyhis = true;
  const std::string text = lines(spyhis);
  CHECK(text.starts_with("% Sierra SPYHIS Output "));
  CHECK(text.find("1970\n") != std::string::npos);
  CHECK(text.substr(text.find('\n') + 1) ==
        "TIME, kinetic_energy, displ_x\nTIME, kinetic_energy, displ_x\n"
        "0.00000e+00, 1.00000e+00, -2.50000e-01\n"
        "1.00000e-03, 1.00000e+00, -2.50000e-01\n");
}

TEST_CASE("the original format has names in its lines and the clock before them", "[io][heartbeat]") {
  HeartbeatStyle original = original_heartbeat_style();
  original.timestamp_format = "[%Y]";
  CHECK(lines(original) ==
        "+[1970] kinetic_energy=1.00000e+00\tdispl_x=-2.50000e-01\n"
        "+[1970] kinetic_energy=1.00000e+00\tdispl_x=-2.50000e-01\n");
}

TEST_CASE("labels, legend, digits and timestamps are a choice", "[io][heartbeat]") {
  HeartbeatStyle style;
  style.has_legend = false;
  style.has_labels = true;
  style.n_digits = 2;
  CHECK(lines(style) ==
        "Time=0.0e+00, kinetic_energy=1.0e+00, displ_x=-2.5e-01\n"
        "Time=1.0e-03, kinetic_energy=1.0e+00, displ_x=-2.5e-01\n");
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

TEST_CASE("units stand under the names", "[io][heartbeat]") {
  HeartbeatStyle style;
  style.units = {"[energy]", "[length]"};
  style.n_digits = 1;
  CHECK(lines(style) ==
        "Time, kinetic_energy, displ_x\n"
        "[time], [energy], [length]\n"
        "0e+00, 1e+00, -2e-01\n"
        "1e-03, 1e+00, -2e-01\n");
}
