#include "core/base/library_on_demand.h"

#include <dlfcn.h>

#include <stdexcept>
#include <string_view>

#include "core/base/say.h"

namespace heft {

void* LibraryOnDemand::handle() const {
  void* known = handle_.load(std::memory_order_acquire);
  // Two threads that come at once get the same handle; the loader counts it twice.
  if (!known && (known = dlopen(file_, RTLD_NOW | RTLD_LOCAL))) handle_.store(known, std::memory_order_release);
  return known;
}

std::string LibraryOnDemand::problem() const {
  if (handle()) return {};
  const std::string_view package = package_;
  if (package.empty()) return say("The library {} is missing. Install the package that holds it.", file_);
  return say("The library {} is missing. Install it: apt-get install {}", file_, package);
}

void* LibraryOnDemand::symbol(const char* name) const {
  void* library = handle();
  if (!library) throw std::runtime_error(problem());
  // A variable that a program links to itself lives in the program, and the library uses it there.
  void* found = dlsym(RTLD_DEFAULT, name);
  if (!found) found = dlsym(library, name);
  if (!found) throw std::runtime_error(say("The library {} has no {}: it is of another version.", file_, name));
  return found;
}

}  // namespace heft
