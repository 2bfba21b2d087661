// polhode map as arrays: NumPy's format and HDF5.

#include <cmath>
#include <cstring>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "polhode/arithmetic/exact.hpp"
#include "program.hpp"

#ifdef POLHODE_HAVE_HDF5
#include <hdf5.h>
#endif

namespace polhode::test {
namespace map_arrays_test {
namespace {

using words = std::vector<std::string>;

words with(words command, const words& more) {
  command.insert(command.end(), more.begin(), more.end());
  return command;
}

const words points{"map", "epsilon0", "c0", "--a", "0.01..9/6", "--b", "0.01..0.9/4"};
const words cells{"map",      "phase",      "intersections", "--a",       "1..9/3",
                  "--b",      "0.1..0.7/3", "--c",           "0..0.07/2", "--cells",
                  "--digits", "20",         "--refine",      "2"};

std::vector<double> numbers_in(const std::string& npy, const std::string& shape) {
  EXPECT_NE(npy.find("'shape': (" + shape + "), "), std::string::npos) << npy.substr(0, 100);
  const std::size_t head = 10 + static_cast<unsigned char>(npy[8]);
  std::vector<double> result((npy.size() - head) / sizeof(double));
  std::memcpy(result.data(), npy.data() + head, result.size() * sizeof(double));
  return result;
}

std::vector<words> rows_of(const std::string& csv) {
  std::vector<words> rows;
  for (const std::string& line : lines_of(csv)) {
    std::istringstream row(line + ',');
    rows.emplace_back();
    for (std::string one; std::getline(row, one, ',');) rows.back().push_back(one);
  }
  rows.erase(rows.begin());
  return rows;
}

bool is_number(const std::string& text) {
  return !text.empty() && text != "none" && text != "undecided";
}

TEST(MapArrays, OfPointsHoldTheNumbers) {
  const std::vector<words> rows = rows_of(run(points).out);
  const std::vector<double> numbers =
      numbers_in(run(with(points, {"--format", "npy"})).out, "2, 2, 7, 5");
  ASSERT_EQ(numbers.size(), 4 * rows.size());
  int none = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (std::size_t q = 0; q < 2; ++q) {
      const double value = numbers[2 * q * rows.size() + i];
      const double radius = numbers[(2 * q + 1) * rows.size() + i];
      const std::string& text = rows[i].at(4 + 2 * q);
      if (!is_number(text)) {
        EXPECT_TRUE(std::isnan(value));
        EXPECT_TRUE(text == "none" ? std::isnan(radius) : radius == INFINITY);
        ++none;
        continue;
      }
      const rational distance = abs(parse_rational(text) - rational(value));
      EXPECT_LE(distance + parse_rational(rows[i].at(5 + 2 * q)), rational(radius));
      EXPECT_LE(radius, 1e-13);
    }
  }
  EXPECT_GT(none, 0);
}

TEST(MapArrays, OfCellsStayTrue) {
  const std::vector<words> rows = rows_of(run(cells).out);
  const std::vector<double> numbers =
      numbers_in(run(with(cells, {"--format", "npy"})).out, std::to_string(rows.size()) + ", 10");
  ASSERT_EQ(numbers.size(), 10 * rows.size());
  const auto near = [](const rational& x, double y) {
    return abs(x - rational(y)) <= abs(x) / (1L << 52);
  };
  int undecided = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double* const row = &numbers[10 * i];
    for (std::size_t k = 0; k < 6; k += 2) {
      const rational low = parse_rational(rows[i].at(2 * k + 1));
      const rational high = parse_rational(rows[i].at(2 * k + 3));
      EXPECT_LE(low, rational(row[k]));
      EXPECT_GE(high, rational(row[k + 1]));
      EXPECT_TRUE(near(low, row[k]) && near(high, row[k + 1]));
    }
    for (std::size_t k = 6; k < 10; k += 2) {
      if (rows[i].at(6 + k) == "none") {
        EXPECT_TRUE(std::isnan(row[k]) && std::isnan(row[k + 1]));
        continue;
      }
      if (rows[i].at(6 + k) == "undecided") {  // it is somewhere
        EXPECT_TRUE(row[k] == -INFINITY && row[k + 1] == INFINITY);
        ++undecided;
        continue;
      }
      const rational lower = parse_rational(rows[i].at(6 + k));
      const rational upper = parse_rational(rows[i].at(7 + k));
      EXPECT_GE(lower, rational(row[k]));
      EXPECT_LE(upper, rational(row[k + 1]));
      EXPECT_TRUE(near(lower, row[k]) && near(upper, row[k + 1]));
    }
  }
  EXPECT_GT(undecided, 0);
  EXPECT_GT(rows.size(), 18U);  // some were halved
}

#ifdef POLHODE_HAVE_HDF5

/// A file of the program's, opened.
class opened {
 public:
  explicit opened(const words& command) {
    const std::string bytes = run(with(command, {"--format", "hdf5"})).out;
    EXPECT_EQ(bytes.substr(0, 8), "\x89HDF\r\n\x1a\n");
    EXPECT_EQ(bytes, run(with(command, {"--format", "hdf5"})).out);
    std::ofstream(scratch_.path("map.h5"), std::ios::binary) << bytes;
    file_ = H5Fopen(scratch_.path("map.h5").c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
    EXPECT_GE(file_, 0);
  }
  ~opened() { H5Fclose(file_); }
  opened(const opened&) = delete;
  opened& operator=(const opened&) = delete;
  opened(opened&&) = delete;
  opened& operator=(opened&&) = delete;

  [[nodiscard]] std::vector<double> numbers(const char* name, std::vector<hsize_t> shape) const {
    const hid_t set = H5Dopen2(file_, name, H5P_DEFAULT);
    EXPECT_GE(set, 0) << name;
    const hid_t space = H5Dget_space(set);
    std::vector<hsize_t> sides(static_cast<std::size_t>(H5Sget_simple_extent_ndims(space)));
    H5Sget_simple_extent_dims(space, sides.data(), nullptr);
    EXPECT_EQ(sides, shape) << name;
    const hid_t properties = H5Dget_create_plist(set);
    EXPECT_EQ(H5Pget_layout(properties), H5D_CHUNKED);
    EXPECT_EQ(H5Pget_nfilters(properties), 2);
    std::vector<double> result(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)));
    EXPECT_GE(H5Dread(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, result.data()), 0);
    H5Pclose(properties);
    H5Sclose(space);
    H5Dclose(set);
    return result;
  }
  /// An attribute of an object, or all texts of a dataset one after the other.
  [[nodiscard]] std::string text(const char* object, const char* attribute) const {
    const hid_t of = H5Oopen(file_, object, H5P_DEFAULT);
    const hid_t one = H5Aopen(of, attribute, H5P_DEFAULT);
    EXPECT_GE(one, 0) << object << ' ' << attribute;
    const hid_t type = H5Aget_type(one);
    std::string result(H5Tget_size(type), '\0');
    H5Aread(one, type, result.data());
    H5Tclose(type);
    H5Aclose(one);
    H5Oclose(of);
    return result;
  }
  [[nodiscard]] std::string texts(const char* name) const {
    const hid_t set = H5Dopen2(file_, name, H5P_DEFAULT);
    const hid_t type = H5Dget_type(set);
    const hid_t space = H5Dget_space(set);
    std::string result(
        H5Tget_size(type) * static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)), '\0');
    H5Dread(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, result.data());
    H5Sclose(space);
    H5Tclose(type);
    H5Dclose(set);
    std::erase(result, '\0');
    return result;
  }

 private:
  scratch_directory scratch_;
  hid_t file_ = -1;
};

/// The same, and NaN where the other is.
void expect_same(const std::vector<double>& x, const double* y) {
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (!std::isnan(x[i]) || !std::isnan(y[i])) {
      EXPECT_EQ(x[i], y[i]) << i;
    }
  }
}

TEST(MapArrays, AreTheSameInHDF5) {
  const opened file(points);
  const std::vector<double> numbers =
      numbers_in(run(with(points, {"--format", "npy"})).out, "2, 2, 7, 5");
  const double* next = numbers.data();
  for (const char* name : {"epsilon0", "epsilon0_radius", "c0", "c0_radius"}) {
    expect_same(file.numbers(name, {7, 5}), next);
    next += 35;
  }
  EXPECT_EQ(file.numbers("a", {7})[0], 0.01);
  EXPECT_EQ(file.texts("b_exact"),
            "1/10093/400"
            "91/200"
            "271/4009/10");
  EXPECT_EQ(file.text("epsilon0", "unit"), "rad");
  EXPECT_EQ(file.text("epsilon0_radius", "description"),
            "greatest distance from the value of the defect on the separatrix");
  EXPECT_NE(file.text("/", "map").find("\"quantities\": [\n    \"epsilon0\","), std::string::npos);
  EXPECT_NE(file.text("/", "polhode").find('.'), std::string::npos);
}

TEST(MapArrays, OfCellsAreTheSameInHDF5) {
  const opened file(cells);
  const std::vector<words> rows = rows_of(run(cells).out);
  const std::vector<double> numbers =
      numbers_in(run(with(cells, {"--format", "npy"})).out, std::to_string(rows.size()) + ", 10");
  const std::vector<const char*> names{"a_low",
                                       "a_high",
                                       "b_low",
                                       "b_high",
                                       "c_low",
                                       "c_high",
                                       "phase_lower",
                                       "phase_upper",
                                       "intersections_lower",
                                       "intersections_upper"};
  for (std::size_t k = 0; k < names.size(); ++k) {
    const std::vector<double> column = file.numbers(names[k], {rows.size()});
    std::vector<double> expected;
    for (std::size_t i = 0; i < rows.size(); ++i) expected.push_back(numbers[10 * i + k]);
    expect_same(column, expected.data());
  }
  EXPECT_EQ(file.text("phase_upper", "unit"), "rad");
}

#else

TEST(MapArrays, RefuseHDF5WithoutIt) {
  const outcome refused = run(with(points, {"--format", "hdf5"}));
  EXPECT_EQ(refused.status, 2);
  EXPECT_NE(refused.err.find("built without HDF5"), std::string::npos);
}

#endif

}  // namespace
}  // namespace map_arrays_test
}  // namespace polhode::test
