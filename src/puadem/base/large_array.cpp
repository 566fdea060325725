#include "puadem/base/large_array.hpp"

#if defined(__linux__)
#include <sys/mman.h>

#include <cstdint>
#endif

namespace puadem::detail {

namespace {
constexpr std::size_t page = LargePages<char>::page;
}

#if defined(__linux__)

namespace {
std::size_t whole_pages(std::size_t bytes) { return (bytes + page - 1) / page * page; }
}  // namespace

void* take_pages(std::size_t bytes) {
  const std::size_t wanted = whole_pages(bytes), mapped = wanted + page;
  void* raw = mmap(nullptr, mapped, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (raw == MAP_FAILED) throw std::bad_alloc();
  char* start = static_cast<char*>(raw);
  const std::size_t before = (page - reinterpret_cast<std::uintptr_t>(raw) % page) % page, after = page - before;
  if (before > 0) munmap(start, before);
  if (after > 0) munmap(start + before + wanted, after);
  madvise(start + before, wanted, MADV_HUGEPAGE);  // a wish: nothing is lost where it is refused
  return start + before;
}

void give_pages(void* memory, std::size_t bytes) { munmap(memory, whole_pages(bytes)); }

#else

void* take_pages(std::size_t bytes) { return ::operator new (bytes, std::align_val_t{page}); }
void give_pages(void* memory, std::size_t) { ::operator delete (memory, std::align_val_t{page}); }

#endif

}  // namespace puadem::detail
