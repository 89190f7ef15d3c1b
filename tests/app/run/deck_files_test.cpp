// SPDX-License-Identifier: BSD-3-Clause
#include "app/run/deck_files.hpp"

#include "core/definition/simulation.hpp"
#include "support/catch.hpp"
#include "support/report_region.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

/// "path:line" of the files of a deck d.i with these lines of a region, which begin at line 13; "*" for those
/// that are appended to, and the kind unless it is `other`.
std::vector<std::string> files_of_region(const std::string& lines) {
  const SimulationDefinition definition = deck_of_region(lines);
  std::vector<std::string> files;
  for (const DeckFile& file : find_deck_files(definition, definition.procedures.front())) {
    std::string text = file.path + ":" + std::to_string(file.location.line) + (file.appends ? "*" : "");
    if (file.kind == DeckFile::Kind::results) text += " results";
    if (file.kind == DeckFile::Kind::states) text += " states";
    files.push_back(std::move(text));
  }
  return files;
}

using Files = std::vector<std::string>;

const std::string on_step = "at step 0 increment = 1\n";

}  // namespace

TEST_CASE("a region that writes nothing has no files", "[app][files]") {
  CHECK(files_of_region("") == Files{});
}

TEST_CASE("outputs have the names of the deck at their lines, or its base name at that of the block",
          "[app][files]") {
  CHECK(files_of_region("begin results output\n" + on_step +
                        "end\nbegin results output\ndatabase name = r.e\n" + on_step + "end") ==
        Files{"d.e:13 results", "r.e:17 results"});
  CHECK(files_of_region("begin history output\n" + on_step +
                        "end\nbegin history output\ndatabase name = %B_x.h\n" + on_step + "end") ==
        Files{"d.h:13", "d_x.h:17"});
}

TEST_CASE("heartbeats to the log are no files, those that append say so", "[app][files]") {
  const auto heartbeat = [](const std::string& lines) {
    return "begin heartbeat output\n" + lines + on_step + "end\n";
  };
  CHECK(files_of_region(heartbeat("stream name = cout\n") + heartbeat("stream name = LOG\n")) == Files{});
  CHECK(files_of_region(heartbeat("") + heartbeat("stream name = a.txt\nappend = on\n")) ==
        Files{"d.csv:13", "a.txt:17*"});
}

TEST_CASE("states have the name of the output database before that of both", "[app][files]") {
  CHECK(files_of_region("begin restart data\n" + on_step + "end") == Files{"d.rsout:13 states"});
  CHECK(files_of_region("begin restart data\ndatabase name = both\n" + on_step + "end") ==
        Files{"both:14 states"});
  CHECK(files_of_region("begin restart data\ndatabase name = both\noutput database name = out\n" + on_step +
                        "end") == Files{"out:15 states"});
}

TEST_CASE("files that contact is debugged by are of its definition", "[app][files]") {
  CHECK(files_of_region("begin contact definition c\nskin all blocks = on\nend") == Files{});
  CHECK(files_of_region(
            "begin contact definition c\nskin all blocks = on\nbegin debug\nvisualize contact facets = "
            "on\noutput contact surfaces and constraints = on\nend\nend") ==
        Files{"d_contact_facets.exo:13", "d_contact_places.csv:13"});
}
