#pragma once
// Libraries for formats that most runs never meet are loaded when a function of theirs is first called: HDF5 alone
// brings thirty others, and loading them took half of the time in which a program started. Programs do not link to
// them; a header of the reader's names their functions as objects of the same name, which hide the library's own
// declarations:
//   inline const FunctionOnDemand<decltype(::H5Fopen)> H5Fopen{hdf5Library, "H5Fopen"};
// A function that is called without such an object is an undefined symbol when a program is linked.
#include <atomic>
#include <string>

namespace heft {

/// A shared library that is loaded at its first use and stays. Threads may share it.
class LibraryOnDemand {
 public:
  /// \param file what the dynamic loader looks for, with the version: "libhdf5_serial.so.103".
  /// \param package the Debian package that brings it, for the message; may be empty.
  constexpr LibraryOnDemand(const char* file, const char* package) : file_(file), package_(package) {}

  /// One sentence that says what to install; empty where the library is there.
  std::string problem() const;
  /// \throws std::runtime_error where the library or this symbol of it is missing.
  void* symbol(const char* name) const;

 private:
  void* handle() const;

  const char* file_;
  const char* package_;
  mutable std::atomic<void*> handle_{nullptr};
};

/// Where a symbol of a library on demand lies.
class SymbolOnDemand {
 public:
  constexpr SymbolOnDemand(const LibraryOnDemand& library, const char* name) : library_(library), name_(name) {}
  void* address() const {
    void* known = address_.load(std::memory_order_acquire);
    if (!known) address_.store(known = library_.symbol(name_), std::memory_order_release);
    return known;
  }

 private:
  const LibraryOnDemand& library_;
  const char* name_;
  mutable std::atomic<void*> address_{nullptr};
};

template <class Signature>
class FunctionOnDemand;

/// A function of a library on demand, called and passed on like the function itself.
template <class R, class... A>
class FunctionOnDemand<R(A...)> {
 public:
  constexpr FunctionOnDemand(const LibraryOnDemand& library, const char* name) : symbol_(library, name) {}
  R operator()(A... arguments) const { return pointer()(arguments...); }
  operator auto() const { return pointer(); }

 private:
  auto pointer() const { return reinterpret_cast<R (*)(A...)>(symbol_.address()); }
  SymbolOnDemand symbol_;
};

/// A variable of a library on demand, read like the variable itself.
template <class T>
class VariableOnDemand {
 public:
  constexpr VariableOnDemand(const LibraryOnDemand& library, const char* name) : symbol_(library, name) {}
  operator T() const { return *static_cast<const T*>(symbol_.address()); }

 private:
  SymbolOnDemand symbol_;
};

}  // namespace heft
