// HDF5 files with datasets that are no tables of numbers, written with the HDF5 library itself.
#include <hdf5.h>

#include <vector>

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
  const hid_t text = H5Tcopy(H5T_C_S1);
  H5Tset_size(text, 8);
  const hid_t type = H5Tcreate(H5T_COMPOUND, 16);
  H5Tinsert(type, "name", 0, text);
  H5Tinsert(type, "unit", 8, text);
  H5Tclose(text);
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
  const hsize_t cube[4] = {4, 5, 6, 3};
  writeNumbers(file, "images", 4, cube, [](hsize_t) { return 1.0; });
}

/// The demonstration that `use` chooses is the formula's.
void expectFormulaIn(const std::filesystem::path& path, const std::string& use) {
  ImportOptions options;
  options.use = {use};
  const auto chosen = openRecording(path, options);
  ASSERT_TRUE(chosen.ok()) << chosen.error().message;
  expectFormula(chosen->recording);
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
                                 "/notes (text)", "/images (4 dimensions)", "one row per sample"})
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

/// One row of a compound table: its time, joints and wrench as members and arrays.
struct TableRow {
  double time;
  double q[7];
  double wrench[6];
};

/// A table `name` of 100 rows under `parent`, its wrench times `scale`.
void writeTable(hid_t parent, const char* name, double scale) {
  const hsize_t seven = 7, six = 6, rows = 100;
  const hid_t joints = H5Tarray_create2(H5T_NATIVE_DOUBLE, 1, &seven);
  const hid_t wrench = H5Tarray_create2(H5T_NATIVE_DOUBLE, 1, &six);
  const hid_t type = H5Tcreate(H5T_COMPOUND, sizeof(TableRow));
  H5Tinsert(type, "time", HOFFSET(TableRow, time), H5T_NATIVE_DOUBLE);
  H5Tinsert(type, "q", HOFFSET(TableRow, q), joints);
  H5Tinsert(type, "wrench", HOFFSET(TableRow, wrench), wrench);
  std::vector<TableRow> table(rows);
  for (std::size_t k = 0; k < rows; ++k) {
    table[k].time = 0.01 * static_cast<double>(k);
    for (int j = 0; j < 7; ++j) table[k].q[j] = jointAt(table[k].time, j);
    for (int a = 0; a < 6; ++a) table[k].wrench[a] = scale * wrenchAt(table[k].time, a);
  }
  const hid_t space = H5Screate_simple(1, &rows, nullptr);
  const hid_t set = H5Dcreate2(parent, name, type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
  ASSERT_GE(H5Dwrite(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, table.data()), 0);
  for (const hid_t each : {joints, wrench, type}) H5Tclose(each);
  H5Dclose(set);
  H5Sclose(space);
}

TEST_F(OddHdf5, MembersOfCompoundTypesAreColumns) {
  const auto path = write("table.h5", "");
  const hid_t file = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
  writeTable(file, "log", 1.0);
  H5Fclose(file);
  const auto read = openRecording(path);
  ASSERT_TRUE(read.ok()) << read.error().message;
  expectFormula(read->recording);
}

/// Tables of one form in one group, which links lead to again and PyTables keeps an index for.
TEST_F(OddHdf5, TablesOfOneFormAreDemonstrations) {
  const auto path = write("tables.h5", "");
  const hid_t file = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
  const hid_t group = H5Gcreate2(file, "runs", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
  writeTable(group, "evening", 2.0);
  writeTable(group, "morning", 1.0);
  H5Lcreate_soft("/runs", file, "best", H5P_DEFAULT, H5P_DEFAULT);
  H5Lcreate_soft("/runs/morning", file, "today", H5P_DEFAULT, H5P_DEFAULT);
  const hid_t index = H5Gcreate2(group, "_i_morning", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
  const hsize_t many = 131072;
  writeNumbers(index, "sorted", 1, &many, [](hsize_t k) { return static_cast<double>(k); });
  H5Gclose(index);
  H5Gclose(group);
  H5Fclose(file);
  const auto first = openRecording(path);
  ASSERT_TRUE(first.ok()) << first.error().message;
  const auto texts = allTexts(first->findings);
  EXPECT_THAT(texts, ::testing::HasSubstr("holds 2 demonstrations; /runs/evening was read, not /runs/morning"));
  EXPECT_THAT(texts, ::testing::Not(::testing::HasSubstr("131072")));
  EXPECT_NEAR(first->recording.wrench(0, 2), -10.0, 1e-9);
  expectFormulaIn(path, "demo=morning");
}

/// Datasets t, q, wrench under `group` of `file`.
void writeDemonstration(hid_t file, const std::string& group, double scale) {
  const hid_t made = H5Gcreate2(file, group.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
  H5Gclose(made);
  const hsize_t rows = 100, joints[2] = {100, 7}, wrench[2] = {100, 6};
  writeNumbers(file, (group + "/time").c_str(), 1, &rows, [](hsize_t k) { return 0.01 * static_cast<double>(k); });
  writeNumbers(file, (group + "/q").c_str(), 2, joints,
               [](hsize_t k) { return jointAt(0.01 * static_cast<double>(k / 7), static_cast<int>(k % 7)); });
  writeNumbers(file, (group + "/wrench").c_str(), 2, wrench, [scale](hsize_t k) {
    return scale * wrenchAt(0.01 * static_cast<double>(k / 6), static_cast<int>(k % 6));
  });
}

TEST_F(OddHdf5, OneOfSeveralDemonstrationsIsReadAndCanBeChosen) {
  const auto path = write("demos.h5", "");
  const hid_t file = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
  writeDemonstration(file, "demo_0", 2.0);
  writeDemonstration(file, "demo_1", 1.0);
  H5Fclose(file);
  const auto first = openRecording(path);
  ASSERT_TRUE(first.ok()) << first.error().message;
  EXPECT_TRUE(hasCode(first->findings, "several_demonstrations"));
  EXPECT_NEAR(first->recording.wrench(0, 2), -10.0, 1e-9);
  expectFormulaIn(path, "demo=/demo_1");
  ImportOptions options;
  options.use = {"demo=/demo_7"};
  EXPECT_FALSE(openRecording(path, options).ok());
}

TEST_F(OddHdf5, LinksAreFollowedAndLoopsAreNot) {
  const auto other = write("other.h5", "");
  const hid_t beside = H5Fcreate(other.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
  writeDemonstration(beside, "rig", 1.0);
  H5Fclose(beside);
  const auto path = write("links.h5", "");
  const hid_t file = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
  H5Lcreate_external("other.h5", "/rig", file, "log", H5P_DEFAULT, H5P_DEFAULT);
  H5Lcreate_soft("/", file, "loop", H5P_DEFAULT, H5P_DEFAULT);
  H5Lcreate_soft("/nowhere", file, "broken", H5P_DEFAULT, H5P_DEFAULT);
  H5Fclose(file);
  const auto read = openRecording(path);
  ASSERT_TRUE(read.ok()) << read.error().message;
  expectFormula(read->recording);
  EXPECT_TRUE(hasCode(read->findings, "link_broken"));
}

TEST_F(OddHdf5, WithoutAClockTheRateIsStated) {
  const auto path = write("clockless.h5", "");
  const hid_t file = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
  const hsize_t joints[2] = {100, 7}, wrench[2] = {100, 6};
  writeNumbers(file, "qpos", 2, joints,
               [](hsize_t k) { return jointAt(0.01 * static_cast<double>(k / 7), static_cast<int>(k % 7)); });
  writeNumbers(file, "joint_positions", 2, joints,
               [](hsize_t k) { return jointAt(0.01 * static_cast<double>(k / 7), static_cast<int>(k % 7)); });
  writeNumbers(file, "ft_wrench", 2, wrench,
               [](hsize_t k) { return wrenchAt(0.01 * static_cast<double>(k / 6), static_cast<int>(k % 6)); });
  H5Fclose(file);
  const auto without = openRecording(path);
  ASSERT_FALSE(without.ok());
  EXPECT_THAT(without.error().message, ::testing::HasSubstr("--rate"));
  ImportOptions options;
  options.rateHz = 100.0;
  const auto read = openRecording(path, options);
  ASSERT_TRUE(read.ok()) << read.error().message;
  expectFormula(read->recording);
}

}  // namespace
}  // namespace heft
