#pragma once

// What a file of HDF5 has in it.

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace polhode::cli {

using hdf5_attributes = std::vector<std::pair<std::string, std::string>>;

/// Doubles, or texts, in the order of C.
struct hdf5_dataset {
  std::string name;
  std::vector<std::size_t> shape;
  std::vector<double> numbers;
  std::vector<std::string> texts;  // in place of numbers
  hdf5_attributes attributes;
};

struct hdf5_file {
  hdf5_attributes attributes;
  std::vector<hdf5_dataset> datasets;
};

}  // namespace polhode::cli
