// Files of HDF5, made in memory. The program loads this module for --format hdf5.

#include <algorithm>
#include <memory>
#include <stdexcept>

#include <hdf5.h>

#include "cli/modules/hdf5_file.hpp"

namespace polhode::cli {
namespace {

/// An object of HDF5's, closed in the end.
class handle {
 public:
  handle(hid_t id, herr_t (*close)(hid_t)) : id_(id), close_(close) {
    if (id < 0) throw std::runtime_error("HDF5 cannot make the file");
  }
  ~handle() { close_(id_); }
  handle(const handle&) = delete;
  handle& operator=(const handle&) = delete;
  handle(handle&&) = delete;
  handle& operator=(handle&&) = delete;
  operator hid_t() const { return id_; }

 private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

void check(herr_t result) {
  if (result < 0) throw std::runtime_error("HDF5 cannot make the file");
}

/// The type of texts of so many bytes at most, filled up with zeros.
handle text_type(std::size_t bytes) {
  handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  check(H5Tset_size(type, std::max<std::size_t>(bytes, 1)));
  check(H5Tset_strpad(type, H5T_STR_NULLPAD));
  check(H5Tset_cset(type, H5T_CSET_UTF8));
  return handle(H5Tcopy(type), H5Tclose);
}

void write_attributes(hid_t object, const hdf5_attributes& attributes) {
  for (const auto& [name, text] : attributes) {
    const handle type = text_type(text.size());
    const handle space(H5Screate(H5S_SCALAR), H5Sclose);
    const handle attribute(H5Acreate2(object, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT),
                           H5Aclose);
    const std::string padded = text.empty() ? std::string(1, '\0') : text;
    check(H5Awrite(attribute, type, padded.data()));
  }
}

/// Of at most so many elements, by halving the longest side.
std::vector<hsize_t> chunk_of(std::vector<hsize_t> sides) {
  constexpr hsize_t most = 1 << 16;
  const auto count = [&] {
    hsize_t product = 1;
    for (const hsize_t side : sides) product *= side;
    return product;
  };
  while (count() > most) {
    hsize_t& longest = *std::max_element(sides.begin(), sides.end());
    longest = (longest + 1) / 2;
  }
  return sides;
}

void write_dataset(hid_t file, const hdf5_dataset& data) {
  const std::vector<hsize_t> sides(data.shape.begin(), data.shape.end());
  const handle space(H5Screate_simple(static_cast<int>(sides.size()), sides.data(), nullptr),
                     H5Sclose);
  const handle properties(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  const std::vector<hsize_t> chunk = chunk_of(sides);
  check(H5Pset_chunk(properties, static_cast<int>(chunk.size()), chunk.data()));
  check(H5Pset_shuffle(properties));
  constexpr unsigned compression = 6;
  check(H5Pset_deflate(properties, compression));
  check(H5Pset_obj_track_times(properties, false));  // the bytes depend on the data alone
  std::string padded;
  std::size_t longest = 0;
  for (const std::string& text : data.texts) longest = std::max(longest, text.size());
  for (const std::string& text : data.texts) {
    padded += text;
    padded.append(std::max<std::size_t>(longest, 1) - text.size(), '\0');
  }
  const bool is_text = !data.texts.empty();
  const handle texts = text_type(longest);
  const handle set(H5Dcreate2(file, data.name.c_str(), is_text ? hid_t{texts} : H5T_IEEE_F64LE,
                              space, H5P_DEFAULT, properties, H5P_DEFAULT),
                   H5Dclose);
  check(is_text
            ? H5Dwrite(set, texts, H5S_ALL, H5S_ALL, H5P_DEFAULT, padded.data())
            : H5Dwrite(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, data.numbers.data()));
  write_attributes(set, data.attributes);
}

std::string bytes_of(const hdf5_file& content) {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  const handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  constexpr std::size_t grows_by = 1 << 20;
  check(H5Pset_fapl_core(access, grows_by, false));
  const handle file(H5Fcreate("map.h5", H5F_ACC_TRUNC, H5P_DEFAULT, access), H5Fclose);
  write_attributes(file, content.attributes);
  for (const hdf5_dataset& data : content.datasets) write_dataset(file, data);
  check(H5Fflush(file, H5F_SCOPE_LOCAL));
  const ssize_t size = H5Fget_file_image(file, nullptr, 0);
  if (size < 0) throw std::runtime_error("HDF5 cannot make the file");
  std::string bytes(static_cast<std::size_t>(size), '\0');
  if (H5Fget_file_image(file, bytes.data(), bytes.size()) != size) {
    throw std::runtime_error("HDF5 cannot make the file");
  }
  return bytes;
}

}  // namespace
}  // namespace polhode::cli

/// Makes the bytes of the file; map_arrays.cpp calls it by this name.
extern "C" void polhode_hdf5_bytes(const polhode::cli::hdf5_file& file, std::string& bytes) {
  bytes = polhode::cli::bytes_of(file);
}
