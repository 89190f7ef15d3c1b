// SPDX-License-Identifier: BSD-3-Clause
#include "app/compare/compare_files.hpp"

#include <filesystem>

#include "app/reports/run_summary.hpp"
#include "core/base/errors.hpp"
#include "support/catch.hpp"
#include "support/temporary_directory.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

const std::string sample_facets = "surface,block,element,side,kind,area\na,b,1,6,face,0.5\n";
const std::string sample_json = R"({"schema": "contactsim-surfaces/1", "surfaces": [
  {"name": "a", "kind": "face", "line": 3, "owned": 4, "lost_to": []}], "pairs": []})";

ComparedFile compared(const std::string& path, const std::string& text) {
  return {path, text, find_input_kind(path, text)};
}

std::vector<std::string> texts_of(const FileComparison& comparison) {
  std::vector<std::string> texts;
  for (const Difference& one : comparison.differences) texts.push_back(one.text);
  return texts;
}

}  // namespace

TEST_CASE("a file is read whole and its kind seen", "[app][compare]") {
  const TemporaryDirectory directory;
  write_bytes(directory.file("a.csv"), sample_facets);
  const ComparedFile file = read_compared_file(directory.file("a.csv"));
  CHECK(file.path == directory.file("a.csv"));
  CHECK(file.text == sample_facets);
  CHECK(file.kind == InputKind::surfaces_csv);
}

TEST_CASE("what cannot be read to be compared is named with the reason", "[app][compare]") {
  const TemporaryDirectory directory;
  CHECK_THROWS_WITH(read_compared_file(directory.file("no.csv")),
                    directory.file("no.csv") + ": cannot be read (No such file or directory)");
  std::filesystem::create_directory(directory.file("folder"));
  CHECK_THROWS_WITH(read_compared_file(directory.file("folder")),
                    directory.file("folder") + ": this is a directory, not a file");
  write_bytes(directory.file("empty"), "");
  CHECK_THROWS_WITH(read_compared_file(directory.file("empty")),
                    directory.file("empty") + ": the file is empty");
}

TEST_CASE("files of each kind are compared as that kind", "[app][compare]") {
  const FileComparison tables =
      compare_files(compared("a.json", sample_json), compared("b.json", sample_json), {{}, false});
  CHECK(tables.kind == "ownership");
  CHECK(tables.first == "a.json");
  CHECK(tables.second == "b.json");
  CHECK(tables.differences.empty());

  const FileComparison lists = compare_files(
      compared("a.csv", sample_facets),
      compared("b.csv", "surface,block,element,side,kind,area\na,b,1,6,face,0.6\n"), {{}, true});
  CHECK(lists.kind == "ownership");
  CHECK(texts_of(lists) ==
        std::vector<std::string>{"area: 1 facet of 'a', first element 1 side 6: 0.5 -> 0.6"});

  const FileComparison heartbeats =
      compare_files(compared("a.csv", "Time, f\n0, 1\n"), compared("b.csv", "Time, f\n0, 2\n"), {{}, false});
  CHECK(heartbeats.kind == "heartbeat");
  CHECK(heartbeats.differences.size() == 1);
  CHECK(compare_files(compared("a.csv", "Time, f\n0, 1\n"), compared("b.csv", "Time, f\n0, 2\n"),
                      {{0.6, 0.0}, false})
            .differences.empty());

  const std::string summary = format_summary({});
  const FileComparison summaries = compare_files(compared("a", summary), compared("b", summary), {{}, false});
  CHECK(summaries.kind == "summary");
  CHECK(summaries.differences.empty());
}

TEST_CASE("files of different kinds are refused by both their names", "[app][compare]") {
  CHECK_THROWS_WITH(compare_files(compared("a.json", sample_json), compared("b.csv", sample_facets), {}),
                    "b.csv: this is " + std::string(describe(InputKind::surfaces_csv)) + ", but a.json is " +
                        describe(InputKind::surfaces_json));
}

TEST_CASE("facets are listed of what has facets alone", "[app][compare]") {
  CHECK_THROWS_WITH(
      compare_files(compared("a.json", sample_json), compared("b.json", sample_json), {{}, true}),
      "a.json: --faces needs lists of facets (CSV of --surfaces-csv) or decks, but this is " +
          std::string(describe(InputKind::surfaces_json)));
  CHECK_THROWS_AS(
      compare_files(compared("a", "Time, f\n0, 1\n"), compared("b", "Time, f\n0, 1\n"), {{}, true}),
      FileError);
}

TEST_CASE("a file that is not as its kind should be is named", "[app][compare]") {
  CHECK_THROWS_WITH(
      compare_files(compared("a.csv", sample_facets),
                    compared("b.csv", "surface,block,element,side,kind,area\n\na,b,1,6,face\n"), {}),
      "b.csv: line 3: 5 fields in place of 6");
}
