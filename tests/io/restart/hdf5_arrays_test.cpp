// SPDX-License-Identifier: BSD-3-Clause
#include "io/restart/hdf5_arrays.hpp"

#include "core/base/errors.hpp"
#include "support/catch.hpp"
#include "support/temporary_directory.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

std::string text_of(std::span<const std::byte> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

template <class T>
void check_array(const SavedState& state, const std::string& name, const std::vector<T>& expected) {
  CAPTURE(name);
  const SavedArray* const array = state.find(name);
  REQUIRE(array != nullptr);
  CHECK(array->type == saved_type<T>);
  CHECK(text_of(array->bytes) == text_of(std::as_bytes(std::span(expected))));
}

}  // namespace

TEST_CASE("arrays of every type and depth come back to the bit", "[io][restart]") {
  const std::vector<double> reals{0.1, -0.0, 1e-310};
  const std::vector<float> singles{0.1f};
  const std::vector<std::uint64_t> longs{~0ull};
  const std::vector<std::uint32_t> numbers{1, 0xffffffffu};
  const std::vector<std::uint8_t> marks{0, 1, 255}, none;
  SavedState state;
  state.add_view("a/b/reals", std::span<const double>(reals));
  state.add_view("a/singles", std::span<const float>(singles));
  state.add_view("longs", std::span<const std::uint64_t>(longs));
  state.add_view("a/b/numbers", std::span<const std::uint32_t>(numbers));
  state.add_view("marks", std::span<const std::uint8_t>(marks));
  state.add_view("a/none", std::span<const std::uint8_t>(none));

  const TemporaryDirectory directory;
  const std::string path = directory.file("a.h5");
  write_bytes(path, text_of(Hdf5Image(0, state).bytes()));
  const SavedState read = read_hdf5(path);
  CHECK(read.origin() == path);
  CHECK(read.arrays().size() == 6);
  check_array(read, "a/b/reals", reals);
  check_array(read, "a/singles", singles);
  check_array(read, "longs", longs);
  check_array(read, "a/b/numbers", numbers);
  check_array(read, "marks", marks);
  check_array(read, "a/none", none);
}

TEST_CASE("room in front of an image is left to others", "[io][restart]") {
  const std::vector<double> reals{1, 2};
  SavedState state;
  state.add_view("reals", std::span<const double>(reals));
  Hdf5Image image(512, state);
  const std::string_view signature("\x89HDF\r\n\x1a\n", 8);
  CHECK(text_of(image.bytes()).substr(512, 8) == signature);
  const TemporaryDirectory directory;
  const std::string path = directory.file("a.h5");
  write_bytes(path, std::string(512, 'x') + text_of(image.bytes().subspan(512)));
  check_array(read_hdf5(path), "reals", reals);
}

TEST_CASE("what is no HDF5 file is an error that names it", "[io][restart]") {
  const TemporaryDirectory directory;
  const std::string path = directory.file("a.h5");
  write_bytes(path, "a text");
  try {
    read_hdf5(path);
    FAIL("read");
  } catch (const FileError& error) {
    CHECK(std::string(error.what()).starts_with(path + ": "));
  }
}
