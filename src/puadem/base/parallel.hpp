#pragma once

#include <cassert>
#include <cstddef>
#include <exception>
#include <vector>

namespace puadem {

/// Index to container size: the one place where a sign is dropped.
constexpr std::size_t to_size(int i) {
  assert(i >= 0);
  return static_cast<std::size_t>(i);
}
template <class Container>
int size_of(const Container& container) {
  return static_cast<int>(container.size());
}

/// Number of threads that `parallel_for` uses from now on; 0 takes what the machine offers.
void set_threads(int threads);
int threads();

namespace detail {
void run_blocks(int blocks, void (*body)(void*, int), void* context);
}

/// Calls `body(i)` for 0 <= i < n on all threads. The bodies must write to places of their own:
/// then the result has the same bits on any number of threads. An exception thrown by a body is
/// rethrown here, the one of the lowest block where several threw.
template <class Body>
void parallel_for(int n, const Body& body, int grain = 512) {
  if (n <= 0) return;
  const int blocks = (n + grain - 1) / grain;
  if (blocks == 1 || threads() == 1) {
    for (int i = 0; i < n; ++i) body(i);
    return;
  }
  struct Context {
    const Body& body;
    int n, grain;
  } context{body, n, grain};
  detail::run_blocks(
      blocks,
      [](void* raw, int block) {
        const auto& c = *static_cast<Context*>(raw);
        const int end = block * c.grain + c.grain < c.n ? block * c.grain + c.grain : c.n;
        for (int i = block * c.grain; i < end; ++i) c.body(i);
      },
      &context);
}

/// Sum of `term(i)` for 0 <= i < n, added in blocks of fixed size and the blocks in order: the same
/// bits on any number of threads. T needs T{} and +=.
template <class T, class Term>
T parallel_sum(int n, const Term& term) {
  constexpr int block_size = 1024;
  const int blocks = (n + block_size - 1) / block_size;
  std::vector<T> partial(to_size(blocks));
  parallel_for(
      blocks,
      [&](int block) {
        T sum{};
        const int end = (block + 1) * block_size < n ? (block + 1) * block_size : n;
        for (int i = block * block_size; i < end; ++i) sum += term(i);
        partial[to_size(block)] = sum;
      },
      1);
  T sum{};
  for (const T& p : partial) sum += p;
  return sum;
}

}  // namespace puadem
