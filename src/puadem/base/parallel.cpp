#include "puadem/base/parallel.hpp"

#include <omp.h>

namespace puadem {

namespace {
int thread_count = 0;
}

void set_threads(int threads) {
  assert(threads >= 0);
  thread_count = threads;
}

int threads() { return thread_count > 0 ? thread_count : omp_get_max_threads(); }

void detail::run_blocks(int blocks, void (*body)(void*, int), void* context) {
  std::exception_ptr first;
  int first_block = blocks;
#pragma omp parallel for schedule(static) num_threads(threads())
  for (int block = 0; block < blocks; ++block) {
    try {
      body(context, block);
    } catch (...) {
#pragma omp critical(puadem_first_exception)
      if (block < first_block) {
        first_block = block;
        first = std::current_exception();
      }
    }
  }
  if (first) std::rethrow_exception(first);
}

}  // namespace puadem
