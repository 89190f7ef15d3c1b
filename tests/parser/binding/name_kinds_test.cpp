// SPDX-License-Identifier: BSD-3-Clause
#include "parser/binding/name_kinds.hpp"

#include <set>

#include "support/catch.hpp"

using namespace contactsim;

TEST_CASE("every kind of name has a text of its own, at its own place", "[parser][names]") {
  std::set<std::string_view> words;
  for (int i = 0; i <= static_cast<int>(NameKind::assembly); ++i) {
    const auto kind = static_cast<NameKind>(i);
    const NameKindText& text = text_of(kind);
    INFO(text.word);
    CHECK(text.kind == kind);
    CHECK_FALSE(text.word.empty());
    CHECK(words.insert(text.word).second);
    if (text.home) CHECK(*text.home != kind);
    if (!text.owner.empty()) CHECK(text.home.has_value());
    if (text.redefines_built_in) CHECK_FALSE(text.built_in.empty());
    if (text.mistake) CHECK((text.mistake->kind != kind && !text.mistake->hint.empty()));
    CHECK(text.is_in_mesh == (kind >= NameKind::block));
  }
}

TEST_CASE("names of contact are known in their definition, those of a deck anywhere", "[parser][names]") {
  CHECK(text_of(NameKind::interaction).home == NameKind::contact_definition);
  CHECK(text_of(NameKind::contact_definition).home == NameKind::region);
  CHECK(text_of(NameKind::region).home == NameKind::procedure);
  CHECK(text_of(NameKind::model).home == NameKind::material);
  for (const NameKind kind :
       {NameKind::function, NameKind::material, NameKind::procedure, NameKind::direction})
    CHECK_FALSE(text_of(kind).home);
}

TEST_CASE("names that need no definition are those of the built-in function and laws", "[parser][names]") {
  CHECK(text_of(NameKind::function).built_in ==
        std::vector<std::string_view>{"sierra_constant_function_one"});
  const auto& laws = text_of(NameKind::friction_model).built_in;
  CHECK(std::set<std::string_view>(laws.begin(), laws.end()).contains("frictionless"));
  CHECK_FALSE(text_of(NameKind::function).redefines_built_in);
}
