#include "puadem/flow/cholesky_factor.hpp"

#include <cholmod.h>

#include <algorithm>
#include <array>

#include "puadem/base/error.hpp"
#include "puadem/flow/one_blas_thread.hpp"

namespace puadem {

struct CholeskyFactor::Parts {
  cholmod_common common{};
  cholmod_sparse* lower = nullptr;  // lower triangle, by columns
  cholmod_factor* factor = nullptr;
  cholmod_dense *solution = nullptr, *work_y = nullptr, *work_e = nullptr;

  Parts() {
    cholmod_l_start(&common);
    common.print = 0;     // errors are ours to report
    common.final_ll = 1;  // a factor with square roots: no negative pivot passes
    common.nmethods = 1;
    common.method[0].ordering = CHOLMOD_METIS;  // nested dissection: these networks fill space
  }
  ~Parts() {
    cholmod_l_free_factor(&factor, &common);
    cholmod_l_free_sparse(&lower, &common);
    cholmod_l_free_dense(&solution, &common);
    cholmod_l_free_dense(&work_y, &common);
    cholmod_l_free_dense(&work_e, &common);
    cholmod_l_finish(&common);
  }
  Parts(const Parts&) = delete;
  Parts& operator=(const Parts&) = delete;
};

CholeskyFactor::CholeskyFactor(const NetworkMatrix& matrix) : parts_(std::make_unique<Parts>()) {
  cholmod_common& common = parts_->common;
  const auto n = to_size(matrix.rows());
  const auto entries = (matrix.value.size() + n) / 2;
  cholmod_sparse*& lower = parts_->lower;
  lower = cholmod_l_allocate_sparse(n, n, entries, 1, 1, -1, CHOLMOD_REAL, &common);
  ensure(lower != nullptr, "out of memory for a pressure system of {} unknowns", matrix.rows());
  auto *start = static_cast<SuiteSparse_long*>(lower->p), *row = static_cast<SuiteSparse_long*>(lower->i);
  SuiteSparse_long at = 0;
  for (int c = 0; c < matrix.rows(); ++c) {  // the matrix is symmetric: what follows the diagonal of row c is column c below it
    start[c] = at;
    for (int e = matrix.diagonal_entry[to_size(c)]; e < matrix.pattern.start[to_size(c) + 1]; ++e)
      row[at++] = matrix.pattern.index[to_size(e)];
  }
  start[matrix.rows()] = at;
  const OneBlasThread one;
  parts_->factor = cholmod_l_analyze(lower, &common);
  ensure(parts_->factor != nullptr, "a pressure system of {} unknowns could not be ordered for factorisation: out of memory",
         matrix.rows());
}

CholeskyFactor::~CholeskyFactor() = default;

void CholeskyFactor::factorise(const NetworkMatrix& matrix) {
  const OneBlasThread one;
  cholmod_common& common = parts_->common;
  auto* value = static_cast<double*>(parts_->lower->x);
  for (int c = 0; c < matrix.rows(); ++c)
    for (int e = matrix.diagonal_entry[to_size(c)]; e < matrix.pattern.start[to_size(c) + 1]; ++e)
      *value++ = matrix.value[to_size(e)];
  cholmod_l_factorize(parts_->lower, parts_->factor, &common);
  ensure(common.status != CHOLMOD_OUT_OF_MEMORY, "out of memory: the factor of {} pressures takes {:.1f} GB; choose multigrid",
         matrix.rows(), 1e-9 * bytes());
  ensure(common.status == CHOLMOD_OK && parts_->factor->minor == parts_->factor->n,
         "the pressure system of {} unknowns is not positive definite", matrix.rows());
}

void CholeskyFactor::solve(std::span<const double> b, std::span<double> x) {
  const OneBlasThread one;
  cholmod_dense right{};
  right.nrow = right.nzmax = right.d = b.size();
  right.ncol = 1;
  right.x = const_cast<double*>(b.data());  // only read
  right.xtype = CHOLMOD_REAL;
  right.dtype = CHOLMOD_DOUBLE;
  cholmod_l_solve2(CHOLMOD_A, parts_->factor, &right, nullptr, &parts_->solution, nullptr, &parts_->work_y, &parts_->work_e,
                   &parts_->common);
  std::copy_n(static_cast<const double*>(parts_->solution->x), x.size(), x.begin());
}

double CholeskyFactor::bytes() const { return 8.0 * parts_->common.lnz; }

std::string cholesky_version() {
  std::array<int, 3> v{};
  cholmod_l_version(v.data());
  return fmt::format("{}.{}.{}", v[0], v[1], v[2]);
}

}  // namespace puadem
