#include "puadem/io/text.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "puadem/base/error.hpp"
#include "puadem/io/text_file.hpp"
#include "support/temporary_folder.hpp"

namespace puadem {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

TEST(Text, PutsTheCaretBelowThePlace) {
  const SourceText source{"a.toml", "first\nsize = \"3 kPa\"\n"};
  EXPECT_EQ(located(source, {0, 2, 8}, "wrong"), "a.toml:2:8: wrong\n  2 | size = \"3 kPa\"\n    |        ^");
}

TEST(Text, CaretCountsCharactersNotBytes) {
  const SourceText source{"a.toml", "t = \"\xC2\xB5\xC2\xB5m\" # x"};
  EXPECT_THAT(located(source, {0, 1, 8}, "wrong"), HasSubstr("\n    |        ^"));
}

TEST(Text, ShortensLongLinesAroundTheCaret) {
  const SourceText source{"a.toml", std::string(500, 'a') + "X" + std::string(500, 'b')};
  const std::string message = located(source, {0, 1, 501}, "wrong");
  const std::string excerpt(line_of(message, 2)), caret(line_of(message, 3));
  EXPECT_LT(excerpt.size(), 130U);
  EXPECT_EQ(excerpt[caret.find('^')], 'X');
}

TEST(Text, ControlCharactersDoNotReachTheTerminal) {
  EXPECT_THAT(located({"a", "x\x1b[31m\ty"}, {0, 1, 1}, "m"), Not(HasSubstr("\x1b")));
}

TEST(Text, SuggestsTheNearestWord) {
  const std::vector<std::string> words{"surface_tension", "contact_angle", "wetting", "nonwetting"};
  EXPECT_EQ(nearest("surface_tensoin", words), "surface_tension");
  EXPECT_EQ(nearest("Contact_Angle", words), "contact_angle");
  EXPECT_EQ(nearest("surface", words), "surface_tension");
  EXPECT_EQ(nearest("weting", words), "wetting");
  EXPECT_EQ(nearest("porosity", words), std::nullopt);
  EXPECT_EQ(nearest("", words), std::nullopt);
}

TEST(Text, FindsBytesThatAreNoUtf8) {
  EXPECT_EQ(first_invalid_utf8("plain \xC2\xB5 \xE2\x82\xAC \xF0\x9F\x98\x80"), std::nullopt);
  EXPECT_EQ(first_invalid_utf8("ab\xFF"), 2U);
  EXPECT_EQ(first_invalid_utf8("\xC0\xAF"), 0U);          // overlong
  EXPECT_EQ(first_invalid_utf8("a\xED\xA0\x80"), 1U);     // surrogate
  EXPECT_EQ(first_invalid_utf8("\xF4\x90\x80\x80"), 0U);  // beyond U+10FFFF
  EXPECT_EQ(first_invalid_utf8("abc\xE2\x82"), 3U);       // truncated
}

std::string error_of_reading(const std::filesystem::path& path) {
  try {
    read_text_file(path);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(TextFile, SaysWhyAFileCannotBeRead) {
  const TemporaryFolder folder;
  const auto write = [&](const char* name, std::string_view bytes) {
    std::ofstream(folder.path / name, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    return folder.path / name;
  };
  EXPECT_THAT(error_of_reading(write("empty.toml", "")), HasSubstr("the file is empty"));
  EXPECT_THAT(error_of_reading(write("binary.toml", std::string_view("PK\x03\x04\0\0", 6))), HasSubstr("a binary file"));
  EXPECT_THAT(error_of_reading(write("latin.toml", "a = 1\nb = \"\xE4\"\n")),
              HasSubstr("latin.toml:2:6: not UTF-8 text (byte 0xE4)"));
  EXPECT_THAT(error_of_reading(folder.path / "emty.toml"), HasSubstr("no such file; did you mean \"empty.toml\"?"));
  EXPECT_THAT(error_of_reading(folder.path), HasSubstr("this is a folder"));
  EXPECT_THAT(error_of_reading(folder.path / "no" / "a.toml"), HasSubstr("its folder does not exist"));
  EXPECT_EQ(read_text_file(write("bom.toml", "\xEF\xBB\xBFx = 1\n")), "x = 1\n");
}

}  // namespace
}  // namespace puadem
