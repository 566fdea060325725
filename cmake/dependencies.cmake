# Third-party libraries, each behind one module.
find_package(CGAL REQUIRED)          # geometry/regular_triangulation.cpp
target_link_libraries(puadem_geometry PRIVATE CGAL::CGAL)
find_path(TOMLPLUSPLUS_INCLUDE toml++/toml.h REQUIRED)  # io/toml_tree.cpp
target_include_directories(puadem_io SYSTEM PRIVATE ${TOMLPLUSPLUS_INCLUDE})
find_package(CLI11 REQUIRED)                            # app/puadem.cpp
include(cmake/report.cmake)
include(cmake/build_info.cmake)         # last: it names the versions found
set_source_files_properties(src/puadem/io/case_templates.cpp PROPERTIES
  COMPILE_DEFINITIONS "PUADEM_CASES_DIR=\"${CMAKE_SOURCE_DIR}/cases\"")
