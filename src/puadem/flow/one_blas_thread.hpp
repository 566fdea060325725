#pragma once

#include <dlfcn.h>

namespace puadem {

/// Where the linear algebra library has threads of its own, it uses one while this lives: the bits of a
/// factor must not depend on the machine.
class OneBlasThread {
 public:
  OneBlasThread() {
    if (get_ != nullptr && set_ != nullptr) {
      before_ = get_();
      set_(1);
    }
  }
  ~OneBlasThread() {
    if (before_ > 0) set_(before_);
  }
  OneBlasThread(const OneBlasThread&) = delete;
  OneBlasThread& operator=(const OneBlasThread&) = delete;

 private:
  int (*get_)() = reinterpret_cast<int (*)()>(dlsym(RTLD_DEFAULT, "openblas_get_num_threads"));
  void (*set_)(int) = reinterpret_cast<void (*)(int)>(dlsym(RTLD_DEFAULT, "openblas_set_num_threads"));
  int before_ = 0;
};

}  // namespace puadem
