#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace puadem {

/// Folder of the shipped cases: beside the program's installation, else in its sources.
/// @throws InputError where neither exists
std::filesystem::path cases_folder();

/// Names of the shipped cases.
std::vector<std::string> case_templates();

/// Copies a shipped case with its reference data into a new folder, whole or not at all.
/// @param target  empty: a folder of the template's name in the working directory
/// @return the folder
/// @throws InputError  an unknown template (with the nearest name), a folder that is not empty or cannot be written
std::filesystem::path new_case(const std::string& name, std::filesystem::path target);

}  // namespace puadem
