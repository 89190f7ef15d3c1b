// SPDX-License-Identifier: BSD-3-Clause
// What each row of contact variables makes of the sums of a node, a surface or a pair.
#include <map>
#include <set>
#include <string>

#include "contact/output/contact_output.hpp"
#include "support/catch.hpp"

using namespace contactsim;
using Eigen::Vector3d;

namespace {

using Values = std::vector<double>;

Values values_of(const NodeContact& node, std::string_view name) {
  for (const ContactNodeRow& row : contact_node_rows()) {
    if (row.name != name) continue;
    Values values(static_cast<std::size_t>(row.n_components()), std::nan(""));
    row.fill(node, values.data());
    return values;
  }
  throw std::logic_error("there is no such row");
}

Values values_of(const ContactTotal& total, std::string_view name) {
  for (const ContactTotalRow& row : contact_total_rows()) {
    if (row.name != name) continue;
    Values values(static_cast<std::size_t>(component_count(row.shape)), std::nan(""));
    row.fill(total, values.data());
    return values;
  }
  throw std::logic_error("there is no such row");
}

void check_near(const Values& values, const Values& expected) {
  REQUIRE(values.size() == expected.size());
  for (std::size_t i = 0; i < values.size(); ++i) CHECK(values[i] == Approx(expected[i]).margin(1e-14));
}

/// A node that is pressed down by 4 and dragged by 3 while it slips.
NodeContact pressed_node() {
  NodeContact node;
  node.status = 1.0;
  node.normal = {0, 0, -4};
  node.tangential = {0, 3, 0};
  node.area = 2.0;
  node.gap = -0.1;
  node.tangential_gap = 0.2;
  node.interaction = 7.0;
  node.surface_area = 8.0;
  node.slip_rate = 5.0;
  node.slip_velocity = {3, -4, 0.5};
  node.slip_status = 2.0;
  node.friction.slip_length = 0.75;
  node.friction.slip = {0.1, 0.2, 0.3};
  node.friction.last_slip = {0, 0, 0.5};
  node.friction.energy = 16.0;
  return node;
}

}  // namespace

TEST_CASE("every contact variable has a name of its own and a line of help", "[contact][contact_output]") {
  std::set<std::string_view> names, of_totals;
  for (const ContactNodeRow& row : contact_node_rows()) {
    CHECK(names.insert(row.name).second);
    CHECK(!row.help.empty());
    CHECK(row.help.back() == ']');
  }
  for (const ContactTotalRow& row : contact_total_rows()) CHECK(of_totals.insert(row.name).second);
}

TEST_CASE("variables of a node are its sums by hand", "[contact][contact_output]") {
  const std::map<std::string_view, Values> expected{
      {"contact_status", {1.0}},
      {"contact_normal_direction", {0, 0, -1}},
      {"contact_tangential_direction", {0, 1, 0}},
      {"contact_normal_traction_magnitude", {2.0}},
      {"contact_tangential_traction_magnitude", {1.5}},
      {"contact_normal_force", {0, 0, -4}},
      {"contact_tangential_force", {0, 3, 0}},
      {"contact_normal_force_magnitude", {4.0}},
      {"contact_tangential_force_magnitude", {3.0}},
      {"contact_normal_gap", {-0.1}},
      {"contact_tangential_gap", {0.2}},
      {"contact_accumulated_slip", {0.75}},
      {"contact_accumulated_slip_vector", {0.1, 0.2, 0.3}},
      {"contact_incremental_slip_magnitude", {0.5}},
      {"contact_incremental_slip_direction", {0, 0, 1}},
      {"contact_slip_rate", {5.0}},
      {"contact_slip_rate_vector", {3, -4, 0.5}},
      {"contact_slip_rate_components", {-4.0, 3.0}},  // across: (0, 0, -1) x (0, 1, 0) = (1, 0, 0)
      {"contact_frictional_energy", {16.0}},
      {"contact_frictional_energy_density", {2.0}},
      {"contact_area", {2.0}},
      {"contact_interaction", {7.0}},
      {"contact_slip_status", {2.0}},
  };
  CHECK(contact_node_rows().size() == expected.size());
  for (const ContactNodeRow& row : contact_node_rows()) {
    INFO(row.name);
    REQUIRE(expected.contains(row.name));
    check_near(values_of(pressed_node(), row.name), expected.at(row.name));
    // Of a node that nothing has touched yet all are 0, and none is a quotient of zeros.
    for (const double value : values_of(NodeContact{}, row.name)) CHECK(value == 0.0);
  }
}

TEST_CASE("the line point of a force is where it would have its moment, nearest to the centre",
          "[contact][contact_output]") {
  ContactTotal total;
  total.add({3, 4, 1}, {0, 0, 10}, {0, 0, 0});
  total.normal_sum = 10.0;
  total.centre = 10.0 * Vector3d(3, 4, 1);
  check_near(values_of(total, "contact_line_point"), {3, 4, 1});
  check_near(values_of(total, "contact_centre"), {3, 4, 1});
  check_near(values_of(total, "contact_friction_line_point"), {0, 0, 0});
  // Friction below the centre: the line along x goes through y = 6, z = 2.
  total.add({0, 6, 2}, {0, 0, 0}, {5, 0, 0});
  check_near(values_of(total, "contact_friction_line_point"), {3, 6, 2});
  check_near(values_of(total, "contact_normal_line_point"), {3, 4, 1});
  // Together (5, 0, 10); their moment (40, -30 + 10, -30) has a part along the force, which is left out.
  const Vector3d force(5, 0, 10),
      moment = Vector3d(3, 4, 1).cross(Vector3d(0, 0, 10)) + Vector3d(0, 6, 2).cross(Vector3d(5, 0, 0));
  check_near(values_of(total, "contact_moment"), {moment.x(), moment.y(), moment.z()});
  const Values point = values_of(total, "contact_line_point");
  const Vector3d at(point[0], point[1], point[2]), along = force.normalized();
  const Vector3d left = moment - at.cross(force);
  CHECK((left - along.dot(left) * along).norm() < 1e-12);
  CHECK(std::abs((at - Vector3d(3, 4, 1)).dot(force)) < 1e-12);  // square to the way to the centre
}

TEST_CASE("a total that does not touch is at the origin, and a force without a centre at its foot",
          "[contact][contact_output]") {
  for (const ContactTotalRow& row : contact_total_rows()) {
    for (const double value : values_of(ContactTotal{}, row.name)) CHECK(value == 0.0);
  }
  ContactTotal pulled;
  pulled.add({3, 4, 1}, {0, 0, -10}, {0, 0, 0});  // nothing presses
  check_near(values_of(pulled, "contact_line_point"), {3, 4, 0});
  check_near(values_of(pulled, "contact_centre"), {0, 0, 0});
}

TEST_CASE("totals are written as they are", "[contact][contact_output]") {
  ContactTotal total;
  total.add({1, 0, 0}, {0, 0, 2}, {0, 3, 0});
  total.area = 4.0;
  total.penetration = 5.0;
  total.energy = -6.0;
  total.friction = 7.0;
  check_near(values_of(total, "contact_force"), {0, 3, 2});
  check_near(values_of(total, "contact_normal_force"), {0, 0, 2});
  check_near(values_of(total, "contact_friction_force"), {0, 3, 0});
  check_near(values_of(total, "contact_moment"), {0, -2, 3});
  check_near(values_of(total, "contact_normal_moment"), {0, -2, 0});
  check_near(values_of(total, "contact_friction_moment"), {0, 0, 3});
  check_near(values_of(total, "contact_area"), {4});
  check_near(values_of(total, "contact_penetration_max"), {5});
  check_near(values_of(total, "contact_energy"), {-6});
  check_near(values_of(total, "friction_energy"), {7});
}
