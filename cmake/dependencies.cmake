# Third-party libraries, each behind one module.
find_package(CGAL REQUIRED)          # geometry/regular_triangulation.cpp
target_link_libraries(puadem_geometry PRIVATE CGAL::CGAL)
