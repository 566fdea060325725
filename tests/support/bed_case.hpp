#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "puadem/base/error.hpp"
#include "puadem/io/case_file.hpp"

namespace puadem::testing {

/// A bed of glass and the begin of the stage after it, whose keys a test adds. @param domain  its table, or nothing
inline std::string bed_case(const std::string& kind, const std::string& domain = {}) {
  return "title = \"bed\"\n" + domain + R"([grains]
count = 500
material = "glass"
grading = { by = "number", classes = [{ diameter = "0.3 mm", fraction = 1.0 }] }
[materials.glass]
density = "2650 kg/m3"
[[stage]]
kind = "compact"
stress = "10 kPa"
[[stage]]
kind = ")" +
         kind + "\"\n";
}

inline const std::string between_plates = "[domain]\nperiodic = [\"x\", \"y\"]\n";

inline void expect_case_error(const std::string& text, const std::string& message) {
  EXPECT_THAT([&] { parse_case(text, "case.toml", "/study"); },
              ::testing::ThrowsMessage<InputError>(::testing::HasSubstr(message)))
      << text;
}

}  // namespace puadem::testing
