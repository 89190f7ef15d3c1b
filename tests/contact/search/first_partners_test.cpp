// SPDX-License-Identifier: BSD-3-Clause
#include "contact/search/first_partners.hpp"

#include "core/base/saved_state.hpp"
#include "core/base/state_archive.hpp"
#include "support/catch.hpp"
#include "support/contact_bodies.hpp"
#include "support/two_cubes.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

/// Candidates of the first face, or of the first surface node: a row of its own for each of n.
template <class Lists>
Lists partners_of_first(std::size_t n, std::vector<std::uint32_t> partners) {
  Lists lists;
  lists.begin.assign(n + 1, static_cast<std::uint32_t>(partners.size()));
  lists.begin[0] = 0;
  lists.partners = std::move(partners);
  return lists;
}

/// Two cubes: faces 0 to 5 and 6 to 11, surface nodes 0 to 7 and 8 to 15.
struct SlidingCubes {
  ContactParts parts;
  FirstPartners first;

  explicit SlidingCubes(const std::string& behavior = "interaction behavior = infinitesimal_sliding\n")
      : parts(TwoCubes::cubes(), general_contact(behavior)) {
    first.keep(partners_of_first<FacePairLists>(12, {6, 7}));
    first.keep(partners_of_first<NodeFaceLists>(16, {8}));
  }
  using Numbers = std::vector<std::uint32_t>;
  Numbers faces_of(const Numbers& found) const {
    auto lists = partners_of_first<FacePairLists>(12, found);
    first.restrict(parts.contact_mesh, parts.rules, lists);
    CHECK(lists.begin == std::vector<std::uint32_t>([&] {
            std::vector<std::uint32_t> begin(13, static_cast<std::uint32_t>(lists.partners.size()));
            begin[0] = 0;
            return begin;
          }()));
    return lists.partners;
  }
  Numbers faces_of_node(const Numbers& found) const {
    auto lists = partners_of_first<NodeFaceLists>(16, found);
    first.restrict(parts.contact_mesh, parts.rules, lists);
    return lists.partners;
  }
  /// All faces and rows stay but face 7, in whose place there is another one.
  ContactRemap replaced_face() const {
    ContactRemap remap;
    for (std::uint32_t i = 0; i < 12; ++i)
      remap.faces.push_back(i == 7 ? OptionalIndex<FaceIndex>() : OptionalIndex<FaceIndex>(FaceIndex{i}));
    for (std::uint32_t i = 0; i < 16; ++i) remap.rows.push_back(SurfaceNodeIndex{i});
    remap.n_faces_after = 12;
    remap.n_rows_after = 16;
    return remap;
  }
};

using Numbers = SlidingCubes::Numbers;

}  // namespace

TEST_CASE("pairs that slide infinitesimally get no candidates beside the first ones",
          "[contact][first_partners]") {
  const SlidingCubes cubes;
  CHECK(cubes.faces_of({6, 8}) == Numbers{6});
  CHECK(cubes.faces_of({9, 10}).empty());
  CHECK(cubes.faces_of_node({7, 8, 9}) == Numbers{8});
  const SlidingCubes finite("");
  CHECK(finite.faces_of({6, 8}) == Numbers{6, 8});
  CHECK(finite.faces_of_node({7, 8, 9}) == Numbers{7, 8, 9});
}

TEST_CASE("what is released meets whatever it may, from both sides", "[contact][first_partners]") {
  SlidingCubes cubes;
  cubes.first.release(FaceIndex{8}, cubes.parts.contact_mesh);
  CHECK(cubes.faces_of({6, 8, 9}) == Numbers{6, 8});
  CHECK(cubes.faces_of_node({7, 8}) == Numbers{8});
  cubes.first.release(SurfaceNodeIndex{0}, cubes.parts.contact_mesh);
  CHECK(cubes.faces_of_node({7, 8}) == Numbers{7, 8});
  CHECK(cubes.faces_of({6, 9}) == Numbers{6});
  cubes.first.release(FaceIndex{0}, cubes.parts.contact_mesh);
  CHECK(cubes.faces_of({6, 9}) == Numbers{6, 9});
}

TEST_CASE("faces that are new meet whatever they may, faces that are gone are no partners any more",
          "[contact][first_partners]") {
  SlidingCubes cubes;
  const bool releases_new = GENERATE(true, false);
  cubes.first.remap(cubes.replaced_face(), releases_new);
  CHECK(cubes.faces_of({6, 7, 8}) == (releases_new ? Numbers{6, 7} : Numbers{6}));
  CHECK(cubes.faces_of_node({8, 9}) == Numbers{8});
}

TEST_CASE("a pair has first partners if the first search found some", "[contact][first_partners]") {
  SlidingCubes cubes;
  const auto has_any = [&] { return cubes.first.has_any({0}, cubes.parts.contact_mesh, cubes.parts.rules); };
  CHECK(has_any());
  cubes.first.keep(FacePairLists());
  CHECK(has_any());
  cubes.first.keep(NodeFaceLists());
  CHECK_FALSE(has_any());
}

TEST_CASE("first partners and what is released are saved", "[contact][first_partners]") {
  SlidingCubes cubes;
  const bool has_released = GENERATE(true, false);
  if (has_released) cubes.first.release(FaceIndex{8}, cubes.parts.contact_mesh);
  StateArchive saving;
  cubes.first.archive(saving);
  const SavedState saved = saving.take();
  CHECK((saved.find("contact/search/new_faces") != nullptr) == has_released);
  SlidingCubes others;
  others.first = FirstPartners();
  others.first.release(FaceIndex{10}, others.parts.contact_mesh);
  StateArchive restoring(saved);
  others.first.archive(restoring);
  CHECK(others.faces_of({6, 8, 9, 10}) == (has_released ? Numbers{6, 8} : Numbers{6}));
}
