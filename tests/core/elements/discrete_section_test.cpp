// SPDX-License-Identifier: BSD-3-Clause
#include "core/elements/discrete_section.hpp"

#include <cmath>

#include "core/dynamics/model.hpp"
#include "core/elements/element_table.hpp"
#include "core/materials/elastic.hpp"
#include "support/catch.hpp"
#include "support/lone_shell.hpp"
#include "support/mesh_builder.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Eigen::Matrix3Xd;
using Eigen::Vector3d;

namespace {

DeckName named(const std::string& text) { return {text, {}}; }

/// Force 10 strain in compression, 30 strain in tension.
FunctionDefinition kinked() {
  FunctionDefinition function;
  function.name = named("kinked");
  function.type = FunctionType::piecewise_linear;
  for (const auto& [x, y] : {std::pair{-1.0, -10.0}, {0.0, 0.0}, {1.0, 30.0}})
    function.values.push_back({{}, x, y, {}, ""});
  return function;
}

/// What a section makes of the first block, and what is said.
struct Made {
  std::optional<ModelBlock> block;
  std::string messages;
};

Made make(const SectionProperties& properties, const Mesh& mesh,
          std::optional<ElementProperties> material = {}, bool is_rigid = false) {
  Diagnostics diagnostics;
  SectionDefinition section{named("s"), {}, properties};
  if (is_rigid) section.rigid_body = named("body");
  const std::vector<FunctionDefinition> functions{kinked()};
  Made made{make_discrete(section, material, {mesh, 0, functions, diagnostics}), ""};
  for (const Diagnostic& diagnostic : diagnostics.all()) made.messages += diagnostic.text + "\n";
  return made;
}

/// One bar from 0 to 2 along x.
Mesh bar() { return MeshBuilder().add_bars({.to = {2, 0, 0}}).build(); }
Mesh point() { return MeshBuilder().add_spheres(1, "", {Vector3d(1, 2, 3)}).build(); }

LoneShell lone(const SectionProperties& properties, std::optional<ElementProperties> material = {}) {
  const Mesh mesh = bar();
  return {*make(properties, mesh, std::move(material)).block, mesh.coordinates()};
}

const Matrix3Xd none = Matrix3Xd::Zero(3, 2);

}  // namespace

TEST_CASE("a spring pulls by the change of its length, along its ends", "[core][springs]") {
  LoneShell spring = lone(SpringSection{{}, 100.0, {}, {}});
  Matrix3Xd there(3, 2);
  there << 0, 0, 0, 2.5, 0, 0;  // turned and longer by a quarter
  CHECK(spring.move_to(there, none).min_volume == Approx(2.5));
  CHECK((spring.forces().col(0) - Vector3d(0, 50, 0)).norm() < 1e-12);
  CHECK((spring.forces().col(1) + Vector3d(0, 50, 0)).norm() < 1e-12);
  CHECK(spring.stress_work() == Approx(0.5 * 100 * 0.25).epsilon(1e-12));
  CHECK(spring.stress(0)(0, 0) == Approx(50.0));
  CHECK(spring.block.mass[0](0) == 0.0);
}

TEST_CASE("a spring follows the function of its strain", "[core][springs]") {
  SpringSection section;
  section.force_strain_function = named("kinked");
  section.area = 0.1;
  section.mass_per_unit_length = 3.0;
  LoneShell spring = lone(section);
  Matrix3Xd there = bar().coordinates();
  there(0, 1) = 3.0;
  spring.move_to(there, none);
  CHECK(spring.forces()(0, 0) == Approx(15.0));
  CHECK(spring.stress(0)(0, 0) == Approx(150.0));
  there(0, 1) = 1.0;
  spring.move_to(there, none);
  CHECK(spring.forces()(0, 0) == Approx(-5.0));
  CHECK(spring.block.discrete.stiffness[0](0) == Approx(15.0));  // the steeper slope by the length
  CHECK(spring.block.mass[0](0) == Approx(6.0));
}

TEST_CASE("a damper resists the rate of its length", "[core][springs]") {
  const ElasticModuli moduli{4.0, 4.0 * 3 / 8};  // of a Young's modulus of 4
  DamperSection section;
  section.area = 0.5;
  LoneShell damper = lone(section, ElementProperties{ElasticLaw{moduli}, 0.25});
  CHECK(damper.block.discrete.stiffness[0](0) == Approx(moduli.youngs() * 0.5 / 2.0));
  CHECK(damper.block.mass[0](0) == Approx(0.25));
  Matrix3Xd there = bar().coordinates();
  there(0, 1) += 0.3;
  damper.move_to(there, none, 0.1);
  const double force = moduli.youngs() * 0.5 / 2.0 * 3.0;
  CHECK(damper.forces()(0, 0) == Approx(force));
  CHECK(damper.stress_work() == Approx(force * 0.3));
}

TEST_CASE("point masses give their node mass, and inertia when they have one", "[core][springs]") {
  PointMassSection section;
  section.mass = 4.0;
  const Mesh mesh = point();
  const auto plain = make(section, mesh).block;
  REQUIRE(plain);
  CHECK(plain->mass[0](0) == 4.0);
  CHECK_FALSE(plain->element->has_rotations);
  section.ixx = section.iyy = section.izz = 0.5;
  const auto turning = make(section, mesh).block;
  REQUIRE(turning);
  const std::vector<ModelBlock> blocks{*turning};
  CHECK(lumped_mass(mesh, blocks)(0) == 4.0);
  CHECK(lumped_inertia(mesh, blocks)(0) == 0.5);
}

TEST_CASE("sections of springs and point masses that say too little or nonsense are errors",
          "[core][springs]") {
  CHECK(make(SpringSection{}, bar()).messages ==
        "block_1 is of springs, but its section has neither DEFAULT STIFFNESS nor FORCE STRAIN FUNCTION\n");
  CHECK(make(PointMassSection{}, point()).messages ==
        "block_1 is of point masses, but its section has no MASS\n");
  CHECK(make(SpringSection{{}, 1.0, {}, {}}, point()).messages ==
        "block_1 has elements of type SPHERE, which its spring or damper section is not for\n");
  PointMassSection uneven;
  uneven.mass = 1.0;
  uneven.ixx = 1.0;
  uneven.iyy = 1.0;
  uneven.izz = 1.5;
  CHECK_THAT(make(uneven, point()).messages,
             Catch::Contains("free nodes have the same inertia about all axes"));
  CHECK(make(uneven, point(), {}, true).block);
  uneven.izz = 3.0;  // more than the two others together
  CHECK_THAT(make(uneven, point(), {}, true).messages, Catch::Contains("are those of no body"));
  SpringSection unknown;
  unknown.force_strain_function = named(constant_one_function);
  CHECK_THAT(make(unknown, bar()).messages, Catch::Contains("the steepest slope of the function"));
  const Mesh flat = MeshBuilder().add_bars({.to = {0, 0, 0}, .share_nodes = false}).build();
  CHECK_THAT(make(SpringSection{{}, 1.0, {}, {}}, flat).messages,
             Catch::Contains("has elements without length"));
}
