// SPDX-License-Identifier: BSD-3-Clause
#include "app/reports/run_summary.hpp"

#include "support/catch.hpp"
#include "support/temporary_directory.hpp"

using namespace contactsim;

TEST_CASE("the digest of several files is that of their bytes behind each other", "[app][summary]") {
  const test::TemporaryDirectory directory;
  test::write_bytes(directory.file("a"), "some ");
  test::write_bytes(directory.file("b"), "text");
  test::write_bytes(directory.file("c"), "some text");
  const std::vector<std::string> both{directory.file("a"), directory.file("b")};
  const std::vector<std::string> turned{directory.file("b"), directory.file("a")};
  const std::vector<std::string> one{directory.file("c")}, gone{directory.file("a"), directory.file("d")};
  CHECK(digest_of_files(both) == digest_of_files(one));
  CHECK(digest_of_files(both) != digest_of_files(turned));
  CHECK(digest_of_files(gone) == "");
}

TEST_CASE("files of the same bytes have the same digest", "[app][summary]") {
  const test::TemporaryDirectory directory;
  test::write_bytes(directory.file("a"), "some text");
  test::write_bytes(directory.file("b"), "some text");
  test::write_bytes(directory.file("c"), "some texT");
  const auto digest_of = [&](const std::string& name) {
    const std::string path = directory.file(name);
    return digest_of_files({&path, 1});
  };
  CHECK(digest_of("a").size() == 16);
  CHECK(digest_of("a") == digest_of("b"));
  CHECK(digest_of("a") != digest_of("c"));
  CHECK(digest_of("none") == "");
}

TEST_CASE("a digest has 16 hexadecimal digits", "[app][summary]") {
  CHECK(format_digest(0) == "0000000000000000");
  CHECK(format_digest(0xABCDEF) == "0000000000abcdef");
  CHECK(format_digest(~std::uint64_t{0}) == "ffffffffffffffff");
}

TEST_CASE("pairs of a model are noted by number, names and line, without a history", "[app][summary]") {
  ContactModel model;
  for (const char* name : {"lid", "box"}) model.surfaces.surfaces.emplace_back().name = name;
  model.pairs.resize(2);
  model.pairs[{0}].second = {1};
  model.pairs[{0}].interaction = "tie";
  model.pairs[{0}].location.line = 9;
  model.pairs[{1}].interaction = "self contact";
  RunSummary summary;
  note_pairs(model, summary);
  CHECK(summary.n_pairs == 2);
  REQUIRE(summary.pairs.size() == 2);
  CHECK(summary.pairs[0].number == 1);
  CHECK(summary.pairs[0].first == "lid");
  CHECK(summary.pairs[0].second == "box");
  CHECK(summary.pairs[0].interaction == "tie");
  CHECK(summary.pairs[0].line == 9);
  CHECK_FALSE(summary.pairs[0].history);
  CHECK(summary.pairs[1].second == "lid");
}
