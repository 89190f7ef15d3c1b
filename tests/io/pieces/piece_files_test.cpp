// SPDX-License-Identifier: BSD-3-Clause
#include "io/pieces/piece_files.hpp"

#include "support/catch.hpp"
#include "support/temporary_directory.hpp"

using namespace contactsim;
using Catch::Matchers::Contains;
using contactsim::test::TemporaryDirectory;
using contactsim::test::write_bytes;

TEST_CASE("pieces are numbered from zero, padded to the width of their number", "[io][pieces]") {
  CHECK(name_pieces("a/mesh.g", 4).path(3) == "a/mesh.g.4.3");
  CHECK(name_pieces("mesh.g", 16).path(3) == "mesh.g.16.03");
  CHECK(name_pieces("mesh.g", 10).path(9) == "mesh.g.10.09");
  CHECK(name_pieces("mesh.g", 128).path(1) == "mesh.g.128.001");
  CHECK(name_pieces("mesh.g", 1).path(0) == "mesh.g.1.0");
}

TEST_CASE("a piece is known by its name", "[io][pieces]") {
  CHECK(parse_piece_path("a.b/mesh.g.16.03") == PieceFiles{"a.b/mesh.g", 16, 2});
  CHECK(parse_piece_path("out.e-s0002.4.0") == PieceFiles{"out.e-s0002", 4, 1});
  CHECK(parse_piece_path("x.10.9") == PieceFiles{"x", 10, 1});
  CHECK(parse_piece_path("x.10.09") == PieceFiles{"x", 10, 2});
  for (const char* other :
       {"mesh.g", "mesh", "", ".4.0", "a/.4.0", "mesh.g.4.4", "mesh.g.04.0", "mesh.g.16.3", "mesh.g.4.00",
        "mesh.g.4.", "mesh.g..0", "mesh.g.4.-1", "mesh.g.x.0", "mesh.g.0.0", "mesh.g.99999999999999999999.0"})
    CHECK_FALSE(parse_piece_path(other));
}

TEST_CASE("a file goes before its pieces, and nothing stands for itself", "[io][pieces]") {
  const TemporaryDirectory directory;
  const std::string path = directory.file("mesh.g");
  CHECK(find_exodus_path(path, 4) == path);
  write_bytes(path + ".4.2", "");
  CHECK(find_exodus_path(path, 1) == path + ".4.0");
  write_bytes(path, "");
  CHECK(find_exodus_path(path, 1) == path);
}

TEST_CASE("of several decompositions the one for the ranks is taken", "[io][pieces]") {
  const TemporaryDirectory directory;
  const std::string path = directory.file("mesh.g");
  for (const char* piece : {".16.00", ".16.01", ".2.0", ".4.0"}) write_bytes(path + piece, "");
  // What begins alike is another file's.
  write_bytes(path + ".old.8.0", "");
  write_bytes(directory.file("mesh.8.0"), "");
  const std::vector<PieceFiles> found = find_decompositions(path);
  REQUIRE(found.size() == 3);
  CHECK(found[0] == PieceFiles{path, 2, 1});
  CHECK(found[2] == PieceFiles{path, 16, 2});
  CHECK(find_exodus_path(path, 4) == path + ".4.0");
  CHECK_THROWS_WITH(find_exodus_path(path, 3), Contains("several decompositions of it") &&
                                                   Contains("mesh.g.2.0 or ") && Contains("mesh.g.16.00"));
}

TEST_CASE("pieces of one number in two widths are two decompositions", "[io][pieces]") {
  const TemporaryDirectory directory;
  const std::string path = directory.file("mesh.g");
  write_bytes(path + ".10.0", "");
  CHECK(find_exodus_path(path, 1) == path + ".10.0");
  write_bytes(path + ".10.00", "");
  CHECK_THROWS_WITH(find_exodus_path(path, 10), Contains("mesh.g.10.0 or ") && Contains("mesh.g.10.00"));
}
