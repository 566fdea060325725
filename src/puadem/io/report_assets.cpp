#include "puadem/io/report_assets.hpp"

#include <cstddef>

// The assembler copies the files into the read-only data: a megabyte of script would cost the compiler
// seconds as an array of numbers.
#define PUADEM_EMBED(symbol, file)                        \
  asm(".pushsection .rodata\n"                            \
      ".global " #symbol                                  \
      "\n"                                                \
      ".global " #symbol "_end\n" #symbol                 \
      ":\n"                                               \
      ".incbin \"" PUADEM_WEB_DIR "/" file "\"\n" #symbol \
      "_end:\n"                                           \
      ".byte 0\n"                                         \
      ".popsection\n");                                   \
  extern "C" const char symbol[];                         \
  extern "C" const char symbol##_end[]

PUADEM_EMBED(puadem_report_page, "page.html");
PUADEM_EMBED(puadem_report_style, "page.css");
PUADEM_EMBED(puadem_report_script, "dist/report.js");

namespace puadem {
namespace {

std::string_view between(const char* begin, const char* end) { return {begin, static_cast<std::size_t>(end - begin)}; }

}  // namespace

std::string_view report_page() { return between(puadem_report_page, puadem_report_page_end); }
std::string_view report_style() { return between(puadem_report_style, puadem_report_style_end); }
std::string_view report_script() { return between(puadem_report_script, puadem_report_script_end); }

}  // namespace puadem
