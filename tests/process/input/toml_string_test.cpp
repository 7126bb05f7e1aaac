#include "process/input/toml_string.h"

#include <gtest/gtest.h>
#include <toml++/toml.h>

namespace diefill::process {
namespace {

TEST(TomlString, IsReadAsTheTextThatItWasMadeOf) {
  for (const std::string text :
       {"", "plain", "a \"quoted\" word", "back\\slash\\", "tab\tand\nline", "\x7f", "µ_r"}) {
    const std::string written = toml_string(text);
    EXPECT_EQ(toml::parse("key = " + written)["key"].value_or(std::string("none")), text) << written;
    EXPECT_EQ(toml::parse(written + " = 1")[text].value_or(0), 1) << written;
  }
}

}  // namespace
}  // namespace diefill::process
