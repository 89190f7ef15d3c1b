// SPDX-License-Identifier: BSD-3-Clause
#include "parser/commands/contact_surface_commands.hpp"

#include "parser/commands/row_lists.hpp"

namespace contactsim {

namespace {

/// The "CONTAINS a b c" part of the line forms.
template <class Line>
void read_contains(Arguments& arguments, ContactDefinition& contact) {
  Line line;
  line.location = arguments.location();
  line.name = arguments.definition(NameKind::contact_surface);
  if (arguments.is_next("contacts"))
    arguments.fail_here("unknown word 'contacts'", "did you mean 'contains'?");
  arguments.expect("contains");
  line.items = arguments.names();
  contact.surface_commands.emplace_back(std::move(line));
}

void read_skin_all_blocks(Arguments& arguments, ContactDefinition& contact) {
  if (arguments.at_end()) {
    arguments.leave_open(NameKind::contact_surface);  // lest every name of a block be an error too
    arguments.fail_here("expected '= ON' after 'skin all blocks'", "write SKIN ALL BLOCKS = ON");
  }
  const bool is_on = arguments.on_off();
  SkinAllBlocks skin{arguments.location(), {}};
  if (arguments.accept("exclude")) {
    arguments.skip_separator();
    skin.excluded = arguments.names();
  }
  if (!is_on) return;
  arguments.leave_open(NameKind::contact_surface);
  contact.surface_commands.emplace_back(std::move(skin));
}

void read_contact_all_blocks(Arguments& arguments, ContactDefinition& contact) {
  arguments.leave_open(NameKind::contact_surface);
  contact.surface_commands.emplace_back(SkinAllBlocks{arguments.location(), {}});
}

void refuse_second_subdomain(const Arguments& arguments, const ContactDefinition& contact) {
  if (!contact.subdomain) return;
  arguments.fail_here("a second RESTRICT CONTACT in one contact definition",
                      "the first stands at " + to_string(contact.subdomain->location));
}

void read_sphere(Arguments& arguments, ContactDefinition& contact) {
  refuse_second_subdomain(arguments, contact);
  ContactSphere sphere{arguments.positive(), {}};
  arguments.expect("and");
  arguments.expect("point");
  arguments.skip_separator();
  sphere.point = arguments.vector();
  contact.subdomain = {arguments.location(), sphere};
}

void read_box(Arguments& arguments, ContactDefinition& contact) {
  refuse_second_subdomain(arguments, contact);
  const Eigen::Vector3d corner = arguments.vector();
  arguments.expect("and");
  const Eigen::Vector3d opposite = arguments.vector();
  contact.subdomain = {arguments.location(),
                       ContactBox{corner.cwiseMin(opposite), corner.cwiseMax(opposite)}};
}

Eigen::Vector3d read_direction(Arguments& arguments) {
  Eigen::Vector3d direction = arguments.vector();
  if (direction.isZero(0.0)) arguments.fail_here("the normal must not be the zero vector");
  return direction;
}

void read_subset(Arguments& arguments, ContactSurfaceBlock& surface) {
  SurfaceSubset subset{arguments.name(), {}};
  arguments.expect("with");
  arguments.expect("normal");
  arguments.skip_separator();
  subset.normal = read_direction(arguments);
  arguments.define(NameKind::contact_surface,
                   {surface.name.text + "_" + subset.name.text, subset.name.location});
  surface.subsets.push_back(subset);
}

void read_elements(Arguments& arguments, ContactSurfaceBlock& surface) {
  while (!arguments.at_end()) {
    const DeckLocation location = arguments.peek().location;
    surface.elements.push_back({arguments.positive_integer(), location});
  }
}

const Table<ContactSurfaceBlock>& contact_surface_table() {
  using S = ContactSurfaceBlock;
  using K = NameKind;
  static const Table<S> table(joined<S>({
      one_of<S>({"names nothing", ""}, {flag("include all blocks", &S::includes_all_blocks,
                                             "Every block of the mesh but those of particles"),
                                        row("block", read::names_of(K::block), &S::blocks,
                                            "Blocks to skin (solids) or loft (shells, beams)"),
                                        row<S>("element", "= <id> ...", read_elements,
                                               "Exodus ids of single lofted elements", "none"),
                                        row("surface", read::names_of(K::side_set), &S::side_sets,
                                            "Side sets whose faces are taken, interior ones too"),
                                        row("assembly", read::names_of(K::assembly), &S::assemblies,
                                            "Assemblies of blocks or of side sets")}),
      {row("remove block", read::names_of(K::block), &S::removed_blocks, "Blocks to leave out"),
       row("remove surface", read::names_of(K::side_set), &S::removed_side_sets,
           "Side sets whose faces are left out"),
       row<S>("subset", "<name> WITH NORMAL <x> <y> <z>", read_subset,
              "Moves faces within 63.3 degrees of the normal [1] to the surface <surface>_<name>", "none")
           .defines(K::contact_surface)},
  }));
  return table;
}

}  // namespace

std::vector<Row<ContactDefinition>> contact_surface_rows() {
  using C = ContactDefinition;
  return {
      row<C>("contact surface", "<name> CONTAINS <block, side set, assembly, analytic object> ...",
             read_contains<ContactSurfaceLine>, "Makes a surface of block skins, lofts and side-set faces",
             "none")
          .defines(NameKind::contact_surface),
      row<C>("contact node set", "<name> CONTAINS <node set, side set, block, assembly> ...",
             read_contains<ContactNodeSetLine>, "Makes a surface of nodes, which meets faces only", "none")
          .defines(NameKind::contact_surface),
      block<C, ContactSurfaceBlock>(
          "contact surface", Naming::required, contact_surface_table,
          [](C& contact, ContactSurfaceBlock part) {
            contact.surface_commands.emplace_back(std::move(part));
          },
          "Makes a surface from adds and removes, split by normals if asked")
          .defines(NameKind::contact_surface),
      row<C>("skin all blocks", "= {ON|OFF} [EXCLUDE <block or assembly> ...]", read_skin_all_blocks,
             "Makes one surface per block, named as the block, at this place in the deck", "OFF"),
      row<C>("contact all blocks", "", read_contact_all_blocks, "Older spelling of SKIN ALL BLOCKS = ON",
             "OFF"),
      row<C>("restrict contact to subdomain defined by radius", "<r> AND POINT <x> <y> <z>", read_sphere,
             "Keeps contact inside a sphere: radius and centre [length]", "none"),
      row<C>("restrict contact to box defined by", "<x> <y> <z> AND <x> <y> <z>", read_box,
             "Keeps contact inside a box along the axes: two opposite corners [length]; what has a node "
             "outside at the start is left out; contactsim's own line",
             "none"),
  };
}

const Table<AnalyticPlane>& analytic_object_table() {
  using A = AnalyticPlane;
  static const Table<A> table({
      row<A>(
          "type", "= PLANE", [](Arguments& arguments, A&) { arguments.expect("plane"); },
          "Kind of object; only planes are known", "PLANE"),
      row<A>(
          "normal direction", "= <x> <y> <z>",
          [](Arguments& arguments, A& plane) { plane.normal = read_direction(arguments); },
          "Normal of the plane towards its free side [1]", "none")
          .required(),
      row("origin", read::vector3, &A::origin, "A point of the plane [length]", "0 0 0"),
      row("scale factor", read::positive, &A::scale_factor,
          "Size of the drawn square, in units of three times the mesh's largest length [1]"),
  });
  return table;
}

}  // namespace contactsim
