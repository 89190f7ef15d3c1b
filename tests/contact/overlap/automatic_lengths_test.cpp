// SPDX-License-Identifier: BSD-3-Clause
#include "contact/overlap/automatic_lengths.hpp"

#include "support/catch.hpp"
#include "support/contact_deck.hpp"

using namespace contactsim;
using namespace contactsim::test;

TEST_CASE("automatic lengths are those of the smallest and the largest face",
          "[contact][automatic_lengths]") {
  MeshBuilder b;
  b.add_hexes({.id = 1, .size = {1, 1, 1}});
  b.add_hexes({.id = 2, .cells = {4, 4, 4}, .origin = {0, 0, 1}, .size = {1, 1, 1}, .share_nodes = false});
  const Mesh mesh = b.build();
  const auto model = make_model(mesh,
                                "skin all blocks = on\nbegin interaction defaults\ngeneral contact = "
                                "on\nsearch distance = auto\nend\n");
  REQUIRE(model.messages.empty());
  const auto lengths = find_automatic_lengths(model, mesh, {});
  REQUIRE(lengths.size() == 1);
  CHECK(lengths[PairIndex{0}].normal.least == Approx(0.15 * 0.25));
  CHECK(lengths[PairIndex{0}].normal.most == Approx(0.15));
  CHECK(lengths[PairIndex{0}].capture.least == Approx(0.15 * 0.25));
  CHECK(lengths[PairIndex{0}].capture.most == Approx(0.15));
  CHECK(lengths[PairIndex{0}].overlap_normal.least == Approx(0.125));
  CHECK(lengths[PairIndex{0}].overlap_normal.most == Approx(0.5));
  CHECK(lengths[PairIndex{0}].edge.most == Approx((24 * 1.0 + 384 * 0.25) / 408));
}
