#include "puadem/io/case_templates.hpp"

#include <unistd.h>

#include <algorithm>
#include <system_error>

#include "puadem/base/error.hpp"
#include "puadem/io/text.hpp"

namespace puadem {

namespace {

namespace fs = std::filesystem;

bool is_case(const fs::path& folder) {
  std::error_code failed;
  return fs::is_regular_file(folder / "case.toml", failed);
}

/// Removes a folder unless told that it is complete.
struct Unfinished {
  fs::path path;
  bool keep = false;
  ~Unfinished() {
    std::error_code ignored;
    if (!keep) fs::remove_all(path, ignored);
  }
};

}  // namespace

fs::path cases_folder() {
  std::error_code failed;
  const fs::path program = fs::read_symlink("/proc/self/exe", failed);
  const fs::path installed = program.parent_path().parent_path() / "share" / "puadem" / "cases";
  for (const fs::path& folder : {installed, fs::path(PUADEM_CASES_DIR)})
    if (fs::is_directory(folder, failed)) return folder;
  throw InputError(
      fmt::format("the shipped cases are neither in {} nor in {}; install puadem again", installed.string(), PUADEM_CASES_DIR));
}

std::vector<std::string> case_templates() {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(cases_folder()))
    if (is_case(entry.path())) names.push_back(entry.path().filename().string());
  std::ranges::sort(names);
  return names;
}

fs::path new_case(const std::string& name, fs::path target) {
  const std::vector<std::string> names = case_templates();
  require(std::ranges::find(names, name) != names.end(), "no template \"{}\"; there are: {}{}", name, joined(names),
          did_you_mean(name, names));
  if (target.empty()) target = name;
  std::error_code failed;
  require(!fs::exists(target, failed) || (fs::is_directory(target, failed) && fs::is_empty(target, failed)),
          "{} exists already; name another folder: puadem new {} FOLDER", target.string(), name);

  // Beside the target, so that renaming is one step on one file system.
  fs::path clean = fs::absolute(target).lexically_normal();
  if (clean.filename().empty()) clean = clean.parent_path();
  Unfinished copy{clean.parent_path() / fmt::format(".{}.{}.part", clean.filename().string(), ::getpid())};
  try {
    fs::create_directories(clean.parent_path());
    fs::create_directory(copy.path);
    for (const auto& entry : fs::directory_iterator(cases_folder() / name))
      if (entry.is_regular_file()) fs::copy_file(entry.path(), copy.path / entry.path().filename());
    if (fs::is_directory(cases_folder() / name / "reference"))
      fs::copy(cases_folder() / name / "reference", copy.path / "reference", fs::copy_options::recursive);
    fs::rename(copy.path, clean);
    copy.keep = true;
  } catch (const fs::filesystem_error& error) {
    throw InputError(fmt::format("{} cannot be written: {}", target.string(), error.code().message()));
  }
  return target;
}

}  // namespace puadem
