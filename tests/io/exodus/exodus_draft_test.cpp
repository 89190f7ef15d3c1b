// SPDX-License-Identifier: BSD-3-Clause
#include "io/exodus/exodus_draft.hpp"

#include "io/exodus/drafted_file.hpp"
#include "support/catch.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

using Names = std::vector<std::string>;

}  // namespace

TEST_CASE("the data of a draft are made when it is written, in its order", "[io][draft]") {
  Names made;
  const DraftedFile drafted([&](ExodusDraft& draft) {
    const int n = draft.add_dimension("n", 2);
    draft.add_integers("first", {n}, [&] {
      made.push_back("first");
      return std::vector<std::int32_t>{1, 2};
    });
    draft.add_reals("second", {n}, [&] {
      made.push_back("second");
      return std::vector<double>{0.5, 0.25};
    });
    CHECK(made.empty());
    CHECK(draft.dimension("n") == n);
  });
  const NetcdfFile file = drafted.open();
  CHECK(made == Names{"first", "second"});
  std::vector<double> values(2);
  file.read_double(*file.find_variable("second"), values);
  CHECK(values == std::vector<double>{0.5, 0.25});
}

TEST_CASE("ids are as wide as the format says", "[io][draft]") {
  const bool is_wide = GENERATE(false, true);
  const ExodusFormat format{is_wide, is_wide, 32};
  const auto fill = [&](ExodusDraft& draft) {
    draft.add_ids("ids", draft.add_dimension("n", 1),
                  [&] { return std::vector<std::int64_t>{is_wide ? std::int64_t{1} << 40 : 7}; });
  };
  const DraftedFile drafted(fill, format);
  const NetcdfFile file = drafted.open();
  const NetcdfVariable ids = file.find_variable("ids").value();
  CHECK(ids.is_64_bit_integer == is_wide);
  std::vector<std::int64_t> found(1);
  file.read_int64(ids, found);
  CHECK(found[0] == (is_wide ? std::int64_t{1} << 40 : 7));
}

TEST_CASE("texts keep room for their final zero", "[io][draft]") {
  const DraftedFile drafted([&](ExodusDraft& draft) {
    draft.add_dimension("width", 4);
    draft.add_texts("texts", {draft.add_dimension("n", 2)}, "width", {"ab", "abcdef"});
  });
  const NetcdfFile file = drafted.open();
  CHECK(file.read_texts(*file.find_variable("texts")) == Names{"ab", "abc"});
}

TEST_CASE("rows of ids have status, property and names; no rows are nothing", "[io][draft]") {
  const DraftedFile drafted([&](ExodusDraft& draft) {
    draft.add_id_rows("num_el_blk", "eb", {{10, 20}, {1, 0}, {"soft", "hard"}});
    draft.add_id_rows("num_side_sets", "ss", {});
  });
  const NetcdfFile file = drafted.open();
  CHECK(file.dimension("num_el_blk") == 2);
  std::vector<std::int64_t> ids(2), status(2);
  file.read_int64(*file.find_variable("eb_prop1"), ids);
  file.read_int64(*file.find_variable("eb_status"), status);
  CHECK(ids == std::vector<std::int64_t>{10, 20});
  CHECK(status == std::vector<std::int64_t>{1, 0});
  CHECK(file.find_text(*file.find_variable("eb_prop1"), "name") == "ID");
  CHECK(file.read_texts(*file.find_variable("eb_names")) == Names{"soft", "hard"});
  CHECK(file.variable_names("ss_").empty());
  CHECK(file.dimension("num_side_sets") == 0);
}
