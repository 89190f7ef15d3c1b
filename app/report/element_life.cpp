// SPDX-License-Identifier: BSD-3-Clause
#include "app/report/element_life.hpp"

#include <algorithm>

#include "core/mesh/skin.hpp"

namespace contactsim {

namespace {

/// The faces outside at a time that lie inside at the start.
void add_exposed(const Mesh& mesh, std::span<const std::uint8_t> alive, std::uint32_t time,
                 const std::vector<ElementSide>& first_skin, ElementLife& life) {
  for (const ElementSide side : make_skin(mesh, alive).exterior) {
    if (!std::ranges::binary_search(first_skin, side)) life.exposed.try_emplace(side, time);
  }
}

}  // namespace

ElementLife find_element_life(const StoredVariables& stored, const Mesh& mesh, const StoredNames& names) {
  std::optional<std::vector<std::size_t>> status;
  for (const std::string& name : names.on_file("death_status")) {
    if (!status) status = find_stored(stored.element, name, 1);
  }
  if (!status) return {};
  const auto n_times = static_cast<std::uint32_t>(stored.times.size());
  ElementLife life;
  life.dead_from.assign(mesh.n_elements(), n_times);
  std::vector<std::uint8_t> alive(mesh.n_elements(), 1);
  std::vector<ElementSide> first_skin;
  bool has_died = false;
  for (std::uint32_t time = 0; time < n_times; ++time) {
    const std::vector<double> values = stored.element.read(status->front(), time);
    bool has_changed = false;
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (!(values[i] <= 0.0) || !alive[i]) continue;  // NaN: a block that does not have it
      if (first_skin.empty())
        first_skin = make_skin(mesh, std::vector<std::uint8_t>(alive.size(), 1)).exterior;
      life.dead_from[i] = time;
      alive[i] = 0;
      has_changed = true;
    }
    if (has_changed) add_exposed(mesh, alive, time, first_skin, life);
    has_died = has_died || has_changed;
  }
  return has_died ? life : ElementLife{};
}

}  // namespace contactsim
