// SPDX-License-Identifier: BSD-3-Clause
// Every row of the deck language does what it says of itself: what is required is missed, what is named is
// looked up.
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "parser/command_tree.hpp"
#include "parser/commands/deck_commands.hpp"
#include "parser/text/syntax.hpp"
#include "support/catch.hpp"
#include "support/deck_dump.hpp"
#include "support/row_path.hpp"

using namespace contactsim;

namespace {

using K = NameKind;

/// What is said about a deck all of whose definitions count as used.
std::string said_of(const std::string& deck) {
  Diagnostics diagnostics;
  const Block block = parse_syntax(make_source("a.i", deck), diagnostics, read_no_file);
  DeckNames names;
  Binding binding{diagnostics, false, &names};
  SimulationDefinition simulation;
  deck_table(DeckForm::full).bind(block, simulation, binding);
  names.resolve(diagnostics);
  for (const K kind : {K::axis, K::coordinate_system, K::function, K::material, K::model, K::section,
                       K::rigid_body, K::finite_element_model, K::friction_model})
    names.use_all(kind, diagnostics);
  std::string said;
  for (const Diagnostic& found : diagnostics.all()) said += found.text + "; " + found.hint + "\n";
  return said;
}

/// Definitions named "near" of the kinds that are known in such a block.
///   has_time_control  whether the deck has one elsewhere, of which a procedure may have one only
std::string definitions_in(std::optional<K> home, bool has_time_control) {
  if (home == K::procedure && has_time_control) return "begin presto region near\nend\n";
  if (home == K::procedure) {
    return "begin time control\ntermination time = 1\nbegin time stepping block near\nstart time = "
           "0\nend\nend\n"
           "begin presto region near\nend\n";
  }
  if (home == K::contact_definition)
    return "contact surface near contains b\nbegin tied model near\nend\n"
           "begin surface smoothing near\nsurface = near\nspherical center = 0 0 0\nend\n";
  return "";
}

const std::string definitions_of_deck =
    "define point near with coordinates 0 0 0\ndefine direction near with vector 1 0 0\n"
    "define axis near with point near direction near\n"
    "define coordinate system near with point near point near point near\n"
    "begin function near\ntype = constant\nend\nbegin solid section near\nend\nbegin rigid body near\nend\n"
    "begin finite element model near\nend\nbegin output scheduler near\nend\n"
    "begin material near\nbegin parameters for model near\nend\nend\n";

/// A deck with the lines in the innermost of the blocks.
std::string deck_around(const std::vector<const RowText*>& around, const std::string& lines) {
  std::string begins, ends;
  const bool has_time_control = std::any_of(
      around.begin(), around.end(), [](const RowText* block) { return block->phrase == "time control"; });
  for (const RowText* block : around) {
    begins += "begin " + block->phrase + (block->syntax.starts_with('<') ? " n\n" : "\n");
    begins += definitions_in(block->defines, has_time_control);
    if (block->phrase == "sierra") begins += definitions_of_deck;
    ends += "end\n";
  }
  return begins + lines + ends;
}

/// A line, or block, whose names are "neer": the row's own syntax, or an example of it.
std::string line_naming(const RowText& row) {
  static const std::map<std::string, std::string> examples{
      {"define axis", "a with point neer direction neer"},
      {"define coordinate system", "c with point neer point neer point neer"},
      {"use finite element model", "neer"},
      {"compute global", "g as function neer"},
      {"compute nodal", "g as function neer"},
      {"compute element", "g as function neer"},
      {"circumferential axis", "= neer\nsurface = near\ncircumferential axis = neer neer"},
      {"spherical center", "= neer"},
      {"toroidal axis", "= neer radius 1\nsurface = near\ntoroidal axis = neer neer radius 1"},
      {"smoothing", "= neer"},
      {"model", "= neer during periods neer"}};
  if (row.is_block) return "begin " + row.phrase + " neer\nend\n";
  if (row.syntax.ends_with("[DURING <time stepping block> ...]")) return row.phrase + " = 1 during neer\n";
  const auto example = examples.find(row.phrase);
  const bool has_example = example != examples.end();
  const bool is_value = row.references.size() == 1 &&
                        row.syntax.starts_with(fmt::format("= <{}>", text_of(row.references[0]).word));
  INFO("a row of its own syntax needs an example: " << row.phrase);
  REQUIRE((has_example || is_value));
  return row.phrase + (is_value ? " = neer" : " " + example->second) + "\n";
}

bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST_CASE("every required row that is missing is reported by its name", "[parser][rows]") {
  int n_required = 0;
  for (const TreeRow& entry : command_tree()) {
    if (!entry.row->is_required) continue;
    ++n_required;
    INFO(path_of(entry));
    CHECK(entry.row->default_text == "required");
    CHECK(holds(said_of(deck_around(entry.around, "")),
                "has no " + upper(entry.row->phrase) + "; add " + deck_form_of(*entry.row)));
  }
  CHECK(n_required > 10);
}

TEST_CASE("of every choice one row must be given where one must be", "[parser][rows]") {
  for (const TreeRow& entry : command_tree()) {
    if (entry.row->choice.lack.empty()) continue;
    INFO(path_of(entry));
    const std::string said = said_of(deck_around(entry.around, ""));
    CHECK(holds(said, entry.row->choice.lack + "; give it "));
    CHECK(holds(said, upper(entry.row->phrase)));
  }
}

TEST_CASE("every row that names something reports an unknown name with the nearest one", "[parser][rows]") {
  int n_naming = 0;
  for (const TreeRow& entry : command_tree()) {
    for (const K kind : entry.row->references) {
      if (text_of(kind).is_in_mesh) continue;
      ++n_naming;
      INFO(path_of(entry));
      const bool is_of_smoothing = entry.around.back()->phrase == "surface smoothing";
      const std::string lines = kind == K::model  ? "material = near\n"
                                : is_of_smoothing ? "surface = near\n"
                                                  : "";
      const std::string said = said_of(deck_around(entry.around, lines + line_naming(*entry.row)));
      CHECK(holds(said, fmt::format("unknown {} 'neer'", text_of(kind).word)));
      CHECK(holds(said, "did you mean 'near'?"));
    }
  }
  CHECK(n_naming > 30);
}

TEST_CASE("a default that says required is that of a required row", "[parser][rows]") {
  for (const TreeRow& entry : command_tree()) {
    INFO(path_of(entry));
    const bool is_of_material = entry.around.size() > 1 && entry.around[1]->phrase == "material";
    if (is_of_material) continue;  // what a model needs depends on its other parameters: see its checks
    if (entry.row->default_text == "required") CHECK(entry.row->is_required);
  }
}
