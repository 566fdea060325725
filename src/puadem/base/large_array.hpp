#pragma once

#if defined(__linux__)
#include <sys/mman.h>
#endif

#include <cstddef>
#include <new>
#include <vector>

namespace puadem {

/// Allocator that asks the system for pages of 2 MiB where an array spans several of them: loops that jump
/// through large arrays then seldom wait for the translation of an address.
template <class T>
struct LargePages {
  using value_type = T;
  static constexpr std::size_t page = std::size_t{1} << 21;

  LargePages() = default;
  template <class U>
  LargePages(const LargePages<U>&) {}

  static bool is_large(std::size_t n) { return n * sizeof(T) >= 2 * page; }
  static std::align_val_t alignment(std::size_t n) { return std::align_val_t{is_large(n) ? page : alignof(T)}; }

  T* allocate(std::size_t n) {
    void* memory = ::operator new(n * sizeof(T), alignment(n));
#if defined(__linux__)
    if (is_large(n)) madvise(memory, n * sizeof(T), MADV_HUGEPAGE);  // a wish: nothing is lost where it is refused
#endif
    return static_cast<T*>(memory);
  }
  void deallocate(T* memory, std::size_t n) { ::operator delete(memory, alignment(n)); }
  bool operator==(const LargePages&) const = default;
};

/// A vector for the arrays that hot loops go through.
template <class T>
using LargeArray = std::vector<T, LargePages<T>>;

}  // namespace puadem
