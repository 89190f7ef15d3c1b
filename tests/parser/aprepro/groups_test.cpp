// SPDX-License-Identifier: BSD-3-Clause
#include "parser/aprepro/groups.hpp"

#include "support/catch.hpp"

using namespace contactsim;

namespace {

using GroupWord = ApreproGroup::Word;
using NodeKind = ApreproNode::Kind;

std::string inside_of(const std::string& text, const ApreproGroup& group) {
  return text.substr(group.inside.begin, group.inside.end - group.inside.begin);
}

GroupWord word_of(const std::string& text) { return read_aprepro_group(text, 0).word; }

std::string argument_of(const std::string& text) {
  const ApreproGroup group = read_aprepro_group(text, 0);
  return text.substr(group.argument.begin, group.argument.end - group.argument.begin);
}

}  // namespace

TEST_CASE("a group reaches from its brace behind the one that closes it", "[parser][aprepro]") {
  const std::string text = "ab {x + 1} c";
  const ApreproGroup group = read_aprepro_group(text, 3);
  CHECK(group.at == 3);
  CHECK(group.end == 10);
  CHECK(group.is_closed);
  CHECK_FALSE(group.is_silent);
  CHECK(group.word == GroupWord::none);
  CHECK(inside_of(text, group) == "x + 1");
  CHECK(read_aprepro_group("{}", 0).end == 2);
}

TEST_CASE("a silent group takes two braces at both ends", "[parser][aprepro]") {
  const std::string text = "{{x = 1}}y";
  const ApreproGroup group = read_aprepro_group(text, 0);
  CHECK(group.is_silent);
  CHECK(group.is_closed);
  CHECK(group.end == 9);
  CHECK(inside_of(text, group) == "x = 1");
  const ApreproGroup half = read_aprepro_group("{{x}y", 0);
  CHECK_FALSE(half.is_closed);
  CHECK(half.end == 5 - 1);                        // behind the one brace that there is
  CHECK(word_of("{{endif}}") == GroupWord::none);  // an expression: its name is the word's
}

TEST_CASE("a group that nothing closes ends at the next brace or with the text", "[parser][aprepro]") {
  const ApreproGroup cut = read_aprepro_group("{x", 0);
  CHECK_FALSE(cut.is_closed);
  CHECK(cut.end == 2);
  const ApreproGroup opened = read_aprepro_group("{x {y}", 0);
  CHECK_FALSE(opened.is_closed);
  CHECK(opened.end == 3);
  CHECK(read_aprepro_group("{", 0).end == 1);
}

TEST_CASE("braces in strings of a group do not count, those of broken strings do", "[parser][aprepro]") {
  CHECK(inside_of("{\"}\" // '{'}", read_aprepro_group("{\"}\" // '{'}", 0)) == "\"}\" // '{'");
  CHECK(read_aprepro_group("{'two\n}' }", 0).end == 10);
  CHECK(read_aprepro_group("{\"two\n}\" }", 0).end == 7);
  CHECK(read_aprepro_group("{it's}", 0).end == 6);
}

TEST_CASE("a string is skipped with its quotes, a broken one by a character", "[parser][aprepro]") {
  CHECK(skip_aprepro_string("\"ab\" c", 0) == 4);
  CHECK(skip_aprepro_string("x'a\nb'", 1) == 6);
  CHECK(skip_aprepro_string("\"a\nb\"", 0) == 1);
  CHECK(skip_aprepro_string("'ab", 0) == 1);
  CHECK(skip_aprepro_string("\"", 0) == 1);
  CHECK(skip_aprepro_string("''", 0) == 2);
}

TEST_CASE("control words are known by their form", "[parser][aprepro]") {
  const auto [text, word] = GENERATE(table<std::string, GroupWord>({
      {"{if(x)}", GroupWord::if_true},
      {"{ IF ( x ) }", GroupWord::if_true},
      {"{if}", GroupWord::none},
      {"{if x}", GroupWord::none},
      {"{if()}", GroupWord::if_true},
      {"{Ifdef(x)}", GroupWord::if_defined},
      {"{ifndef(x)}", GroupWord::if_undefined},
      {"{elseif(x)}", GroupWord::else_if},
      {"{else}", GroupWord::otherwise},
      {"{ELSE}", GroupWord::otherwise},
      {"{else(x)}", GroupWord::none},
      {"{EndIf}", GroupWord::end_if},
      {"{endiff}", GroupWord::none},
      {"{switch(x)}", GroupWord::choose},
      {"{case(1)}", GroupWord::one_case},
      {"{default}", GroupWord::default_case},
      {"{Default}", GroupWord::none},
      {"{endswitch}", GroupWord::end_choose},
      {"{EndSwitch}", GroupWord::none},
      {"{loop(3)}", GroupWord::loop},
      {"{Endloop}", GroupWord::end_loop},
      {"{include(a)}", GroupWord::include},
      {"{cinclude(a)}", GroupWord::optional_include},
      {"{ECHO}", GroupWord::echo_on},
      {"{ECHO(ON)}", GroupWord::echo_on},
      {"{ECHO( OFF )}", GroupWord::echo_off},
      {"{ECHO(off)}", GroupWord::none},
      {"{echo}", GroupWord::none},
      {"{NOECHO}", GroupWord::echo_off},
      {"{IMMUTABLE(ON)}", GroupWord::immutable_on},
      {"{IMMUTABLE(OFF)}", GroupWord::immutable_off},
      {"{IMMUTABLE}", GroupWord::none},
      {"{VERBATIM(ON)}", GroupWord::verbatim_on},
      {"{VERBATIM(OFF)}", GroupWord::verbatim_off},
      {"{APREPRO(OFF)}", GroupWord::verbatim_on},
      {"{APREPRO(ON)}", GroupWord::verbatim_off},
      {"{if(x) + 1}", GroupWord::none},
      {"{x}", GroupWord::none},
      {"{}", GroupWord::none},
      {"{ }", GroupWord::none},
      {"{3}", GroupWord::none},
      {"{endif", GroupWord::none},
  }));
  INFO(text);
  CHECK(word_of(text) == word);
}

TEST_CASE("the argument of a control word is what its outer parentheses hold", "[parser][aprepro]") {
  CHECK(argument_of("{if((a) && (b))}") == "(a) && (b)");
  CHECK(argument_of("{loop (2, i) }") == "2, i");
  CHECK(argument_of("{if( x )}") == " x ");
  CHECK(argument_of("{endif}") == "");
}

TEST_CASE("words begin, split and end constructs of their own kind", "[parser][aprepro]") {
  using Construct = std::optional<NodeKind>;
  struct Row {
    GroupWord word;
    Construct begun, split, ended;
  };
  const Construct none, conditional = NodeKind::conditional, choice = NodeKind::choice, loop = NodeKind::loop;
  for (const Row& row :
       {Row{GroupWord::if_true, conditional, none, none}, Row{GroupWord::if_defined, conditional, none, none},
        Row{GroupWord::if_undefined, conditional, none, none},
        Row{GroupWord::else_if, none, conditional, none}, Row{GroupWord::otherwise, none, conditional, none},
        Row{GroupWord::end_if, none, none, conditional}, Row{GroupWord::choose, choice, none, none},
        Row{GroupWord::one_case, none, choice, none}, Row{GroupWord::default_case, none, choice, none},
        Row{GroupWord::end_choose, none, none, choice}, Row{GroupWord::loop, loop, none, none},
        Row{GroupWord::end_loop, none, none, loop}, Row{GroupWord::include, none, none, none},
        Row{GroupWord::none, none, none, none}}) {
    INFO(static_cast<int>(row.word));
    CHECK(construct_begun_by(row.word) == row.begun);
    CHECK(construct_split_by(row.word) == row.split);
    CHECK(construct_ended_by(row.word) == row.ended);
  }
}

TEST_CASE("a branch is decided on as its word says", "[parser][aprepro]") {
  using Test = ApreproBranch::Test;
  CHECK(test_of(GroupWord::if_true) == Test::is_true);
  CHECK(test_of(GroupWord::else_if) == Test::is_true);
  CHECK(test_of(GroupWord::if_defined) == Test::is_defined);
  CHECK(test_of(GroupWord::if_undefined) == Test::is_undefined);
  CHECK(test_of(GroupWord::one_case) == Test::equals);
  CHECK(test_of(GroupWord::otherwise) == Test::otherwise);
  CHECK(test_of(GroupWord::default_case) == Test::otherwise);
}

TEST_CASE("each control word is suggested once", "[parser][aprepro]") {
  CHECK(aprepro_control_words() == std::vector<std::string>{"if", "ifdef", "ifndef", "elseif", "else",
                                                            "endif", "switch", "case", "default", "endswitch",
                                                            "loop", "endloop", "include", "cinclude", "ECHO",
                                                            "NOECHO", "IMMUTABLE", "VERBATIM", "APREPRO"});
}
