// SPDX-License-Identifier: BSD-3-Clause
#include "campaigns/meshes/value_mutator.hpp"

#include <netcdf.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace contactsim::test {

namespace {

constexpr double inf = std::numeric_limits<double>::infinity();

constexpr std::array<double, 18> hostile_reals{std::numeric_limits<double>::quiet_NaN(),
                                               inf,
                                               -inf,
                                               1e200,
                                               -1e200,
                                               1e308,
                                               -1e308,
                                               1e-308,
                                               4.9e-324,
                                               0.0,
                                               -0.0,
                                               1.0,
                                               -1.0,
                                               0.5,
                                               2147483648.0,
                                               1e18,
                                               1e19,
                                               1e-30};

constexpr std::array<long long, 26> hostile_integers{0,
                                                     -1,
                                                     1,
                                                     2,
                                                     3,
                                                     4,
                                                     5,
                                                     6,
                                                     7,
                                                     8,
                                                     9,
                                                     16,
                                                     17,
                                                     99,
                                                     127,
                                                     128,
                                                     255,
                                                     65536,
                                                     2147483647,
                                                     -2147483648LL,
                                                     2147483648LL,
                                                     4294967295LL,
                                                     4294967296LL,
                                                     4294967297LL,
                                                     std::numeric_limits<long long>::max(),
                                                     std::numeric_limits<long long>::min()};

constexpr std::array<const char*, 34> hostile_texts{
    "",       " ",           "HEX",         "HEX8",        "hex27",
    "TETRA",  "TET10",       "WEDGE",       "PYRAMID",     "SHELL",
    "SHELL4", "TRI",         "TRISHELL",    "QUAD",        "BAR",
    "TRUSS",  "BEAM",        "SPHERE",      "CIRCLE",      "NSIDED",
    "NFACED", "SUPER",       "NULL",        "nonsense",    "HEX8999999999999999999999",
    "HEX-8",  "block_1",     "block_2",     "surface_1",   "lower",
    "LOWER",  "\x1b[31mred", "line\nbreak", "\xff\xfe\x80"};

constexpr std::array<int, 11> types{NC_BYTE,  NC_CHAR, NC_SHORT,  NC_INT,   NC_FLOAT, NC_DOUBLE,
                                    NC_UBYTE, NC_UINT, NC_USHORT, NC_INT64, NC_UINT64};

std::string draw_text(CaseRandom& random) {
  if (random.once_in(16)) return std::string(random.once_in(4) ? 70000 : 300, 'x');
  return random.pick(hostile_texts);
}

void change_texts(std::string& texts, CaseRandom& random) {
  if (texts.empty()) {
    texts = draw_text(random);
    return;
  }
  const std::size_t at = random.below(texts.size());
  switch (random.below(4)) {
    case 0:
      texts[at] = static_cast<char>(random.below(256));
      break;
    case 1:
      texts.assign(texts.size(), 'a');  // not one NUL
      break;
    case 2:
      texts.assign(texts.size(), '\0');
      break;
    default:
      const std::string text = draw_text(random);
      for (std::size_t i = 0; i <= text.size() && at + i < texts.size(); ++i) texts[at + i] = text.c_str()[i];
  }
}

template <class Number, class Hostile>
void change_numbers(std::vector<Number>& numbers, const Hostile& hostile, CaseRandom& random) {
  if (numbers.empty()) {
    numbers.assign(1, random.pick(hostile));
    return;
  }
  const std::size_t at = random.below(numbers.size()), from = random.below(numbers.size());
  switch (random.below(6)) {
    case 0:
      numbers[at] = numbers[from];
      break;
    case 1:
      std::fill(numbers.begin(), numbers.end(), numbers[at]);
      break;
    case 2:
      std::swap(numbers[at], numbers[from]);
      break;
    case 3:
      std::reverse(numbers.begin(), numbers.end());
      break;
    default:
      numbers[at] = random.pick(hostile);
  }
}

}  // namespace

void change_values(NetcdfValues& values, CaseRandom& random) {
  if (values.is_text()) {
    change_texts(values.texts, random);
  } else if (values.is_real()) {
    change_numbers(values.reals, hostile_reals, random);
  } else {
    change_numbers(values.integers, hostile_integers, random);
  }
}

void change_type(NetcdfValues& values, CaseRandom& random) {
  if (values.is_real()) {
    values.integers.clear();
    for (const double value : values.reals)
      values.integers.push_back(std::abs(value) < 1e18 ? static_cast<long long>(value) : 0);
  } else if (!values.is_text()) {
    values.reals.assign(values.integers.begin(), values.integers.end());
  }
  values.texts.resize(values.size(), '1');
  values.type = random.pick(types);
  if (values.is_real()) values.reals.resize(std::max(values.reals.size(), std::size_t{1}), 1.5);
  if (!values.is_real() && !values.is_text())
    values.integers.resize(std::max(values.integers.size(), std::size_t{1}), 1);
}

void change_attribute(std::vector<NetcdfAttribute>& attributes, CaseRandom& random) {
  if (attributes.empty()) {
    attributes.push_back(
        {random.once_in(2) ? "_id" : "elem_type", {NC_INT, "", {random.pick(hostile_integers)}, {}}});
    return;
  }
  const std::size_t at = random.below(attributes.size());
  NetcdfValues& values = attributes[at].values;
  switch (random.below(6)) {
    case 0:
      attributes.erase(attributes.begin() + static_cast<std::ptrdiff_t>(at));
      break;
    case 1:
      values = {NC_CHAR, draw_text(random), {}, {}};
      break;
    case 2:
      change_type(values, random);
      break;
    case 3:
      values.texts.resize(random.below(3), 'A');
      values.integers.resize(random.below(3), 1);
      values.reals.resize(random.below(3), 1.0);
      break;
    default:
      change_values(values, random);
  }
}

}  // namespace contactsim::test
