// HDF5 files with datasets that are no tables of numbers, written with the HDF5 library itself.
#include <hdf5.h>

#include <functional>

#include "tests/core/import/fixtures.h"

namespace heft {
namespace {

using namespace testing_support;
using OddHdf5 = InFolder;

void writeNumbers(hid_t file, const char* name, int rank, const hsize_t* sizes,
                  const std::function<double(hsize_t)>& at) {
  hsize_t count = 1;
  for (int d = 0; d < rank; ++d) count *= sizes[d];
  std::vector<double> values;
  for (hsize_t k = 0; k < count; ++k) values.push_back(at(k));
  const hid_t space = H5Screate_simple(rank, sizes, nullptr);
  const hid_t set = H5Dcreate2(file, name, H5T_NATIVE_DOUBLE, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
  ASSERT_GE(H5Dwrite(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), 0);
  H5Dclose(set);
  H5Sclose(space);
}

/// A dataset of `type`, `rows` long, without values.
void writeOdd(hid_t file, const char* name, hid_t type, hsize_t rows = 100) {
  const hid_t space = H5Screate_simple(1, &rows, nullptr);
  const hid_t set = H5Dcreate2(file, name, type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
  ASSERT_GE(set, 0);
  H5Dclose(set);
  H5Sclose(space);
  H5Tclose(type);
}

hid_t compound() {
  const hid_t type = H5Tcreate(H5T_COMPOUND, 16);
  H5Tinsert(type, "fx", 0, H5T_NATIVE_DOUBLE);
  H5Tinsert(type, "fy", 8, H5T_NATIVE_DOUBLE);
  return type;
}

hid_t text() {
  const hid_t type = H5Tcopy(H5T_C_S1);
  H5Tset_size(type, H5T_VARIABLE);
  return type;
}

void writeOddOnes(hid_t file) {
  writeOdd(file, "table", compound());
  writeOdd(file, "notes", text());
  writeOdd(file, "lists", H5Tvlen_create(H5T_NATIVE_DOUBLE));
  writeOdd(file, "blob", H5Tcreate(H5T_OPAQUE, 8));
  const hsize_t three = 3;
  writeOdd(file, "vectors", H5Tarray_create2(H5T_NATIVE_DOUBLE, 1, &three));
  const hsize_t cube[3] = {4, 5, 6};
  writeNumbers(file, "images", 3, cube, [](hsize_t) { return 1.0; });
}

TEST_F(OddHdf5, NothingButOddTypesIsOneSentence) {
  const auto path = write("odd.h5", "");
  const hid_t file = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
  writeOddOnes(file);
  H5Fclose(file);
  const auto read = openRecording(path);
  ASSERT_FALSE(read.ok());
  const auto& message = read.error().message;
  EXPECT_EQ(message.find('\n'), std::string::npos);
  for (const char* const part : {"no dataset of this HDF5 file is a table of numbers", "/table (a compound type)",
                                 "/notes (text)", "/images (3 dimensions)", "one row a sample"})
    EXPECT_THAT(message, ::testing::HasSubstr(part));
}

TEST_F(OddHdf5, BesideNumbersTheyAreNamed) {
  const auto path = write("mixed.h5", "");
  const hid_t file = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
  writeOddOnes(file);
  const hsize_t rows = 100, joints[2] = {100, 7}, wrench[2] = {100, 6};
  writeNumbers(file, "time", 1, &rows, [](hsize_t k) { return 0.01 * static_cast<double>(k); });
  writeNumbers(file, "q", 2, joints,
               [](hsize_t k) { return jointAt(0.01 * static_cast<double>(k / 7), static_cast<int>(k % 7)); });
  writeNumbers(file, "wrench", 2, wrench,
               [](hsize_t k) { return wrenchAt(0.01 * static_cast<double>(k / 6), static_cast<int>(k % 6)); });
  H5Fclose(file);
  const auto read = openRecording(path);
  ASSERT_TRUE(read.ok()) << read.error().message;
  expectFormula(read->recording);
  EXPECT_TRUE(hasCode(read->findings, "dataset_odd")) << allTexts(read->findings);
  EXPECT_THAT(allTexts(read->findings), ::testing::HasSubstr("1 more"));
}

}  // namespace
}  // namespace heft
