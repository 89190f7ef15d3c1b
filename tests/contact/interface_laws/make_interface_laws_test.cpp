// SPDX-License-Identifier: BSD-3-Clause
#include "contact/interface_laws/make_interface_laws.hpp"

#include "support/catch.hpp"
#include "support/deck_dump.hpp"
#include "support/friction_law.hpp"
#include "support/law_bodies.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

/// The errors of a model called m, in a deck of contact lines.
std::string errors_of(const std::string& model, const std::string& functions = "") {
  const ContactDefinition contact = parse_contact(model);
  const SimulationDefinition defined = parse_definitions(functions);
  std::vector<SurfacePair> pairs(2);
  for (SurfacePair& pair : pairs) pair.law = share(*find_friction_law(contact.friction_models, "m"));
  Diagnostics found;
  make_pair_laws(pairs, {contact.friction_models, defined.functions, {}}, found);
  return messages(found);
}

}  // namespace

TEST_CASE("functions of gaps must be piecewise linear", "[contact][make_interface_laws]") {
  const std::string model = "begin adhesion model m\nadhesion function = f\nend\n";
  CHECK(errors_of(model, line_function("f", "0 1\n1 0\n")).empty());
  CHECK(errors_of(model, "begin function f\ntype is constant\nbegin values\n3\nend\nend\n") ==
        "c.i:2:21: error: the function 'f' of a friction model must be PIECEWISE LINEAR; the law ends where "
        "its "
        "last line ends\n");
}

TEST_CASE("a failed model must slide, and rings of failed models end", "[contact][make_interface_laws]") {
  const std::string weld = "begin surface weld model m\nnormal capacity = 1\ntangential capacity = 1\n";
  CHECK(errors_of(weld + "end\n").empty());
  CHECK(errors_of(weld + "failed model = frictionless\nend\n").empty());
  for (const std::string failed : {"tied", "m"}) {
    CHECK(errors_of(weld + "failed model = " + failed + "\nend\n") ==
          "c.i:4:16: error: the FAILED MODEL '" + failed +
              "' holds what has just failed; it must slide: "
              "frictionless, constant friction, stick, adhesion, junction, pv dependent, pressure function, "
              "exponential pressure\n");
  }
}

TEST_CASE("the curve of a cohesive zone must soften", "[contact][make_interface_laws]") {
  const std::string model =
      "begin cohesive zone model m\ntraction displacement function = f\n"
      "critical normal gap = 1\ncritical tangential gap = 1\nend\n";
  CHECK(errors_of(model, line_function("f", "0 0\n0.5 10\n1 0\n")).empty());
  CHECK(errors_of(model, line_function("f", "0 0\n0.5 1\n1 10\n")) ==
        "c.i:2:34: error: the traction 'f' of a cohesive zone must not rise faster than its abscissa, or be "
        "negative; unloading to the origin would make energy\n");
}

TEST_CASE("models that select do not select each other", "[contact][make_interface_laws]") {
  const std::string hybrid = "begin hybrid model m\ninitially close = other\nend\n";
  CHECK(errors_of(hybrid + "begin constant friction model other\nfriction coefficient = 0.1\nend\n").empty());
  CHECK(errors_of(hybrid + "begin hybrid model other\nend\n").find("cannot select another such model") !=
        std::string::npos);
}
