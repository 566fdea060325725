#include "doctor.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <filesystem>

#include "puadem/base/error.hpp"
#include "puadem/base/parallel.hpp"
#include "puadem/build_info.hpp"
#include "puadem/flow/cholesky_factor.hpp"
#include "puadem/flow/multigrid.hpp"
#include "puadem/io/case_templates.hpp"
#include "puadem/io/manifest.hpp"
#include "puadem/io/text.hpp"

namespace puadem {

namespace {

namespace fs = std::filesystem;

bool can_write_here() {
  std::string name = "./.puadem-doctor-XXXXXX";
  const int file = ::mkstemp(name.data());
  if (file < 0) return false;
  ::close(file);
  ::unlink(name.c_str());
  return true;
}

}  // namespace

std::string version_text() {
  return fmt::format("puadem {} ({}, {}, {})", build_info::version, build_info::commit, build_info::compiler,
                     build_info::build_type);
}

bool doctor() {
  int faults = 0;
  const auto line = [&](bool good, std::string_view what, const std::string& found, std::string_view remedy = "") {
    fmt::print("{:<6} {:<18} {}{}{}\n", good ? "ok" : "FAULT", what, found, good || remedy.empty() ? "" : "; ",
               good ? "" : remedy);
    faults += good ? 0 : 1;
  };
  line(true, "version", version_text());
  line(true, "compiler flags", build_info::flags);
  line(true, "libraries",
       fmt::format("CGAL {}, CHOLMOD {}, hypre {}, fmt {}.{}.{}, CLI11 {}", build_info::cgal, cholesky_version(),
                   multigrid_version(), FMT_VERSION / 10000, FMT_VERSION / 100 % 100, FMT_VERSION % 100, CLI11_VERSION));
  line(true, "processor", fmt::format("{}, {} threads", processor_name(), threads()));
  line(can_write_here(), "working folder", fs::current_path().string(),
       "it cannot be written; use --output or change to another folder");
  std::error_code failed;
  const fs::space_info space = fs::space(fs::current_path(), failed);
  const double gigabytes = static_cast<double>(space.available) / 1e9;
  line(!failed && gigabytes > 1.0, "disk space", fmt::format("{:.1f} GB free", gigabytes),
       "less than 1 GB; a run with fields may fill it");
  try {
    const std::string folder = cases_folder().string();
    line(true, "shipped cases", fmt::format("{} in {}", joined(case_templates()), folder));
  } catch (const InputError& error) {
    line(false, "shipped cases", error.what());
  }
  return faults == 0;
}

}  // namespace puadem
