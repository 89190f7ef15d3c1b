// SPDX-License-Identifier: BSD-3-Clause
#include "parser/text/value_grammar.hpp"

#include <bit>
#include <random>
#include <string>

#include "parser/text/phrases.hpp"
#include "parser/text/word_grammar.hpp"
#include "support/deck_line.hpp"

using namespace contactsim;

namespace {

/// What one of the rules does with words: the values it gives as text, or what it expected, and how many
/// words it leaves.
struct Outcome {
  std::string values;
  std::string expected;
  std::size_t n_left = 0;
};

bool operator==(const Outcome& a, const Outcome& b) {
  return a.values == b.values && a.expected == b.expected && a.n_left == b.n_left;
}

std::ostream& operator<<(std::ostream& out, const Outcome& outcome) {
  return out << '"' << outcome.values << "\", expected '" << outcome.expected << "', left " << outcome.n_left;
}

std::string show(double value) { return std::to_string(std::bit_cast<std::uint64_t>(value)) + ' '; }
std::string show(std::int64_t value) { return std::to_string(value) + ' '; }
std::string show(const DeckName& name) {
  return name.text + '@' + std::to_string(name.location.column) + ' ';
}

template <class List>
std::string show_all(const List& list) {
  std::string text;
  for (const auto& value : list) text += show(value);
  return text;
}

template <class Take>
Outcome taken(Words words, const Take& take) {
  try {
    const std::string values = take(words);
    return {values, "", words.size()};
  } catch (const ValueError& error) {
    return {"", error.expected, words.size()};
  }
}

/// The slow reader: words one after the other, n of them, or all and at least one.
template <class ReadWord>
Outcome slowly_taken(Words words, std::size_t n, const char* expected, const ReadWord& read_word) {
  std::string values;
  for (std::size_t i = 0; n == 0 ? i == 0 || i < words.size() : i < n; ++i) {
    if (i == words.size()) return {"", expected, 0};
    const auto value = read_word(words[i]);
    if (words[i].kind == WordKind::symbol || !value) return {"", expected, words.size() - i};
    values += show(*value);
  }
  return {values, "", n == 0 ? 0 : words.size() - n};
}

/// Every choice one by one.
std::optional<std::size_t> slow_choice(Words& words, const std::vector<std::string>& phrases) {
  std::size_t best = phrases.size(), n_best = 0;
  for (std::size_t i = 0; i < phrases.size(); ++i) {
    const std::size_t n = match_phrase(split_phrase(phrases[i]), words);
    if (n <= n_best) continue;
    best = i;
    n_best = n;
  }
  words = words.subspan(n_best);
  return n_best > 0 ? std::optional(best) : std::nullopt;
}

std::vector<Word> words_of(const std::string& line) { return command_of("size " + line).words; }

Words behind_phrase(const std::vector<Word>& words) { return Words(words).subspan(1); }

class RandomLines {
 public:
  std::vector<Word> next(const std::vector<std::string>& texts) {
    std::vector<Word> words(random_() % 6);
    for (Word& word : words) {
      const auto kind = random_() % 12;
      word.text = texts[random_() % texts.size()];
      word.kind = kind == 0 ? WordKind::symbol : kind == 1 ? WordKind::quoted : WordKind::bare;
      if (word.kind == WordKind::symbol && random_() % 2 == 0) word.text = "=";
      word.location.column = static_cast<int>(&word - words.data()) + 1;
    }
    return words;
  }

 private:
  std::mt19937 random_{20240608};
};

}  // namespace

TEST_CASE("single values take one word", "[parser][value]") {
  const std::vector<Word> line = words_of("1.5d1 -7 \"b c\" rest");
  Words words = behind_phrase(line);
  CHECK(take_real(words) == 15.0);
  CHECK(take_integer(words) == -7);
  const DeckName name = take_name(words);
  CHECK(name.text == "b c");
  CHECK(name.location.column == 15);
  CHECK(words.size() == 1);
}

TEST_CASE("a vector is three numbers, a list all that remain", "[parser][value]") {
  const std::vector<Word> line = words_of("1, 2 3 4 5");
  Words words = behind_phrase(line);
  CHECK(take_vector(words) == Eigen::Vector3d(1.0, 2.0, 3.0));
  CHECK(words.size() == 2);
  Words reals = words, integers = words, names = words;
  CHECK(take_reals(reals) == std::vector<double>{4.0, 5.0});
  CHECK(take_integers(integers) == std::vector<std::int64_t>{4, 5});
  CHECK(take_names(names).size() == 2);
  CHECK((reals.empty() && integers.empty() && names.empty()));
}

TEST_CASE("what does not fit stays in front, and its rule says what is expected", "[parser][value]") {
  const auto stop = [](const std::string& line, auto take) {
    const std::vector<Word> words = words_of(line);
    return taken(behind_phrase(words), [&](Words& left) { return take(left), std::string(); });
  };
  CHECK(stop("two 3", take_real) == Outcome{"", "a number", 2});
  CHECK(stop("1 2", take_vector) == Outcome{"", "a number", 0});
  CHECK(stop("1 2 z 4", take_vector) == Outcome{"", "a number", 2});
  CHECK(stop("1 2 z 4", take_reals) == Outcome{"", "a number", 2});
  CHECK(stop("1 2.5", take_integers) == Outcome{"", "an integer", 1});
  CHECK(stop("a b < c", take_names) == Outcome{"", "a name", 2});
  CHECK(stop("", take_names) == Outcome{"", "a name", 0});
}

TEST_CASE("separators and keywords are bare words in any case", "[parser][value]") {
  const auto n_left = [](const std::string& line, auto take) {
    const std::vector<Word> words = words_of(line);
    Words left = behind_phrase(words);
    const bool is_taken = take(left);
    CHECK(is_taken == (left.size() < words.size() - 1));
    return left.size();
  };
  for (const char* line : {"= 3", "is 3", "ARE 3"}) CHECK(n_left(line, take_separator) == 1);
  for (const char* line : {"< 3", "\"is\" 3", "isnt 3", "== 3"}) CHECK(n_left(line, take_separator) == 2);
  CHECK(n_left("", take_separator) == 0);
  const auto take_exclude = [](Words& words) { return take_keyword(words, "exclude"); };
  CHECK(n_left("Exclude a", take_exclude) == 1);
  for (const char* line : {"\"exclude\" a", "exclud a", "excludes a"}) CHECK(n_left(line, take_exclude) == 2);
}

TEST_CASE("the longest choice that fits wins", "[parser][value]") {
  const Choices choices({"piecewise", "piecewise linear", "node_set", "node"});
  const auto chosen = [&](const std::string& line) {
    const std::vector<Word> words = words_of(line);
    Words left = behind_phrase(words);
    const auto position = take_choice(left, choices);
    return std::pair(position ? static_cast<int>(*position) : -1, left.size());
  };
  CHECK(chosen("PIECEWISE_LINEAR x") == std::pair(1, std::size_t{1}));
  CHECK(chosen("piecewise linear x") == std::pair(1, std::size_t{1}));
  CHECK(chosen("piecewise linearly") == std::pair(0, std::size_t{1}));
  CHECK(chosen("piecewise_linearly") == std::pair(-1, std::size_t{1}));
  CHECK(chosen("node set 5") == std::pair(2, std::size_t{1}));
  CHECK(chosen("node sets 5") == std::pair(3, std::size_t{2}));
  CHECK(chosen("\"node\"") == std::pair(-1, std::size_t{1}));
  CHECK(chosen("") == std::pair(-1, std::size_t{0}));
}

TEST_CASE("values of random lines are what a slow reader finds", "[parser][value]") {
  const std::vector<std::string> texts{"1", "-2.5d-3", ".1", "1e-7", "+3", "12345678901234567",
                                       "x", "1e",      ""};
  const auto real = [](const Word& word) { return find_real(word.text); };
  const auto integer = [](const Word& word) { return find_integer(word.text); };
  const auto name = [](const Word& word) { return std::optional(DeckName{word.text, word.location}); };
  RandomLines lines;
  for (int i = 0; i < 20000; ++i) {
    const std::vector<Word> line = lines.next(texts);
    const Words words = line;
    const Outcome outcomes[] = {taken(words, [](Words& w) { return show(take_real(w)); }),
                                taken(words, [](Words& w) { return show(take_integer(w)); }),
                                taken(words, [](Words& w) { return show(take_name(w)); }),
                                taken(words, [](Words& w) { return show_all(take_vector(w)); }),
                                taken(words, [](Words& w) { return show_all(take_reals(w)); }),
                                taken(words, [](Words& w) { return show_all(take_integers(w)); }),
                                taken(words, [](Words& w) { return show_all(take_names(w)); })};
    const Outcome slow[] = {
        slowly_taken(words, 1, "a number", real), slowly_taken(words, 1, "an integer", integer),
        slowly_taken(words, 1, "a name", name),   slowly_taken(words, 3, "a number", real),
        slowly_taken(words, 0, "a number", real), slowly_taken(words, 0, "an integer", integer),
        slowly_taken(words, 0, "a name", name)};
    for (std::size_t rule = 0; rule < std::size(slow); ++rule) REQUIRE(outcomes[rule] == slow[rule]);
  }
}

TEST_CASE("choices of random lines are what a slow reader finds", "[parser][value]") {
  const std::vector<std::string> texts{"a", "B", "a_b", "_a", "c__", "a_b_c", "_", "", "ab"};
  const std::vector<std::string> phrases{"a", "a b", "a_b c", "b", "b c a", "ab", "c c"};
  const Choices choices(phrases);
  RandomLines lines;
  for (int i = 0; i < 20000; ++i) {
    const std::vector<Word> line = lines.next(texts);
    Words words = line, slow_words = line;
    REQUIRE(take_choice(words, choices) == slow_choice(slow_words, phrases));
    REQUIRE(words.size() == slow_words.size());
  }
}
