#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <optional>

namespace puadem {

nlohmann::json json_of(const auto& value) { return value; }
template <class T>
nlohmann::json json_of(const std::optional<T>& value) {
  return value ? nlohmann::json(*value) : nlohmann::json(nullptr);
}

/// A quantity of every row, for the page's figures: a member of the rows, or what a function makes of each.
template <class Rows, class Value>
nlohmann::json column(const Rows& rows, const Value& value) {
  nlohmann::json values = nlohmann::json::array();
  for (const auto& row : rows) values.push_back(json_of(std::invoke(value, row)));
  return values;
}

}  // namespace puadem
