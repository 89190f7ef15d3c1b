// SPDX-License-Identifier: BSD-3-Clause
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "core/functions/expression.hpp"
#include "parser/text/expression_grammar.hpp"
#include "support/catch.hpp"

using namespace contactsim;

namespace {

/// An expression as a tree that is evaluated slowly and plainly, and its text with as many parentheses as its
/// maker pleases.
struct Tree {
  std::string text;
  std::function<double(const std::array<double, 2>&)> value;
};

using Random = std::mt19937;

/// mt19937's numbers are the same everywhere; the distributions of the standard library are not.
int below(int n, Random& random) { return static_cast<int>(random() % static_cast<unsigned>(n)); }

Tree make_leaf(Random& random) {
  switch (below(4, random)) {
    case 0:
      return {"x", [](const auto& in) { return in[0]; }};
    case 1:
      return {"Y", [](const auto& in) { return in[1]; }};
    case 2:
      return {"2.5e-1", [](const auto&) { return 0.25; }};
    default:
      return {"3", [](const auto&) { return 3.0; }};
  }
}

Tree make_tree(int depth, Random& random);

Tree make_operation(int depth, Random& random) {
  const Tree a = make_tree(depth - 1, random), b = make_tree(depth - 1, random);
  const auto join = [&](const char* op, auto f) {
    return Tree{"(" + a.text + ")" + op + "(" + b.text + ")",
                [f, a, b](const auto& in) { return f(a.value(in), b.value(in)); }};
  };
  switch (below(9, random)) {
    case 0:
      return join(" + ", [](double p, double q) { return p + q; });
    case 1:
      return join("-", [](double p, double q) { return p - q; });
    case 2:
      return join("*", [](double p, double q) { return p * q; });
    case 3:
      return join("/", [](double p, double q) { return p / q; });
    case 4:
      return join("^", [](double p, double q) { return std::pow(p, q); });
    case 5:
      return join(" % ", [](double p, double q) { return std::fmod(p, q); });
    case 6:
      return join("<=", [](double p, double q) { return p <= q ? 1.0 : 0.0; });
    case 7:
      return join("&&", [](double p, double q) { return p != 0.0 && q != 0.0 ? 1.0 : 0.0; });
    default:
      return join("||", [](double p, double q) { return p != 0.0 || q != 0.0 ? 1.0 : 0.0; });
  }
}

Tree make_tree(int depth, Random& random) {
  if (depth == 0) return make_leaf(random);
  const int kind = below(8, random);
  if (kind < 4) return make_operation(depth, random);
  const Tree a = make_tree(depth - 1, random);
  if (kind == 4) return {"-(" + a.text + ")", [a](const auto& in) { return -a.value(in); }};
  if (kind == 5) return {"sin(" + a.text + ")", [a](const auto& in) { return std::sin(a.value(in)); }};
  const Tree b = make_tree(depth - 1, random);
  if (kind == 6) {
    return {"atan2(" + a.text + "," + b.text + ")",
            [a, b](const auto& in) { return std::atan2(a.value(in), b.value(in)); }};
  }
  const Tree c = make_tree(depth - 1, random);
  return {"((" + a.text + ") ? " + b.text + " : " + c.text + ")",
          [a, b, c](const auto& in) { return a.value(in) != 0.0 ? b.value(in) : c.value(in); }};
}

Expression compile(const std::string& text) {
  return compile_expression(read_deck_expression({}, text), std::vector<std::string>{"x", "y"});
}

/// Chains of terms without parentheses: precedence and grouping to the left, by two loops.
Tree make_sum_of_products(Random& random) {
  std::string text;
  double sum = 0.0;
  const int n_terms = 1 + below(5, random);
  for (int i = 0; i < n_terms; ++i) {
    const bool minus = i > 0 && below(2, random) == 0;
    if (i > 0) text += minus ? "-" : "+";
    double product = 1.0 + below(9, random);
    text += std::to_string(static_cast<int>(product));
    for (int j = below(3, random); j > 0; --j) {
      const int factor = 1 + below(9, random);
      const bool divide = below(2, random) == 0;
      text += (divide ? "/" : "*") + std::to_string(factor);
      product = divide ? product / factor : product * factor;
    }
    sum = i == 0 ? product : (minus ? sum - product : sum + product);
  }
  return {text, [sum](const auto&) { return sum; }};
}

}  // namespace

TEST_CASE("compiled expressions equal a slow tree bit for bit", "[core][expression]") {
  Random random(1);
  int n_finite = 0;
  for (int i = 0; i < 3000; ++i) {
    const Tree tree = make_tree(1 + below(5, random), random);
    const Expression compiled = compile(tree.text);
    for (const std::array<double, 2> at : {std::array{0.0, 1.0}, {-1.5, 0.3}, {7.0, -2.0}}) {
      const double expected = tree.value(at), found = compiled.evaluate(at);
      INFO(tree.text);
      if (std::isnan(expected)) {
        CHECK(std::isnan(found));
      } else {
        CHECK(std::bit_cast<std::uint64_t>(found) == std::bit_cast<std::uint64_t>(expected));
      }
      n_finite += std::isfinite(expected) ? 1 : 0;
    }
  }
  CHECK(n_finite > 3000);  // otherwise the comparison says little
}

TEST_CASE("chains of operators without parentheses group to the left", "[core][expression]") {
  Random random(2);
  for (int i = 0; i < 2000; ++i) {
    const Tree tree = make_sum_of_products(random);
    INFO(tree.text);
    CHECK(compile(tree.text).evaluate(std::array{0.0, 0.0}) == tree.value({}));
  }
}

TEST_CASE("random characters either compile or are refused inside the text", "[core][expression]") {
  const std::vector<std::string> pieces{"x",   "y",   "1", "2.5", "(", ")",  "?",  ":",  ";",   "=", "+",
                                        "-",   "*",   "/", "^",   "%", "<",  ">=", "&&", "||",  "!", ",",
                                        "sin", "max", "a", " ",   "&", "1e", ".",  "\"", "\x80"};
  Random random(3);
  int n_compiled = 0;
  for (int i = 0; i < 50000; ++i) {
    std::string text;
    for (int j = below(12, random); j >= 0; --j) {
      text += pieces[static_cast<std::size_t>(below(static_cast<int>(pieces.size()), random))];
    }
    INFO(text);
    try {
      compile(text).evaluate(std::array{1.0, 2.0});
      ++n_compiled;
    } catch (const ExpressionError& error) {
      if (error.offset > text.size() || error.length < 1 || error.text.empty()) FAIL("no place or text");
    }
  }
  CHECK(n_compiled > 500);
}
