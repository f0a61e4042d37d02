#pragma once
// What belongs to the workspace outlives the window, which is replaced when the language changes.
#include <QObject>

namespace heft {

/// The one child of this class that `owner` has; made when it is first asked for.
template <class Child>
Child* onlyChild(QObject& owner) {
  for (QObject* child : owner.children())
    if (auto* there = dynamic_cast<Child*>(child)) return there;
  return new Child(&owner);
}

}  // namespace heft
