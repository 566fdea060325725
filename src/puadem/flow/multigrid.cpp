#include "puadem/flow/multigrid.hpp"

#include <HYPRE.h>
#include <HYPRE_IJ_mv.h>
#include <HYPRE_parcsr_ls.h>
#include <mpi.h>

#include <algorithm>
#include <cstdlib>

#include "puadem/base/error.hpp"
#include "puadem/flow/one_blas_thread.hpp"

// What a leak checker offers where one is linked in; nil otherwise.
extern "C" {
[[gnu::weak]] void __lsan_disable();
[[gnu::weak]] void __lsan_enable();
}

namespace puadem {

namespace {

/// MPI, which the library stands on: started by the first who needs it, without any launcher, and ended
/// with the program.
void start_mpi() {
  static const struct Session {
    bool ours = false;
    Session() {
      int running = 0;
      MPI_Initialized(&running);
      ours = !running;
      if (!ours) return;
      if (std::getenv("OMPI_COMM_WORLD_SIZE") == nullptr && std::getenv("PMIX_RANK") == nullptr) {
        // One process, no launcher: it needs no daemon beside it, and no search for network cards, a fifth of a second.
        setenv("OMPI_MCA_ess_singleton_isolated", "1", 0);
        setenv("OMPI_MCA_pml", "ob1", 0);
      }
      if (__lsan_disable != nullptr) __lsan_disable();  // what it never frees is not ours
      int provided = 0;
      MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided);
      if (__lsan_enable != nullptr) __lsan_enable();
    }
    ~Session() {
      int ended = 0;
      MPI_Finalized(&ended);
      if (__lsan_disable != nullptr) __lsan_disable();
      if (ours && !ended) MPI_Finalize();
      if (__lsan_enable != nullptr) __lsan_enable();
    }
  } session;
}

HYPRE_ParCSRMatrix object_of(HYPRE_IJMatrix matrix) {
  void* object = nullptr;
  HYPRE_IJMatrixGetObject(matrix, &object);
  return static_cast<HYPRE_ParCSRMatrix>(object);
}
HYPRE_ParVector object_of(HYPRE_IJVector vector) {
  void* object = nullptr;
  HYPRE_IJVectorGetObject(vector, &object);
  return static_cast<HYPRE_ParVector>(object);
}

}  // namespace

struct Multigrid::Parts {
  HYPRE_IJMatrix matrix = nullptr;
  HYPRE_IJVector right = nullptr, result = nullptr;
  HYPRE_Solver solver = nullptr;

  explicit Parts(int rows) {
    HYPRE_IJMatrixCreate(MPI_COMM_SELF, 0, rows - 1, 0, rows - 1, &matrix);
    HYPRE_IJMatrixSetObjectType(matrix, HYPRE_PARCSR);
    for (auto* vector : {&right, &result}) {
      HYPRE_IJVectorCreate(MPI_COMM_SELF, 0, rows - 1, vector);
      HYPRE_IJVectorSetObjectType(*vector, HYPRE_PARCSR);
      HYPRE_IJVectorInitialize(*vector);
      HYPRE_IJVectorAssemble(*vector);
    }
  }
  ~Parts() {
    if (solver != nullptr) HYPRE_BoomerAMGDestroy(solver);
    HYPRE_IJMatrixDestroy(matrix);
    HYPRE_IJVectorDestroy(right);
    HYPRE_IJVectorDestroy(result);
  }
  Parts(const Parts&) = delete;
  Parts& operator=(const Parts&) = delete;

  void fill(const NetworkMatrix& from);
};

Multigrid::Multigrid(const NetworkMatrix& matrix) {
  start_mpi();
  parts_ = std::make_unique<Parts>(matrix.rows());
}

Multigrid::~Multigrid() = default;

void Multigrid::Parts::fill(const NetworkMatrix& from) {
  std::vector<int> row(to_size(from.rows())), columns(to_size(from.rows()));
  double scale = 0.0;  // numbers near 1, whatever the units
  for (int r = 0; r < from.rows(); ++r) {
    row[to_size(r)] = r;
    columns[to_size(r)] = size_of(from.pattern[r]);
    scale = std::max(scale, from.value[to_size(from.diagonal_entry[to_size(r)])]);
  }
  std::vector<double> value(from.value);
  for (double& v : value) v /= scale;
  HYPRE_IJMatrixSetDiagOffdSizes(matrix, columns.data(), std::vector<int>(columns.size(), 0).data());
  HYPRE_IJMatrixInitialize(matrix);
  HYPRE_IJMatrixSetValues(matrix, from.rows(), columns.data(), row.data(), from.pattern.index.data(), value.data());
  HYPRE_IJMatrixAssemble(matrix);
}

void Multigrid::set_up(const NetworkMatrix& matrix) {
  const OneBlasThread one;
  parts_->fill(matrix);
  HYPRE_Solver& solver = parts_->solver;
  if (solver != nullptr) HYPRE_BoomerAMGDestroy(solver);
  HYPRE_BoomerAMGCreate(&solver);
  HYPRE_BoomerAMGSetPrintLevel(solver, 0);
  HYPRE_BoomerAMGSetMaxIter(solver, 1);  // one cycle a call, whatever it leaves
  HYPRE_BoomerAMGSetTol(solver, 0.0);
  HYPRE_BoomerAMGSetCoarsenType(solver, 10);  // HMIS
  HYPRE_BoomerAMGSetInterpType(solver, 6);    // extended
  HYPRE_BoomerAMGSetPMaxElmts(solver, 4);
  HYPRE_BoomerAMGSetCycleRelaxType(solver, 13, 1);  // Gauss-Seidel forwards on the way down,
  HYPRE_BoomerAMGSetCycleRelaxType(solver, 14, 2);  // backwards on the way up: symmetric
  HYPRE_BoomerAMGSetCycleRelaxType(solver, 9, 3);
  HYPRE_BoomerAMGSetNumSweeps(solver, 1);
  HYPRE_BoomerAMGSetup(solver, object_of(parts_->matrix), object_of(parts_->right), object_of(parts_->result));
  const int error = HYPRE_GetError();
  HYPRE_ClearAllErrors();
  ensure(error == 0, "algebraic multigrid could not be set up for {} pressures (error {})", matrix.rows(), error);
}

void Multigrid::apply(std::span<const double> b, std::span<double> x) {
  const int n = size_of(b);
  std::ranges::fill(x, 0.0);
  HYPRE_IJVectorSetValues(parts_->right, n, nullptr, b.data());
  HYPRE_IJVectorSetValues(parts_->result, n, nullptr, x.data());
  HYPRE_BoomerAMGSolve(parts_->solver, object_of(parts_->matrix), object_of(parts_->right), object_of(parts_->result));
  HYPRE_ClearAllErrors();  // it counts a cycle that missed the tolerance of nil as one
  HYPRE_IJVectorGetValues(parts_->result, n, nullptr, x.data());
}

std::string multigrid_version() { return HYPRE_RELEASE_VERSION; }

}  // namespace puadem
