# Third-party libraries, each behind one module.
find_package(CGAL REQUIRED)          # geometry/regular_triangulation.cpp
target_link_libraries(puadem_geometry PRIVATE CGAL::CGAL)
find_path(CHOLMOD_INCLUDE cholmod.h PATH_SUFFIXES suitesparse REQUIRED)  # flow/cholesky_factor.cpp
find_library(CHOLMOD_LIBRARY cholmod REQUIRED)
find_path(HYPRE_INCLUDE HYPRE.h PATH_SUFFIXES hypre REQUIRED)            # flow/multigrid.cpp
find_library(HYPRE_LIBRARY HYPRE REQUIRED)
set(MPI_CXX_SKIP_MPICXX ON)
find_package(MPI REQUIRED COMPONENTS CXX)  # hypre stands on it; one process, no launcher
target_include_directories(puadem_flow SYSTEM PRIVATE ${CHOLMOD_INCLUDE} ${HYPRE_INCLUDE})
target_link_libraries(puadem_flow PRIVATE ${CHOLMOD_LIBRARY} ${HYPRE_LIBRARY} MPI::MPI_CXX ${CMAKE_DL_LIBS})
find_path(TOMLPLUSPLUS_INCLUDE toml++/toml.h REQUIRED)  # io/toml_tree.cpp
target_include_directories(puadem_io SYSTEM PRIVATE ${TOMLPLUSPLUS_INCLUDE})
find_package(PkgConfig REQUIRED)
pkg_check_modules(HDF5 REQUIRED IMPORTED_TARGET hdf5)   # io/hdf5_file.cpp
target_link_libraries(puadem_io PRIVATE PkgConfig::HDF5)
find_package(CLI11 REQUIRED)                            # app/puadem.cpp
include(cmake/report.cmake)
include(cmake/build_info.cmake)         # last: it names the versions found
set_source_files_properties(src/puadem/io/case_templates.cpp PROPERTIES
  COMPILE_DEFINITIONS "PUADEM_CASES_DIR=\"${CMAKE_SOURCE_DIR}/cases\"")
