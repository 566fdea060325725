#pragma once

#include <string_view>

namespace puadem {

/// The files of web/ that a report is made of, as they were when the program was built.
std::string_view report_page();    ///< web/page.html
std::string_view report_style();   ///< web/page.css
std::string_view report_script();  ///< web/dist/report.js

}  // namespace puadem
