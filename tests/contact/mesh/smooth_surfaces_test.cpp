// SPDX-License-Identifier: BSD-3-Clause
#include "contact/mesh/smooth_surfaces.hpp"

#include <cmath>

#include "support/catch.hpp"
#include "support/contact_deck.hpp"
#include "support/ring_mesh.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Eigen::Vector3d;

namespace {

const std::string round_shape =
    "begin surface smoothing round\nsurface = inner outer\ncircumferential axis = 0 0 0 0 0 1\nend\n";

/// A ring of 16 in one of 24 elements, and a cube.
MeshBuilder rings_and_cube() {
  MeshBuilder b;
  add_ring(b, {.id = 1, .name = "inner", .n = 16, .from = 0.8, .to = 1.0});
  add_ring(b, {.id = 2, .name = "outer", .n = 24, .from = 1.0, .to = 1.2});
  return b.add_hexes({.id = 3, .name = "cube", .origin = {5, 0, 0}});
}

std::string pairs_of(const std::string& defaults, const std::string& more = "") {
  return "skin all blocks = on\nbegin interaction defaults\ngeneral contact = on\n" + defaults + "end\n" +
         more;
}

/// What is told of smoothings, by ids.
std::string told_of(const std::string& lines) {
  const Mesh mesh = rings_and_cube().build();
  const ContactDefinition contact = parse_contact(lines);
  Modelled model = make_model(mesh, lines);
  model.smoothings.clear();
  Diagnostics diagnostics;
  find_smoothings({}, contact, mesh, model, diagnostics);
  std::string text;
  for (const Diagnostic& told : diagnostics.all()) text += told.id + " ";
  return text;
}

}  // namespace

TEST_CASE("pairs that name one smoothing share it, others have none", "[contact][smoothing]") {
  const Mesh mesh = rings_and_cube().build();
  const auto model =
      make_model(mesh, round_shape + pairs_of("smoothing = ROUND\n",
                                              "begin interaction\nsurfaces = inner cube\nsmoothing = "
                                              "auto\nend\nbegin interaction\nsurfaces = outer "
                                              "cube\nsmoothing = off\nend\n"));
  REQUIRE(model.smoothings.size() == 2);
  for (const SurfacePair& pair : model.pairs) {
    const auto& surfaces = model.surfaces.surfaces;
    const bool has_cube = surfaces[pair.second].name == "cube",
               has_inner = surfaces[pair.first].name == "inner";
    if (!has_cube) CHECK(model.smoothings[*pair.smoothing].name == "round");
    if (has_cube && has_inner) CHECK(model.smoothings[*pair.smoothing].is_automatic);
    if (has_cube && !has_inner) CHECK_FALSE(pair.smoothing);
  }
}

TEST_CASE("smoothings that nothing uses, or that smooth nothing, are told", "[contact][smoothing]") {
  CHECK(told_of(pairs_of("")).empty());
  CHECK(told_of(round_shape + pairs_of("")) == "smoothing-unused ");
  // Of the defaults one pair that is smoothed is enough.
  CHECK(told_of(round_shape + pairs_of("smoothing = round\n")).empty());
  const std::string cube_alone =
      "begin surface smoothing flat\nsurface = nothing\nspherical center = 0 0 0\nend\n";
  CHECK(told_of(cube_alone + pairs_of("smoothing = flat\n")) == "smoothing-without-effect ");
  CHECK(told_of(cube_alone + round_shape +
                pairs_of("smoothing = round\n",
                         "begin interaction\nsurfaces = inner cube\nsmoothing = flat\nend\n"
                         "begin interaction\nsurfaces = outer cube\nsmoothing = flat\nend\n")) ==
        "smoothing-without-effect smoothing-without-effect ");
}

TEST_CASE("faces round the axis stand for the round surface, those that look along it do not",
          "[contact][smoothing]") {
  const std::string which = GENERATE("round", "auto");
  const Mesh mesh = rings_and_cube().build();
  const auto model = make_model(mesh, round_shape + pairs_of("smoothing = " + which + "\n"));
  ContactMesh contact_mesh = make_contact_mesh(model, mesh);
  const ContactKinematics start = kinematics_of_mesh(contact_mesh, mesh);
  add_smooth_faces(model, start, contact_mesh);
  CHECK(contact_mesh.smooth_faces.n_smoothings() == 1);
  std::size_t n_round = 0;
  for (const FaceIndex i : indices(contact_mesh.faces)) {
    const bool is_round = contact_mesh.faces[i].surface.value < 2 &&
                          std::abs(start.area(contact_mesh.faces[i]).normalized().z()) < 0.5;
    const SmoothFace* smooth = contact_mesh.smooth_faces.find(0u, i);
    CHECK((smooth != nullptr) == is_round);
    if (smooth == nullptr) continue;
    ++n_round;
    const FaceCorners corners = start.face_corners(i);
    const double radius = corners.col(0).head<2>().norm();
    const double chord = (corners.col(0).head<2>() - corners.col(2).head<2>()).norm();
    // The sagitta r - sqrt(r^2 - c^2 / 4) of the middle.
    CHECK(std::abs(smooth->rise_at(0.0, 0.0).value.z()) ==
          Approx(radius - std::sqrt(radius * radius - 0.25 * chord * chord)));
    CHECK(smooth->sharpness == Approx(90.0));  // at its ends, not by the turn to the next facet
    CHECK(contact_mesh.smooth_faces.extent(i).height > 0.0f);
  }
  CHECK(n_round == 2 * 16 + 2 * 24);
  CHECK(contact_mesh.smooth_faces.find({}, {0}) == nullptr);
}

TEST_CASE("inside and outside of a ring are two round surfaces where they were fitted, one where given",
          "[contact][smoothing]") {
  const std::string which = GENERATE("round", "auto");
  const Mesh mesh = rings_and_cube().build();
  const auto model = make_model(mesh, round_shape + pairs_of("smoothing = " + which + "\n"));
  ContactMesh contact_mesh = make_contact_mesh(model, mesh);
  const ContactKinematics start = kinematics_of_mesh(contact_mesh, mesh);
  add_smooth_faces(model, start, contact_mesh);
  std::vector<FaceIndex> inside, outside;
  for (const FaceIndex i : contact_mesh.faces_of({0})) {
    if (contact_mesh.smooth_faces.find(0u, i) == nullptr) continue;
    (start.face_corners(i).col(0).head<2>().norm() < 0.9 ? inside : outside).push_back(i);
  }
  REQUIRE(inside.size() == 16);
  REQUIRE(outside.size() == 16);
  CHECK(contact_mesh.smooth_faces.go_on(0u, inside[0], inside[5]));
  CHECK(contact_mesh.smooth_faces.go_on(0u, inside[0], outside[0]) == (which == "round"));
}

TEST_CASE("shapes are fitted anew to nodes that have moved, where as many fit", "[contact][smoothing]") {
  Mesh mesh = rings_and_cube().build();
  Modelled model = make_model(mesh, pairs_of("smoothing = auto\n"));
  const auto outer_radius = [&] {
    double largest = 0.0;
    for (const FittedShape& fitted : model.smoothings[0].surfaces[{0}].fitted)
      largest = std::max(largest, fitted.radius);
    return largest;
  };
  CHECK(outer_radius() == Approx(1.0));
  MeshParts wider = rings_and_cube().parts();
  for (Eigen::Index i = 0; i < wider.coordinates.cols(); ++i) {
    const double radius = wider.coordinates.col(i).head<2>().norm();
    if (std::abs(radius - 1.0) < 1e-9) wider.coordinates.col(i).head<2>() *= 1.01;
  }
  refit_smoothings(Mesh(wider), model);
  CHECK(outer_radius() == Approx(1.01));
  // A dent leaves that side without a shape of its own: the one before stays.
  MeshParts dented = wider;
  for (Eigen::Index i = 0; i < dented.coordinates.cols(); ++i) {
    const double radius = dented.coordinates.col(i).head<2>().norm();
    if (std::abs(radius - 1.01) < 1e-9 && dented.coordinates(0, i) > 0.5) dented.coordinates(0, i) *= 0.95;
  }
  refit_smoothings(Mesh(dented), model);
  CHECK(outer_radius() == Approx(1.01));
  CHECK(model.smoothings[0].surfaces[{0}].fitted.size() == 2);
}
