#pragma once

#include <cstddef>
#include <new>
#include <vector>

namespace puadem {

namespace detail {
/// Bytes of memory in pages of 2 MiB, where the system grants them, given back to it as a whole.
void* take_pages(std::size_t bytes);
void give_pages(void* memory, std::size_t bytes);
}  // namespace detail

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

  T* allocate(std::size_t n) {
    if (is_large(n)) return static_cast<T*>(detail::take_pages(n * sizeof(T)));
    return static_cast<T*>(::operator new (n * sizeof(T), std::align_val_t{alignof(T)}));
  }
  void deallocate(T* memory, std::size_t n) {
    if (is_large(n)) return detail::give_pages(memory, n * sizeof(T));
    ::operator delete (memory, std::align_val_t{alignof(T)});
  }
  bool operator==(const LargePages&) const = default;
};

/// A vector for the arrays that hot loops go through.
template <class T>
using LargeArray = std::vector<T, LargePages<T>>;

}  // namespace puadem
