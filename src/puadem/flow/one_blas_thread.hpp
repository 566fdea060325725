#pragma once

#include <dlfcn.h>

namespace puadem {

/// Where the linear algebra library has threads of its own, it uses one while this lives: the bits of a
/// factor must not depend on the machine. CHOLMOD's own loops ask OpenMP for four threads whatever it is set to, and these
/// wait for one another busily: half of a run's processor time, and far more where the machine does other work.
class OneBlasThread {
 public:
  OneBlasThread() {
    if (get_ != nullptr && set_ != nullptr) {
      before_ = get_();
      set_(1);
    }
    if (get_levels_ != nullptr && set_levels_ != nullptr) {
      levels_before_ = get_levels_();
      set_levels_(0);
    }
  }
  ~OneBlasThread() {
    if (before_ > 0) set_(before_);
    if (levels_before_ > 0) set_levels_(levels_before_);
  }
  OneBlasThread(const OneBlasThread&) = delete;
  OneBlasThread& operator=(const OneBlasThread&) = delete;

 private:
  int (*get_)() = reinterpret_cast<int (*)()>(dlsym(RTLD_DEFAULT, "openblas_get_num_threads"));
  void (*set_)(int) = reinterpret_cast<void (*)(int)>(dlsym(RTLD_DEFAULT, "openblas_set_num_threads"));
  int before_ = 0;
  int (*get_levels_)() = reinterpret_cast<int (*)()>(dlsym(RTLD_DEFAULT, "omp_get_max_active_levels"));
  void (*set_levels_)(int) = reinterpret_cast<void (*)(int)>(dlsym(RTLD_DEFAULT, "omp_set_max_active_levels"));
  int levels_before_ = 0;
};

}  // namespace puadem
