// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace contactsim {

/// A surface of an ownership table.
struct TableSurface {
  std::string name;
  std::string kind;                                           ///< "face", "node"; "" in a list of facets
  std::vector<std::pair<std::string, double>> figures;        ///< claimed, owned, ..., "lofted top"
  std::vector<std::pair<std::string, std::int64_t>> lost_to;  ///< winner and how much it kept away
};

/// A facet and its owner.
struct TableFacet {
  std::uint32_t surface = 0;  ///< position in the table
  std::uint32_t kind = 0;     ///< position in OwnershipTable::kinds
  std::int64_t element = 0;   ///< Exodus id, of a node where the kind says so
  std::int64_t side = 0;      ///< Exodus side number
  std::uint32_t block = 0;    ///< position in OwnershipTable::blocks
  double area = 0.0;          ///< [length^2]
};

/// Two surfaces that may touch: what a table says of them, as names and texts.
struct TablePair {
  std::string first, second, interaction;  ///< names
  std::vector<std::pair<std::string, std::string>> settings;
};

/// Who owns what, as far as a file says it.
struct OwnershipTable {
  std::vector<TableSurface> surfaces;  ///< in deck order
  std::vector<TableFacet> facets;
  std::vector<std::string> kinds, blocks;  ///< of facets, each name once
  std::vector<TablePair> pairs;
  bool has_figures = false, has_facets = false, has_pairs = false;
};

/// Takes over an ownership table of --surfaces-json. Throws FileError where it is not as it should be.
void read_surfaces_json(const std::string& path, const std::string& text, OwnershipTable& table);

/// Takes over a list of facets of --surfaces-csv, with surfaces that the table does not have yet. Throws
/// FileError naming the line that is not as it should be.
void read_surfaces_csv(const std::string& path, const std::string& text, OwnershipTable& table);

}  // namespace contactsim
