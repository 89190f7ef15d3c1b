// SPDX-License-Identifier: BSD-3-Clause
#include "app/reports/log.hpp"

#include <filesystem>

#include "core/base/errors.hpp"
#include "support/catch.hpp"
#include "support/temporary_directory.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

/// A folder for a log that prints nothing.
struct LogFolder : TemporaryDirectory {
  std::string path_of_log() const { return file("a.log"); }
  std::string text() const { return read_bytes(path_of_log()); }
};

}  // namespace

TEST_CASE("a log holds what comes until it begins, and writes the earlier file over", "[app][log]") {
  const LogFolder folder;
  write_bytes(folder.path_of_log(), "an earlier run\n");
  Log log(folder.path_of_log(), true);
  log.write("one\n");
  CHECK(folder.text() == "an earlier run\n");
  log.begin(false);
  CHECK(folder.text() == "one\n");
  log.write("two\n");
  log.write_to_file("three\n");
  CHECK(folder.text() == "one\ntwo\nthree\n");
  log.close();
  CHECK(folder.text() == "one\ntwo\nthree\n");
}

TEST_CASE("a log of a run that resumes follows the earlier one behind an empty line", "[app][log]") {
  const LogFolder folder;
  write_bytes(folder.path_of_log(), "an earlier run\n");
  Log log(folder.path_of_log(), true);
  log.write("one\n");
  log.begin(true);
  log.write("two\n");
  log.close();
  CHECK(folder.text() == "an earlier run\n\none\ntwo\n");
}

TEST_CASE("a log that resumes into a file of its own begins at its first line", "[app][log]") {
  const LogFolder folder;
  Log log(folder.path_of_log(), true);
  log.write("one\n");
  log.begin(true);
  log.close();
  CHECK(folder.text() == "one\n");
}

TEST_CASE("a log that never began is closed behind what there is", "[app][log]") {
  const LogFolder folder;
  write_bytes(folder.path_of_log(), "kept\n");
  Log log(folder.path_of_log(), true);
  log.write_error("error: too early");
  log.close();
  CHECK(folder.text() == "kept\n\nerror: too early\n");
}

TEST_CASE("a log that is left leaves its file as it is", "[app][log]") {
  const LogFolder folder;
  write_bytes(folder.path_of_log(), "of another run\n");
  Log log(folder.path_of_log(), true);
  log.write("one\n");
  log.leave_file();
  log.write("two\n");
  log.close();
  CHECK(folder.text() == "of another run\n");
}

TEST_CASE("lines of a log are wrapped, problems are in the form of machines", "[app][log]") {
  const LogFolder folder;
  Log log(folder.path_of_log(), true);
  log.begin(false);
  const std::string half(70, 'h');
  log.write(half + " " + half + "\n");
  CHECK(folder.text() == half + "\n      " + half + "\n");
  Diagnostics found;
  found.add_warning("odd", {}, "strange");
  found.add_warning("odd", {}, "strange");
  log.write(found);
  log.close();
  CHECK(folder.text().ends_with("warning: strange [odd]\n  1 more like this\n"));
}

TEST_CASE("a log remembers the errors that it was reported, and nothing else", "[app][log]") {
  const LogFolder folder;
  Log log(folder.path_of_log(), true);
  log.write_error("error: a file");
  log.write_error("stopped by SIGTERM after step 3");
  log.write_error("contactsim: a bug: it broke");
  log.write_error("errors: two");
  CHECK(log.errors() == std::vector<std::string>{"error: a file", "contactsim: a bug: it broke"});
  CHECK(log.is_quiet());
}

TEST_CASE("a log that cannot be written is refused, with its path", "[app][log]") {
  const LogFolder folder;
  CHECK_THROWS_WITH(Log(folder.file("no/a.log"), true),
                    folder.file("no/a.log") + ": the log file cannot be written");
  std::filesystem::create_directory(folder.file("taken"));
  CHECK_THROWS_AS(Log(folder.file("taken"), true), FileError);
}
