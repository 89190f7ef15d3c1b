// SPDX-License-Identifier: BSD-3-Clause
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string_view>

#include "campaigns/decks/deck_harm.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace contactsim::test;
  const DeckLook look = size % 8 == 0 ? DeckLook::all : DeckLook::some;
  const std::string harm = find_deck_harm({reinterpret_cast<const char*>(data), size}, look);
  if (!harm.empty()) throw std::logic_error(harm);
  return 0;
}
