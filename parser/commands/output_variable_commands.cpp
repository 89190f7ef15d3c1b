// SPDX-License-Identifier: BSD-3-Clause
#include "parser/commands/output_variable_commands.hpp"

#include <fmt/format.h>

#include "parser/commands/variable_readers.hpp"

namespace contactsim {

namespace {

using Requests = std::vector<VariableRequest>;

/// INCLUDE, ON or EXCLUDE and the parts, which run to the line's end.
void read_parts(Arguments& arguments, VariableRequest& request) {
  NamedParts parts;
  if (arguments.accept("exclude")) {
    parts.are_excluded = true;
  } else if (!arguments.accept("include") && !arguments.accept("on")) {
    return;
  }
  arguments.skip_separator();
  parts.names = arguments.names();
  request.place = std::move(parts);
}

/// <kind> <id>, after AT. The kind must be that of the variable.
void read_entity(Arguments& arguments, VariableRequest& request) {
  if (arguments.at_end()) arguments.fail_here("expected an entity such as NODE 42 after 'at'");
  const Word& kind = arguments.peek();
  const VariableLocation location = read_location(arguments);
  if (request.location == VariableLocation::any) request.location = location;
  const bool is_single = location == VariableLocation::nodal || location == VariableLocation::element ||
                         location == VariableLocation::edge || location == VariableLocation::face;
  if (location != request.location || !is_single) {
    arguments.fail(kind, fmt::format("'{}' cannot be read at a {}", request.variable.name.text, kind.text),
                   "the two kinds of the line must agree: NODE v AT NODE 42");
  }
  const DeckLocation place = arguments.at_end() ? arguments.location() : arguments.peek().location;
  request.place = SingleEntity{arguments.positive_integer(), place};
}

/// AT <kind> <id> or NEAREST LOCATION <x> <y> <z>, if either is next.
void read_single_place(Arguments& arguments, VariableRequest& request, RequestPlaces places) {
  const bool is_at = arguments.is_next("at");
  if (!is_at && !arguments.is_next("nearest")) return;
  if (places == RequestPlaces::parts) {
    arguments.fail_here("single nodes and elements are for HISTORY and HEARTBEAT OUTPUT");
  }
  if (arguments.accept("at")) {
    read_entity(arguments, request);
  } else {
    arguments.expect("nearest");
    arguments.expect("location");
    arguments.skip_separator();
    request.place = NearestEntity{arguments.vector()};
  }
}

void read_alias(Arguments& arguments, VariableRequest& request) {
  if (arguments.accept("as")) request.alias = arguments.text();
}

void read_requests(Arguments& arguments, VariableLocation location, RequestPlaces places,
                   Requests& requests) {
  do {
    VariableRequest request;
    request.location = location;
    request.variable = read_variable(arguments);
    read_alias(arguments, request);
    read_single_place(arguments, request, places);
    if (request.alias.empty()) read_alias(arguments, request);
    read_parts(arguments, request);
    requests.push_back(std::move(request));
  } while (!arguments.at_end());
}

Row<Requests> request_row(std::string_view phrase, VariableLocation location, RequestPlaces places,
                          std::string help) {
  const std::string at =
      places == RequestPlaces::entities ? " [{AT <kind> <id>|NEAREST LOCATION <x> <y> <z>}]" : "";
  if (!at.empty()) help += "; the location is [length]";
  return row<Requests>(
      phrase, fmt::format("= <variable>{} [AS <alias>] [{{INCLUDE|EXCLUDE}} <part> ...] ...", at),
      [location, places](Arguments& arguments, Requests& requests) {
        read_requests(arguments, location, places, requests);
      },
      help, "none");
}

/// VARIABLE = NODE v AT NODE 42 AS a.
void read_old_request(Arguments& arguments, Requests& requests) {
  const VariableLocation location = read_location(arguments);
  read_requests(arguments, location, RequestPlaces::entities, requests);
}

}  // namespace

std::vector<Row<Requests>> variable_request_rows(RequestPlaces places) {
  using L = VariableLocation;
  const auto make = [places](const char* phrase, L location, const char* help) {
    return request_row(phrase, location, places, help);
  };
  std::vector<Row<Requests>> rows{
      make("variables", L::any, "Variables of any kind, in their own dimensions"),
      make("global variables", L::global, "Values of the whole model").or_spelled("global"),
      make("nodal variables", L::nodal,
           "Values at nodes; v(x) is one component, v(magnitude) the length of a vector")
          .or_spelled("node variables")
          .or_spelled("nodal")
          .or_spelled("node"),
      make("element variables", L::element, "Values in elements").or_spelled("element"),
      make("edge variables", L::edge, "Values on edges").or_spelled("edge"),
      make("face variables", L::face, "Values on faces").or_spelled("face"),
      make("nodeset variables", L::node_set, "Values on nodes of node sets")
          .or_spelled("node set variables")
          .or_spelled("nodeset")
          .or_spelled("node set"),
      make("surface variables", L::side_set, "Values on faces of side sets")
          .or_spelled("sideset variables")
          .or_spelled("side set variables")
          .or_spelled("surface")
          .or_spelled("sideset")
          .or_spelled("side set"),
  };
  if (places == RequestPlaces::entities) {
    rows.push_back(row<Requests>("variable", "= <kind> <variable> [AT <kind> <id>] [AS <alias>]",
                                 read_old_request, "Older form of the lines above", "none"));
  }
  return rows;
}

}  // namespace contactsim
