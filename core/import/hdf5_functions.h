#pragma once
// HDF5's functions as Heft calls them. Include it where H5_USE_110_API is defined.
#include <hdf5.h>

#include "core/base/library_on_demand.h"

namespace heft::hdf5 {

// HDF5's functions, which hide the declarations of its header (core/base/library_on_demand.h).
inline const LibraryOnDemand hdf5Library{HEFT_HDF5_LIBRARY, HEFT_HDF5_PACKAGE};
#define HEFT_AS_NAMED(name) inline const FunctionOnDemand<decltype(::name)> name(hdf5Library, #name)
#define HEFT_OF_HDF5(name) HEFT_AS_NAMED(name)  // Some names are macros for one of their versions.
HEFT_OF_HDF5(H5Aclose);
HEFT_OF_HDF5(H5Aexists);
HEFT_OF_HDF5(H5Aget_type);
HEFT_OF_HDF5(H5Aopen);
HEFT_OF_HDF5(H5Aread);
HEFT_OF_HDF5(H5Dclose);
HEFT_OF_HDF5(H5Dget_create_plist);
HEFT_OF_HDF5(H5Dget_space);
HEFT_OF_HDF5(H5Dget_type);
HEFT_OF_HDF5(H5Dopen2);
HEFT_OF_HDF5(H5Dread);
HEFT_OF_HDF5(H5Eset_auto2);
HEFT_OF_HDF5(H5Fclose);
HEFT_OF_HDF5(H5Fopen);
HEFT_OF_HDF5(H5Gclose);
HEFT_OF_HDF5(H5Gopen2);
HEFT_OF_HDF5(H5Literate);
HEFT_OF_HDF5(H5Oget_info_by_name);
HEFT_OF_HDF5(H5Pclose);
HEFT_OF_HDF5(H5Pget_filter2);
HEFT_OF_HDF5(H5Pget_nfilters);
HEFT_OF_HDF5(H5Sclose);
HEFT_OF_HDF5(H5Screate_simple);
HEFT_OF_HDF5(H5Sget_simple_extent_dims);
HEFT_OF_HDF5(H5Sget_simple_extent_ndims);
HEFT_OF_HDF5(H5Sselect_hyperslab);
HEFT_OF_HDF5(H5Tarray_create2);
HEFT_OF_HDF5(H5Tclose);
HEFT_OF_HDF5(H5Tcopy);
HEFT_OF_HDF5(H5Tcreate);
HEFT_OF_HDF5(H5Tget_array_dims2);
HEFT_OF_HDF5(H5Tget_array_ndims);
HEFT_OF_HDF5(H5Tget_class);
HEFT_OF_HDF5(H5Tget_member_name);
HEFT_OF_HDF5(H5Tget_member_type);
HEFT_OF_HDF5(H5Tget_nmembers);
HEFT_OF_HDF5(H5Tget_size);
HEFT_OF_HDF5(H5Tget_super);
HEFT_OF_HDF5(H5Tinsert);
HEFT_OF_HDF5(H5Tis_variable_str);
HEFT_OF_HDF5(H5Zfilter_avail);
HEFT_OF_HDF5(H5check_version);
HEFT_OF_HDF5(H5free_memory);
HEFT_OF_HDF5(H5open);
#undef HEFT_OF_HDF5
#undef HEFT_AS_NAMED
inline const VariableOnDemand<hid_t> H5T_NATIVE_DOUBLE_g{hdf5Library, "H5T_NATIVE_DOUBLE_g"};

/// Closes whatever an HDF5 call opened.
class Handle {
 public:
  Handle(hid_t id, herr_t (*close)(hid_t)) : id_(id), close_(close) {}
  ~Handle() {
    if (id_ >= 0) close_(id_);
  }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  hid_t id() const { return id_; }
  explicit operator bool() const { return id_ >= 0; }

 private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

}  // namespace heft::hdf5
