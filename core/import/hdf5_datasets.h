#pragma once
// Datasets of an HDF5 file as tables of numbers.
#include <optional>
#include <string>
#include <vector>

#include "core/import/array_streams.h"
#include "core/import/hdf5_functions.h"

namespace heft::hdf5 {

struct Dataset {
  NumberArray array;
  int rank = 1;
  bool rowsLast = false;  ///< channels x rows, as MATLAB writes
  hsize_t sizes[3] = {0, 1, 1};
  std::vector<std::string> members;  ///< Of a compound type: the member of each channel ...
  std::vector<hsize_t> elements;     ///< ... and the element in it, where the member is an array.
};

/// Nothing for what is no table of numbers; `odd` says then what it is, unless the file is damaged there.
std::optional<Dataset> describe(hid_t file, const std::string& path, double mostBytes, std::string& odd);

/// One channel of a dataset, or nothing if it is damaged; `filter` then says which filter is missing, if any is.
std::vector<double> readChannel(hid_t file, const Dataset& what, hsize_t channel, std::string& filter);

}  // namespace heft::hdf5
