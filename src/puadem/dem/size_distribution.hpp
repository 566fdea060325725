#pragma once

#include <variant>
#include <vector>

#include "puadem/dem/grading.hpp"

namespace puadem {

/// Diameters whose number falls as a power between two bounds, theory 2.15.
struct PowerLawSizes {
  double lower = 0.0;     ///< [m]
  double upper = 0.0;     ///< [m], >= lower
  double exponent = 0.0;  ///< number in dd goes as d^-exponent [-]
};

/// Diameters whose logarithm is normal by number, cut at two bounds.
struct LogNormalSizes {
  double lower = 0.0;      ///< [m]
  double upper = 0.0;      ///< [m], > lower
  double median = 0.0;     ///< of the uncut curve [m]
  double log_width = 0.0;  ///< standard deviation of ln d [-]
};

using AnySizes = std::variant<PowerLawSizes, LogNormalSizes>;

/// Diameter below which the share u of the grains lies, by number [m]; u in [0, 1].
double quantile(const AnySizes& sizes, double u);

/// Mean of d^k over the grains, by number [m^k].
double mean_power(const AnySizes& sizes, int k);

struct SizeClass {
  AnySizes sizes;
  double share = 0.0;  ///< by the measure of the grading [-]; they add to 1
};

/// Any grading as classes whose sizes have closed forms.
/// @throws InputError  no form or more than one; bounds, shares or curves out of range or order
std::vector<SizeClass> size_classes(const Grading& grading);

/// Shares of the classes by number [-].
std::vector<double> number_shares(const std::vector<SizeClass>& classes, Grading::By by);

}  // namespace puadem
