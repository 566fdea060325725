# The report's page, style and script go into the program: it needs no file beside it, no node, no net.
find_package(nlohmann_json REQUIRED)  # io/manifest.cpp, io/report*.cpp
target_link_libraries(puadem_io PRIVATE nlohmann_json::nlohmann_json)
set(web ${CMAKE_CURRENT_SOURCE_DIR}/web)
set_source_files_properties(${CMAKE_CURRENT_SOURCE_DIR}/src/puadem/io/report_assets.cpp PROPERTIES
  COMPILE_DEFINITIONS "PUADEM_WEB_DIR=\"${web}\""
  OBJECT_DEPENDS "${web}/page.html;${web}/page.css;${web}/dist/report.js")
