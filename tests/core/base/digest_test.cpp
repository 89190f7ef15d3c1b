// SPDX-License-Identifier: BSD-3-Clause
#include "core/base/digest.hpp"

#include <set>
#include <string>

#include "support/catch.hpp"

using namespace contactsim;

TEST_CASE("a digest does not depend on how the bytes are cut", "[core][digest]") {
  const std::string text = "all that a run needs to go on";
  const auto [first, second] = GENERATE(table<std::size_t, std::size_t>({{0, 3}, {3, 4}, {8, 16}, {7, 29}}));
  Digest pieces;
  pieces.add_values(std::span<const char>(text).subspan(0, first));
  pieces.add_values(std::span<const char>(text).subspan(first, second - first));
  pieces.add_values(std::span<const char>(text).subspan(second));
  CHECK(pieces.value() == digest_of(text));
}

TEST_CASE("every flipped bit and every length has a digest of its own", "[core][digest]") {
  const std::string text(37, 'a');
  std::set<std::uint64_t> digests{digest_of(text)};
  for (std::size_t bit = 0; bit < 8 * text.size(); ++bit) {
    std::string other = text;
    other[bit / 8] = static_cast<char>(other[bit / 8] ^ (1 << (bit % 8)));
    digests.insert(digest_of(other));
  }
  CHECK(digests.size() == 1 + 8 * text.size());
  for (std::size_t n = 0; n < text.size(); ++n) digests.insert(digest_of(std::string(n, '\0')));
  CHECK(digests.size() == 1 + 9 * text.size());
}

TEST_CASE("top bits that flip in two words do not cancel", "[core][digest]") {
  std::string text(16, '\0');
  text[7] = text[15] = '\x80';
  CHECK(digest_of(text) != digest_of(std::string(16, '\0')));
}

TEST_CASE("no bytes, wherever they are, change nothing", "[core][digest]") {
  Digest digest;
  const std::uint64_t empty = digest.value();
  digest.add({});
  CHECK(digest.value() == empty);
  digest.add_values(std::span<const char>("abc", 3));
  const std::uint64_t begun = digest.value();
  digest.add_values(std::span<const double>());
  CHECK(digest.value() == begun);
}
