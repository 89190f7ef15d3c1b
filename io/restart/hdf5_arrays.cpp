// SPDX-License-Identifier: BSD-3-Clause
#include "io/restart/hdf5_arrays.hpp"

#include <hdf5.h>

#include <algorithm>
#include <array>
#include <memory>
#include <new>
#include <optional>
#include <utility>

#include "core/base/errors.hpp"

namespace contactsim {

namespace {

/// Something that HDF5 has opened.
class Handle {
 public:
  using Close = herr_t (*)(hid_t);

  Handle(hid_t id, Close closer) : id_(id), close_(closer) {}
  ~Handle() {
    if (is_open()) close_(id_);
  }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;

  bool is_open() const { return id_ >= 0; }
  hid_t id() const { return id_; }
  /// Leaves the closing to others.
  hid_t release() { return std::exchange(id_, -1); }

 private:
  hid_t id_;
  Close close_;
};

/// HDF5 would print its own account of every error.
void be_quiet() { H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr); }

/// The type in memory.
hid_t memory_type(SavedType type) {
  const std::array<hid_t, 5> types{H5T_NATIVE_DOUBLE, H5T_NATIVE_FLOAT, H5T_NATIVE_UINT64, H5T_NATIVE_UINT32,
                                   H5T_NATIVE_UINT8};
  return types[static_cast<std::size_t>(type)];
}

hid_t file_type(SavedType type) {
  const std::array<hid_t, 5> types{H5T_IEEE_F64LE, H5T_IEEE_F32LE, H5T_STD_U64LE, H5T_STD_U32LE,
                                   H5T_STD_U8LE};
  return types[static_cast<std::size_t>(type)];
}

bool write_array(hid_t file, const SavedArray& array) {
  const hsize_t count = array.count();
  const Handle space(H5Screate_simple(1, &count, nullptr), H5Sclose);
  const Handle links(H5Pcreate(H5P_LINK_CREATE), H5Pclose);
  if (!space.is_open() || !links.is_open()) return false;
  if (H5Pset_create_intermediate_group(links.id(), 1) < 0) return false;
  const Handle set(H5Dcreate2(file, array.name.c_str(), file_type(array.type), space.id(), links.id(),
                              H5P_DEFAULT, H5P_DEFAULT),
                   H5Dclose);
  if (!set.is_open()) return false;
  return count == 0 ||
         H5Dwrite(set.id(), memory_type(array.type), H5S_ALL, H5S_ALL, H5P_DEFAULT, array.bytes.data()) >= 0;
}

/// Where a file in memory is; empty when HDF5 has no more memory.
std::span<std::byte> bytes_of(hid_t file) {
  if (H5Fflush(file, H5F_SCOPE_GLOBAL) < 0) return {};
  hsize_t size = 0;
  std::byte** memory = nullptr;
  if (H5Fget_filesize(file, &size) < 0) return {};
  if (H5Fget_vfd_handle(file, H5P_DEFAULT, reinterpret_cast<void**>(&memory)) < 0) return {};
  return {*memory, static_cast<std::size_t>(size)};
}

/// What the numbers of a data set are, in the file's order of SavedType.
std::optional<SavedType> type_of(const Handle& set) {
  const Handle type(H5Dget_type(set.id()), H5Tclose);
  for (int i = 0; i < 5; ++i) {
    const auto known = static_cast<SavedType>(i);
    if (H5Tequal(type.id(), file_type(known)) > 0) return known;
  }
  return std::nullopt;
}

bool read_array(const Handle& set, const std::string& name, SavedState& state) {
  const auto type = type_of(set);
  const Handle space(H5Dget_space(set.id()), H5Sclose);
  const hssize_t count = H5Sget_simple_extent_npoints(space.id());
  if (!type || count < 0) return false;
  const auto room = state.add_room(name, *type, static_cast<std::size_t>(count));
  return count == 0 || H5Dread(set.id(), memory_type(*type), H5S_ALL, H5S_ALL, H5P_DEFAULT, room.data()) >= 0;
}

/// The name of the i-th thing in a group.
std::string name_in(const Handle& group, hsize_t i) {
  const auto copy_to = [&](char* to, std::size_t room) {
    return H5Lget_name_by_idx(group.id(), ".", H5_INDEX_NAME, H5_ITER_INC, i, to, room, H5P_DEFAULT);
  };
  const ssize_t length = copy_to(nullptr, 0);
  std::string name(length > 0 ? static_cast<std::size_t>(length) : 0, ' ');
  copy_to(name.data(), name.size() + 1);
  return name;
}

/// Reads a group and the groups in it.
///   prefix  of the names of its arrays: "" or "contact/"
bool read_group(const Handle& group, const std::string& prefix, SavedState& state) {
  H5G_info_t about{};
  if (H5Gget_info(group.id(), &about) < 0) return false;
  for (hsize_t i = 0; i < about.nlinks; ++i) {
    const std::string name = name_in(group, i);
    const Handle object(H5Oopen(group.id(), name.c_str(), H5P_DEFAULT), H5Oclose);
    if (!object.is_open()) return false;
    const bool is_group = H5Iget_type(object.id()) == H5I_GROUP;
    const bool is_read =
        is_group ? read_group(object, prefix + name + "/", state) : read_array(object, prefix + name, state);
    if (!is_read) return false;
  }
  return true;
}

/// What HDF5 does at the exit of the process brings that down after it had too little memory. Files are
/// closed without it. Has effect before anything else of HDF5 is called.
[[maybe_unused]] const herr_t without_exit = H5dont_atexit();

/// Throws where there is not the memory that HDF5 takes for the cache of a file (half a megabyte), of which
/// it does not look whether it gets it.
void ask_for_cache() {
  constexpr std::size_t n_bytes = 2 << 20;
  const auto asked = std::make_unique<volatile char[]>(n_bytes);
}

}  // namespace

Hdf5Image::Hdf5Image(std::size_t head_size, const SavedState& state) {
  be_quiet();
  ask_for_cache();
  constexpr std::size_t growth = 4096;  // the size is a multiple of it
  const Handle creation(H5Pcreate(H5P_FILE_CREATE), H5Pclose), access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  H5Pset_userblock(creation.id(), head_size);
  H5Pset_fapl_core(access.id(), growth, /*backing_store=*/0);
  Handle file(H5Fcreate("state in memory", H5F_ACC_TRUNC, creation.id(), access.id()), H5Fclose);
  const auto write = [&](const SavedArray& array) { return write_array(file.id(), array); };
  if (file.is_open() && std::ranges::all_of(state.arrays(), write)) bytes_ = bytes_of(file.id());
  if (bytes_.empty()) throw std::bad_alloc();
  file_ = file.release();
}

Hdf5Image::~Hdf5Image() { H5Fclose(file_); }

SavedState read_hdf5(const std::string& path) {
  be_quiet();
  ask_for_cache();
  const Handle file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
  if (!file.is_open()) throw FileError(path, "cannot be opened as an HDF5 file");
  SavedState state(path);
  if (!read_group(file, "", state)) throw FileError(path, "holds something that is not a state");
  return state;
}

}  // namespace contactsim
