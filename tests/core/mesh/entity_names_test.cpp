// SPDX-License-Identifier: BSD-3-Clause
#include "core/mesh/entity_names.hpp"

#include "support/catch.hpp"

using namespace contactsim;

TEST_CASE("entities without a name are called by their kind and id", "[core][mesh]") {
  CHECK(default_name(EntityKind::block, 7) == "block_7");
  CHECK(default_name(EntityKind::side_set, 7) == "surface_7");
  CHECK(default_name(EntityKind::node_set, 12) == "nodelist_12");
  CHECK(default_name(EntityKind::assembly, 1) == "assembly_1");
  CHECK(to_string(EntityKind::side_set) == "side set");
  CHECK(to_string(EntityKind::assembly) == "assembly");
}

TEST_CASE("default names tell their ids, other names none", "[core][mesh]") {
  CHECK(find_default_id(EntityKind::block, "BLOCK_7") == 7);
  CHECK(find_default_id(EntityKind::side_set, "surface 12") == 12);  // a blank is an underscore
  CHECK(find_default_id(EntityKind::side_set, "SideSet_12") == 12);
  CHECK(find_default_id(EntityKind::node_set, "nodeset_3") == 3);
  CHECK(find_default_id(EntityKind::node_set, "nodelist_3") == 3);
  CHECK(find_default_id(EntityKind::block, "block_0") == 0);
  CHECK(find_default_id(EntityKind::block, "block_9223372036854775807") ==
        std::numeric_limits<std::int64_t>::max());
  for (const char* name : {"block_", "block_x", "block_7x", "block_007", "block_-7", "block_+7", "block_7 ",
                           "block7", "block_9223372036854775808", "surface_7", "my_block_7", ""})
    CHECK_FALSE(find_default_id(EntityKind::block, name));
}

TEST_CASE("the default name of another id is no name of one's own", "[core][mesh]") {
  CHECK(effective_name(EntityKind::block, "lid", 3) == "lid");
  CHECK(effective_name(EntityKind::block, "", 3) == "block_3");
  CHECK(effective_name(EntityKind::block, "Block_3", 3) == "Block_3");
  CHECK(effective_name(EntityKind::block, "block_9", 3) == "block_3");
  CHECK(effective_name(EntityKind::block, "surface_9", 3) == "surface_9");
  CHECK(effective_name(EntityKind::node_set, "nodeset_9", 3) == "nodelist_3");
}

TEST_CASE("the first of a repeated name is found, a default name by its id alone", "[core][mesh]") {
  const EntityLookup lookup(EntityKind::block, {30, 10, 20, 10, 40},
                            {"Lid", "", "lid", "base plate", "block_10"});
  CHECK(lookup.find("LID") == 0);
  CHECK(lookup.find("Base_Plate") == 3);
  CHECK(lookup.find("block_10") == 1);  // the first of a repeated id, and not what stores the name
  CHECK(lookup.find("block_40") == 4);
  CHECK(lookup.find("block_30") == 0);  // also of a block with another name
  CHECK_FALSE(lookup.find("block_50"));
  CHECK_FALSE(lookup.find("li"));
  CHECK_FALSE(lookup.find("lids"));
  CHECK_FALSE(EntityLookup().find("lid"));
  CHECK_FALSE(EntityLookup(EntityKind::block, {}, {}).find("block_1"));
}
