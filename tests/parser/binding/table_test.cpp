// SPDX-License-Identifier: BSD-3-Clause
#include "parser/binding/table.hpp"

#include "parser/commands/row_lists.hpp"
#include "parser/commands/rows.hpp"
#include "support/deck_line.hpp"

using namespace contactsim;

namespace {

struct Wheel {
  DeckName name;
  double radius = 0.5;
  std::vector<double> spokes;
  std::vector<std::string> lines;
};

enum class Colour { red, dark_green };

struct Car {
  DeckName name;
  double mass = std::numeric_limits<double>::quiet_NaN();
  std::optional<double> drag, petrol, current;
  bool is_fast = false, has_roof = true;
  Colour colour = Colour::red;
  std::vector<DeckName> seats;
  std::vector<std::int64_t> numbers;
  std::vector<Wheel> wheels;
  Wheel spare;
};

const Table<Wheel>& wheel_table() {
  static const Table<Wheel> table({
      row("radius", read::positive, &Wheel::radius, "Radius [length]"),
      numbers<Wheel>(
          "<real>", [](Arguments& a, Wheel& w) { w.spokes.push_back(a.real()); }, "A spoke [length]"),
      anything<Wheel>(
          "<words>", [](Arguments& a, Wheel& w) { w.lines.push_back(a.rest()); }, "Any line"),
  });
  return table;
}

const Choice one_source{"has no source of power", "has more than one source of power"};

void check(const Car& car, DeckNames& names) {
  if (car.is_fast && car.mass > 2000.0)
    names.add_problem_of_block("is too heavy to be fast", "take weight off");
}

const Table<Car>& car_table() {
  static const Table<Car> table(
      {
          row("mass", read::positive, &Car::mass, "Mass [mass]").or_spelled("weight of all").required(),
          row("drag", read::real, &Car::drag, "Drag coefficient [1]"),
          flag("fast", &Car::is_fast, "Goes fast"),
          row("roof", read::on_off, &Car::has_roof, "Has a roof"),
          row("petrol", read::positive, &Car::petrol, "Petrol [volume]").one_of(one_source),
          row("current", read::positive, &Car::current, "Battery [charge]").one_of(one_source),
          row("colour", choice_of<Colour>({"red", "dark green"}), &Car::colour, "Colour"),
          row("seats", read::names, &Car::seats, "Who sits inside"),
          row("numbers", read::integers, &Car::numbers, "Its numbers [1]"),
          block("wheel", Naming::required, wheel_table, &Car::wheels, "A wheel"),
          block("spare wheel", Naming::none, wheel_table, &Car::spare, "The spare wheel"),
          block("trailer wheel", Naming::required, wheel_table, &Car::wheels, "A wheel")
              .defines(NameKind::function),
          ignored<Car>("paint", "= <real>", "Paint weighs nothing"),
          refused<Car>("rocket", "", "take a larger engine"),
          refused_block<Car>("boat", "cars do not swim"),
      },
      check);
  return table;
}

struct Bound {
  Car car;
  std::string said;
};

Bound bound(const std::string& lines, bool is_lenient = false) {
  const Block deck = block_of("begin car\n" + lines + "end\n");
  Bound result;
  Diagnostics diagnostics;
  Binding binding{diagnostics, is_lenient};
  car_table().bind(std::get<Block>(deck.items.at(0).value), result.car, binding);
  result.said = messages(diagnostics);
  return result;
}

/// What is said when names and what is missing are noted too.
std::string checked(const std::string& lines) {
  const Block deck = block_of("begin car\n" + lines + "end\n");
  Car car;
  Diagnostics diagnostics;
  DeckNames names;
  Binding binding{diagnostics, false, &names};
  bind_block(
      binding, {"car", std::nullopt, {"", std::get<Block>(deck.items.at(0).value).location}},
      [&](Binding& within) { car_table().bind(std::get<Block>(deck.items.at(0).value), car, within); });
  names.resolve(diagnostics);
  names.report_problems_of_lines(diagnostics);
  return messages(diagnostics);
}

const RowText& text_of(const std::string& phrase) {
  for (const RowText& row : car_table().text().rows) {
    if (row.phrase == phrase) return row;
  }
  FAIL("no row " + phrase);
  return car_table().text().rows.front();
}

}  // namespace

TEST_CASE("commands are bound into their fields", "[parser][table]") {
  const auto [car, said] = bound(
      "mass = 900\ndrag 0.3\nfast\nroof is off\ncolour = DARK_GREEN\nseats = ann bob\nseats = eve\n"
      "numbers = 1 2\nnumbers = 3\n");
  CHECK(said == "");
  CHECK(car.mass == 900.0);
  CHECK(car.drag == 0.3);
  CHECK(car.is_fast);
  CHECK_FALSE(car.has_roof);
  CHECK(car.colour == Colour::dark_green);
  REQUIRE(car.seats.size() == 3);
  CHECK(car.seats[2].text == "eve");
  CHECK(car.numbers == std::vector<std::int64_t>{1, 2, 3});
}

TEST_CASE("a command may be spelled in another way", "[parser][table]") {
  CHECK(bound("weight of all = 900\n").car.mass == 900.0);
}

TEST_CASE("blocks are bound into their parts", "[parser][table]") {
  const auto [car, said] = bound(
      "begin wheel front left\n  radius = 0.4\n  0.1\n  -0.2\n  any words = 3\nend\n"
      "begin wheel rear\nend\n"
      "begin spare wheel\n  radius = 0.3\nend\n");
  CHECK(said == "");
  REQUIRE(car.wheels.size() == 2);
  CHECK(car.wheels[0].name.text == "front left");
  CHECK(car.wheels[0].name.location.column == 13);
  CHECK(car.wheels[0].radius == 0.4);
  CHECK(car.wheels[0].spokes == std::vector<double>{0.1, -0.2});
  CHECK(car.wheels[0].lines == std::vector<std::string>{"any words = 3"});
  CHECK(car.wheels[1].radius == 0.5);
  CHECK(car.spare.radius == 0.3);
}

TEST_CASE("a block that needs a name and has none is an error", "[parser][table]") {
  CHECK(bound("begin wheel\nend\n").said == "a.i:2:7: error: the block 'wheel' needs a name\n");
}

TEST_CASE("a command that is given twice is warned about, and the second counts", "[parser][table]") {
  const auto [car, said] = bound("mass = 900\nweight of all = 800\nseats = ann\nseats = bob\nfast\nfast\n");
  CHECK(car.mass == 800.0);
  CHECK(said ==
        "a.i:3:1: warning: 'mass' is given twice in one block, this one counts; the other stands at a.i:2:1 "
        "[deck-repeated]\n");
}

TEST_CASE("a command may be given once in each block", "[parser][table]") {
  CHECK(bound("begin wheel a\nradius = 1\nend\nbegin wheel b\nradius = 1\nend\n").said == "");
}

TEST_CASE("unknown commands and blocks are reported with the nearest known one", "[parser][table]") {
  CHECK(bound("mas = 900\n").said ==
        "a.i:2:1: error: unknown command 'mas = 900' in 'car'; did you mean 'mass'?\n");
  CHECK(bound("begin weel front\nend\n").said ==
        "a.i:2:7: error: unknown block 'weel front' in 'car'; did you mean 'begin wheel'?\n");
  CHECK(bound("begin mass\nend\n").said ==
        "a.i:2:7: error: unknown block 'mass' in 'car'; 'mass' is a command line here, not a block\n");
  CHECK(bound("wheel front\n").said ==
        "a.i:2:1: error: unknown command 'wheel front' in 'car'; 'wheel' is a block here: "
        "begin wheel\n");
  CHECK(bound("1 2 3 4 5\n").said == "a.i:2:1: error: unknown command '1 2 3 4 ...' in 'car'\n");
}

TEST_CASE("an unknown block is passed over whole", "[parser][table]") {
  CHECK(bound("begin boats x\n  begin deep\n    mas = 1\n  end\nend\nmass = -1\n").said ==
        "a.i:2:7: error: unknown block 'boats x' in 'car'; did you mean 'begin boat'?\n"
        "a.i:7:8: error: 'mass' must be greater than 0, found '-1'\n");
}

TEST_CASE("ignored commands are warned about and refused ones are errors", "[parser][table]") {
  CHECK(bound("paint = 3\nrocket\nbegin boat\n  oars = 2\nend\n").said ==
        "a.i:2:1: warning: 'paint' has no effect here; paint weighs nothing [deck-ignored]\n"
        "a.i:3:1: error: 'rocket' is not supported and would change the answer; take a larger engine\n"
        "a.i:4:7: error: block 'boat' is not supported and would change the answer; cars do not swim\n");
}

TEST_CASE("a lenient reading passes refused and unknown commands over", "[parser][table]") {
  CHECK(bound("rocket\nmas = 1\n", true).said ==
        "a.i:2:1: warning: 'rocket' is not supported, passed over; take a larger engine [deck-refused]\n"
        "a.i:3:1: warning: unknown command 'mas = 1' in 'car', passed over; did you mean 'mass'? "
        "[deck-unknown]\n");
}

TEST_CASE("problems in the lines of what waits for use are reported as warnings", "[parser][table]") {
  const std::string lines =
      "mass = 1\npetrol = 1\nbegin trailer wheel Front\n  radius = 0\nend\nbegin trailer wheel\nend\n";
  CHECK(
      checked(lines) ==
      "a.i:5:12: warning: 'radius' must be greater than 0, found '0', but nothing uses this definition "
      "[deck-unused]\n"
      "a.i:7:15: warning: the block 'wheel' needs a name, but nothing uses this definition [deck-unused]\n");
  CHECK(bound(lines).said ==
        "a.i:5:12: error: 'radius' must be greater than 0, found '0'\n"
        "a.i:7:15: error: the block 'wheel' needs a name\n");
}

TEST_CASE("what is required and not given is reported, and so is a choice", "[parser][table]") {
  CHECK(checked("mass = 1\npetrol = 1\n") == "");
  CHECK(bound("").said == "");  // only where it is noted
  CHECK(checked("") ==
        "a.i:1:1: error: the car has no MASS; add MASS = <real > 0>\n"
        "a.i:1:1: error: the car has no source of power; give it PETROL or CURRENT\n");
  CHECK(
      checked("mass = 1\npetrol = 1\ncurrent = 1\n") ==
      "a.i:4:1: error: the car has more than one source of power; keep one of PETROL and CURRENT; the first "
      "stands at a.i:3:1\n");
  CHECK(checked("mass = 0\npetrol = 1\n") == "a.i:2:8: error: 'mass' must be greater than 0, found '0'\n");
}

TEST_CASE("a table may check all lines of a block together", "[parser][table]") {
  CHECK(checked("mass = 3000\npetrol = 1\nfast\n") ==
        "a.i:1:1: error: the car is too heavy to be fast; take weight off\n");
}

TEST_CASE("a row tells its syntax and the default of its field", "[parser][rows]") {
  CHECK(text_of("mass").syntax == "= <real > 0>");
  CHECK(text_of("mass").default_text == "required");
  CHECK(text_of("drag").default_text == "none");
  CHECK(text_of("roof").default_text == "ON");
  CHECK(text_of("fast").default_text == "off");
  CHECK(text_of("colour").default_text == "red");
  CHECK(text_of("colour").syntax == "= {red|dark green}");
  CHECK(text_of("seats").default_text == "none");
  CHECK(text_of("wheel").syntax == "<name>");
  CHECK(text_of("spare wheel").syntax == "");
  CHECK(text_of("mass").is_single);
  CHECK_FALSE(text_of("seats").is_single);
  CHECK_FALSE(text_of("numbers").is_single);
}

TEST_CASE("rows can be lifted into what holds their target", "[parser][rows]") {
  const Table<Car> table(lift_all(wheel_table().rows(), &Car::spare));
  const Block deck = block_of("radius = 0.7\n3\n");
  Car car;
  Diagnostics diagnostics;
  Binding binding{diagnostics};
  table.bind(deck, car, binding);
  CHECK(diagnostics.empty());
  CHECK(car.spare.radius == 0.7);
  CHECK(car.spare.spokes == std::vector<double>{3.0});
}

TEST_CASE("the names in a block's title are distinguished", "[parser][table]") {
  const Block deck = block_of("begin parameters_for block a, b c\nend\n");
  const auto names = block_names(std::get<Block>(deck.items.at(0).value), "parameters for block");
  REQUIRE(names.size() == 3);
  CHECK(names[0].text == "a");
  CHECK(names[2].location.column == 33);
}
