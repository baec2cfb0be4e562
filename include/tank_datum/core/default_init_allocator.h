#pragma once

#include <memory>
#include <new>
#include <utility>

#include "tank_datum/core/export.h"

namespace TANK_DATUM_API tank_datum {

/// Allocates room without writing zeros to it, for millions of values that several threads are about to fill.
template <typename T>
struct DefaultInitAllocator : std::allocator<T> {
  template <typename Other>
  struct rebind {
    using other = DefaultInitAllocator<Other>;
  };
  template <typename Other>
  void construct(Other* at) {
    ::new (static_cast<void*>(at)) Other;
  }
  template <typename Other, typename... Values>
  void construct(Other* at, Values&&... values) {
    ::new (static_cast<void*>(at)) Other(std::forward<Values>(values)...);
  }
};

}  // namespace tank_datum
