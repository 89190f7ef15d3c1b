// SPDX-License-Identifier: BSD-3-Clause
#include "parser/commands/smoothing_commands.hpp"

#include <algorithm>
#include <set>

#include "parser/commands/block_rows.hpp"

namespace contactsim {

namespace {

constexpr const char* axis_syntax = "{<axis>|<point> <point>|<x> <y> <z> <x> <y> <z>}";

bool is_number(const Arguments& arguments) {
  if (arguments.at_end()) return false;
  Words word(&arguments.peek(), 1);
  try {
    take_real(word);
    return true;
  } catch (const ValueError&) {
    return false;
  }
}

PointReference read_point(Arguments& arguments) {
  if (is_number(arguments)) return arguments.vector();
  return arguments.reference(NameKind::point);
}

/// An axis ends with the line, or before a word.
///   end  in lower case; "" for none
AxisReference read_axis(Arguments& arguments, std::string_view end) {
  if (is_number(arguments)) {
    const Eigen::Vector3d first = arguments.vector();
    return {{}, std::array<PointReference, 2>{first, arguments.vector()}};
  }
  // One name is that of an axis, two are those of points.
  const DeckName name = arguments.name();
  const bool is_axis = arguments.at_end() || (!end.empty() && arguments.is_next(end));
  arguments.refer(is_axis ? NameKind::axis : NameKind::point, name);
  if (is_axis) return {name, {}};
  return {{}, std::array<PointReference, 2>{name, read_point(arguments)}};
}

/// The region that a line about its shape is for.
SmoothingRegion& region_of(Arguments& arguments, SurfaceSmoothing& smoothing) {
  if (smoothing.regions.empty())
    arguments.fail_here("a shape stands behind the SURFACE line that it is for",
                        "write SURFACE = <names> first");
  SmoothingRegion& region = smoothing.regions.back();
  if (region.shape)
    arguments.fail_here("the surfaces of this region have a shape already",
                        "another SURFACE line begins another region");
  return region;
}

void read_circumferential(Arguments& arguments, SurfaceSmoothing& smoothing) {
  SmoothingRegion& region = region_of(arguments, smoothing);
  region.shape = CircumferentialShape{read_axis(arguments, "")};
}

void read_spherical(Arguments& arguments, SurfaceSmoothing& smoothing) {
  SmoothingRegion& region = region_of(arguments, smoothing);
  region.shape = SphericalShape{read_point(arguments)};
}

void read_toroidal(Arguments& arguments, SurfaceSmoothing& smoothing) {
  SmoothingRegion& region = region_of(arguments, smoothing);
  ToroidalShape shape{read_axis(arguments, "radius"), 0.0};
  arguments.expect("radius");
  arguments.skip_separator();
  shape.radius = arguments.positive();
  region.shape = shape;
}

void check(const SurfaceSmoothing& smoothing, DeckNames& names) {
  if (smoothing.regions.empty()) names.add_problem_of_block("has no SURFACE");
  std::set<std::string> known;
  for (const SmoothingRegion& region : smoothing.regions) {
    if (!region.shape)
      names.add_problem_of_block("has a SURFACE line without a shape",
                                 "CIRCUMFERENTIAL AXIS, SPHERICAL CENTER or TOROIDAL AXIS belongs behind it");
    for (const DeckName& surface : region.surfaces) {
      if (known.insert(fold(surface.text)).second) continue;
      names.add_problem_of_block("names the surface '" + surface.text + "' twice",
                                 "a contact surface of its own for each shape parts them");
    }
  }
  if (known.contains("all") && known.size() > 1)
    names.add_problem_of_block("has ALL beside other surfaces", "ALL stands for every contact surface");
}

const Table<SurfaceSmoothing>& smoothing_table() {
  using S = SurfaceSmoothing;
  const auto surfaces = read::names_of_or_all(NameKind::contact_surface);
  const auto read_surface = [surfaces](Arguments& arguments, S& smoothing) {
    const DeckLocation location = arguments.location();
    smoothing.regions.push_back({location, surfaces.read(arguments), {}});
  };
  const std::string axis = axis_syntax;
  static const Table<S> table(
      {
          row<S>(
              "surface", "= " + surfaces.syntax, read_surface,
              "Contact surfaces of one round shape, which the next line gives; each such line begins another "
              "region. ALL is every contact surface",
              "none")
              .references(NameKind::contact_surface),
          row<S>("circumferential axis", "= " + axis, read_circumferential,
                 "The surfaces are parts of a surface of revolution about an axis: by its name, through two "
                 "points, or through two points by coordinates [length]",
                 "none")
              .references(NameKind::axis)
              .references(NameKind::point),
          row<S>("spherical center", "= {<point>|<x> <y> <z>}", read_spherical,
                 "The surfaces are parts of a sphere about a point [length]", "none")
              .or_spelled("spherical centre")
              .references(NameKind::point),
          row<S>("toroidal axis", "= " + axis + " RADIUS <r>", read_toroidal,
                 "The surfaces are parts of a torus about an axis whose first point is the middle of the "
                 "circle, "
                 "of this radius, on which the centres of the arc lie [length]",
                 "none")
              .references(NameKind::axis)
              .references(NameKind::point),
      },
      check);
  return table;
}

void read_choice(Arguments& arguments, PairSettings& pair) {
  using K = SmoothingChoice::Kind;
  if (arguments.at_end()) arguments.fail_here("expected OFF, AUTO or a name after 'smoothing'");
  if (arguments.accept("off")) {
    pair.smoothing = SmoothingChoice{K::off, {}};
  } else if (arguments.accept("auto")) {
    pair.smoothing = SmoothingChoice{K::automatic, {}};
  } else {
    pair.smoothing = SmoothingChoice{K::named, arguments.reference(NameKind::surface_smoothing)};
  }
}

}  // namespace

std::vector<Row<ContactDefinition>> smoothing_rows() {
  using C = ContactDefinition;
  return {
      block<C, SurfaceSmoothing>("surface smoothing", Naming::required, smoothing_table, &C::smoothings,
                                 "Round shapes that the faces of contact surfaces stand for")
          .defines(NameKind::surface_smoothing),
  };
}

Row<PairSettings> smoothing_row() {
  return row<PairSettings>(
             "smoothing", "= {OFF|AUTO|<surface smoothing>}", read_choice,
             "Round shapes by which gaps count in place of those between flat faces: of a BEGIN SURFACE "
             "SMOOTHING; AUTO finds cylinders, spheres and tori by their nodes; contactsim's own line",
             "OFF")
      .references(NameKind::surface_smoothing);
}

}  // namespace contactsim
