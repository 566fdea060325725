#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace puadem {

/// One class of a grading curve; diameters uniform between the two bounds by the curve's own measure.
struct GradingClass {
  double diameter_min = 0.0;  ///< [m]
  double diameter_max = 0.0;  ///< [m], equal to diameter_min for a single size
  double fraction = 1.0;      ///< share of the class [-]; the shares add to 1
};

/// A grading: how much of the grains lies in each size class.
struct Grading {
  enum class By { mass, number };
  By by = By::mass;
  std::vector<GradingClass> classes;
};

}  // namespace puadem
