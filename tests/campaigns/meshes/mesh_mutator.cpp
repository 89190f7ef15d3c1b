// SPDX-License-Identifier: BSD-3-Clause
#include "campaigns/meshes/mesh_mutator.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "campaigns/meshes/value_mutator.hpp"

namespace contactsim::test {

namespace {

constexpr std::array<std::size_t, 16> hostile_lengths{
    0, 1, 2, 3, 4, 5, 8, 27, 33, 1000, 1001, 65536, 1u << 20, 2147483647, 2147483648u, 4294967295u};

constexpr std::array<const char*, 30> names{
    "connect1",   "connect2",      "eb_prop1",         "eb_names",         "eb_status",     "ss_prop1",
    "ns_prop1",   "elem_ss1",      "side_ss1",         "node_ns1",         "dist_fact_ss1", "dist_fact_ns1",
    "coord",      "coordx",        "coordz",           "node_num_map",     "elem_num_map",  "elem_map",
    "attrib1",    "attrib_name1",  "assembly_entity1", "assembly_entity2", "facconn1",      "ebepecnt1",
    "time_whole", "vals_nod_var1", "vals_nod_var",     "name_nod_var",     "qa_records",    "info_records"};

std::string draw_name(const std::string& old, CaseRandom& random) {
  switch (random.below(5)) {
    case 0:
      return old + '9';
    case 1:
      return old.substr(0, old.size() - 1);
    case 2:
      return old.substr(0, old.size() - 1) + std::to_string(random.below(12));
    case 3:
      return std::string(250, 'n');
    default:
      return random.pick(names);
  }
}

void change_dimension(NetcdfModel& model, CaseRandom& random) {
  NetcdfDimension& dimension = model.dimensions[random.below(model.dimensions.size())];
  switch (random.below(6)) {
    case 0:
      dimension.name = model.dimensions[random.below(model.dimensions.size())].name + "x";
      break;
    case 1:
      dimension.is_unlimited = !dimension.is_unlimited;
      break;
    case 2:
      dimension.length += random.once_in(2) ? 1 : dimension.length;
      break;
    case 3:
      dimension.length -= std::min<std::size_t>(dimension.length, 1);
      break;
    default:
      dimension.length = random.pick(hostile_lengths);
  }
}

void change_shape(NetcdfModel& model, NetcdfArray& array, CaseRandom& random) {
  const std::size_t other = random.below(model.dimensions.size());
  switch (array.dimensions.empty() ? 0 : random.below(5)) {
    case 0:
      array.dimensions.push_back(other);
      break;
    case 1:
      array.dimensions.pop_back();
      break;
    case 2:
      std::reverse(array.dimensions.begin(), array.dimensions.end());
      break;
    case 3:
      array.dimensions.insert(array.dimensions.begin(), other);
      break;
    default:
      array.dimensions[random.below(array.dimensions.size())] = other;
  }
}

void change_array(NetcdfModel& model, CaseRandom& random) {
  const std::size_t at = random.below(model.arrays.size());
  NetcdfArray& array = model.arrays[at];
  switch (random.below(12)) {
    case 0:
      model.arrays.erase(model.arrays.begin() + static_cast<std::ptrdiff_t>(at));
      break;
    case 1:
      array.name = draw_name(array.name, random);
      break;
    case 2: {
      NetcdfArray copy = array;
      copy.name = draw_name(copy.name, random);
      model.arrays.push_back(copy);
      break;
    }
    case 3:
      change_type(array.values, random);
      break;
    case 4:
      change_shape(model, array, random);
      break;
    case 5:
      array.is_chunked = !array.is_chunked;
      break;
    case 6:
      change_attribute(array.attributes, random);
      break;
    default:
      for (std::size_t n = 1 + random.below(3); n > 0; --n) change_values(array.values, random);
  }
}

}  // namespace

void mutate_model(NetcdfModel& model, CaseRandom& random) {
  const std::size_t way = random.below(10);
  if (way < 2 && !model.dimensions.empty()) {
    change_dimension(model, random);
  } else if (way < 3) {
    change_attribute(model.attributes, random);
  } else if (!model.arrays.empty()) {
    change_array(model, random);
  }
}

}  // namespace contactsim::test
