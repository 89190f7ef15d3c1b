// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/diagnostics.hpp"
#include "core/mesh/entity_names.hpp"
#include "io/pieces/exodus_file.hpp"

namespace contactsim {

/// One entry of an Exodus id array: a block or a set.
struct EntityRow {
  std::size_t number = 0;  ///< from 1, the N in the names of its dimensions and variables
  std::int64_t id = 0;
  std::string name;      ///< as stored, "" when there is none
  bool is_null = false;  ///< declared but empty, without dimensions and variables of its own
};

/// "block 3 (lower)", or "block 3" when the name adds nothing.
std::string describe(EntityKind kind, std::int64_t id, std::string_view name);

/// Adds a warning that names the file and no deck line.
void warn(Diagnostics& warnings, const ExodusFile& file, std::string_view id, const std::string& text);

/// The blocks, side sets or node sets that the file declares, in its order. Warns of entries that were
/// declared and never written, which are left out, and of names that belong to another id. Throws FileError
/// for missing ids and for what check_identities refuses.
std::vector<EntityRow> read_entity_rows(const ExodusFile& file, EntityKind kind, Diagnostics& warnings);

/// Throws FileError for negative or repeated ids, and for two entities that go by one name. Warns of names
/// that belong to another id.
void check_identities(const ExodusFile& file, EntityKind kind, const std::vector<EntityRow>& rows,
                      Diagnostics& warnings);

}  // namespace contactsim
