// SPDX-License-Identifier: BSD-3-Clause
#include "parser/aprepro/control.hpp"

#include "support/catch.hpp"
#include "support/deck_dump.hpp"

using namespace contactsim;

namespace {

using Kind = ApreproNode::Kind;
using Test = ApreproBranch::Test;

std::string text_in(const std::string& text, const TextRange& range) {
  return text.substr(range.begin, range.end - range.begin);
}

/// Nodes as text: 'copied', {expression}, {{silent}}, if(condition)[...] and so on.
std::string shown(const std::vector<ApreproNode>& nodes, const std::string& text) {
  std::string all;
  for (const ApreproNode& node : nodes) {
    const std::string range = text_in(text, node.range);
    switch (node.kind) {
      case Kind::text:
        all += "'" + range + "'";
        break;
      case Kind::expression:
        all += "{" + range + "}";
        break;
      case Kind::silent:
        all += "{{" + range + "}}";
        break;
      case Kind::conditional:
      case Kind::choice:
        all += node.kind == Kind::conditional ? "if" : "switch " + range;
        for (const ApreproBranch& branch : node.branches)
          all += (branch.test == Test::otherwise ? "(*)" : "(" + text_in(text, branch.condition) + ")") +
                 "[" + shown(branch.body, text) + "]";
        break;
      case Kind::loop:
        all += "loop(" + range + ")[" + shown(node.body, text) + "]";
        break;
      case Kind::include:
        all += "include(" + range + ")";
        break;
      case Kind::joined_text:
        all += "joined ";
        break;
      case Kind::unclosed:
        all += "unclosed";
        break;
      default:
        all += "other ";
    }
  }
  return all;
}

struct Read {
  explicit Read(const std::string& text)
      : nodes(read_aprepro_structure(make_source("a.i", text), diagnostics)), tree(shown(nodes, text)) {}
  Diagnostics diagnostics;
  std::vector<ApreproNode> nodes;
  std::string tree;
};

std::string nested_ifs(int n) {
  std::string text;
  for (int i = 0; i < n; ++i) text += "{if(1)}\n";
  for (int i = 0; i < n; ++i) text += "{endif}\n";
  return text;
}

}  // namespace

TEST_CASE("a text is taken apart at its braces", "[parser][aprepro]") {
  CHECK(Read("").tree == "");
  CHECK(Read("plain\n").tree == "'plain\n'");
  const Read read("a{b + 1}c{{d}}\n");
  CHECK(read.tree == "'a'{b + 1}'c'{{d}}'\n'");
  CHECK(read.nodes[1].at == 1);  // the brace
  CHECK(read.nodes[1].range.begin == 2);
  CHECK(Read("\\{a\\}").tree == "'{a''}'");
  CHECK(Read("x{a\ny").tree == "'x'unclosed'\ny'");
}

TEST_CASE("lines of control belong to no branch", "[parser][aprepro]") {
  CHECK(Read("{if(a)}\nx\n{elseif(b)}\ny\n{else}\nz\n{endif}\nrest").tree ==
        "if(a)['x\n'](b)['y\n'](*)['z\n']'rest'");
  CHECK(Read("{loop(3, i)}\n{i}\n{endloop}\nrest").tree == "loop(3, i)[{i}'\n']'rest'");
  // What stands before the first case is dropped.
  CHECK(Read("{switch(a)}\ndropped\n{case(1)}\nx\n{default}\ny\n{endswitch}\n").tree ==
        "switch a(1)['x\n'](*)['y\n']");
  CHECK(Read("  {if(a)}\nx\n  {endif}\n").tree == "if(a)['x\n']");
}

TEST_CASE("constructs nest, and each end closes its own", "[parser][aprepro]") {
  CHECK(Read("{if(a)}\n{loop(2)}\n{if(b)}\nx\n{endif}\n{endloop}\n{else}\ny\n{endif}\n").tree ==
        "if(a)[loop(2)[if(b)['x\n']]](*)['y\n']");
}

TEST_CASE("text behind an if is joined to the next line, behind an end it goes away", "[parser][aprepro]") {
  CHECK(Read("{if(a)} text\nx\n{endif} note\nrest").tree == "if(a)[joined ' text''x\n']'rest'");
}

TEST_CASE("an include takes the line ends behind it", "[parser][aprepro]") {
  const Read read("{include(b.i)}\n\nrest");
  CHECK(read.tree == "include(b.i)'rest'");
  CHECK(read.nodes[0].ends_line);
  CHECK_FALSE(Read("{include(b.i)} rest").nodes[0].ends_line);
}

TEST_CASE("nothing is expanded between VERBATIM marks", "[parser][aprepro]") {
  CHECK(Read("a{VERBATIM(ON)}{b}{VERBATIM(OFF)}{c}").tree == "'a''{b}'{c}");
  CHECK(Read("{APREPRO(OFF)}{b}").tree == "'{b}'");  // to the end of the text
}

TEST_CASE("a construct without its end, and an end without its construct, have their places",
          "[parser][aprepro]") {
  const Read open("x\n {if(a)}\ny\n");
  CHECK(messages(open.diagnostics) == "a.i:2:2: error: this {if(...)} has no {endif}\n");
  CHECK(open.tree == "'x\n'if(a)['y\n']");
  CHECK(messages(Read("{endloop}\n").diagnostics) == "a.i:1:1: error: {endloop} without {loop(...)}\n");
  CHECK(messages(Read("{loop(2)}\n{if(a)}\n{endloop}\n").diagnostics) ==
        "a.i:2:1: error: this {if(...)} has no {endif}; it is missing before {endloop} at a.i:3:1\n");
  CHECK(messages(Read("{if(a)}\n{else}\n{else}\n{endif}\n").diagnostics) ==
        "a.i:3:1: error: this stands behind {else}, which must be last; the if begins at a.i:1:1\n");
}

TEST_CASE("constructs are nested up to 64 deep", "[parser][aprepro]") {
  CHECK(messages(Read(nested_ifs(64)).diagnostics) == "");
  CHECK(messages(Read(nested_ifs(65)).diagnostics) ==
        "a.i:65:1: error: ifs, switches and loops are nested more than 64 deep\n");
}
