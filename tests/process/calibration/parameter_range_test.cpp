// Ranges of parameters.
#include "process/calibration/parameter_range.h"

#include <gtest/gtest.h>
#include <toml++/toml.h>

#include "process/input/scene_error.h"

namespace diefill::process::calibration {
namespace {

std::vector<ParameterRange> read(const std::string& text) {
  const toml::table parsed = toml::parse(text);
  TableReader document(parsed, "calibration.toml", "");
  return read_parameters(document);
}

std::string message_of(const std::string& text) {
  try {
    read(text);
  } catch (const SceneError& error) {
    return error.what();
  }
  return "no message";
}

const std::string kFriction = "[[parameter]]\nkey = \"powder.friction\"\nfrom = 0.2\nto = 1.0\n";

TEST(ParameterRange, LinearAndLogarithmicRangesRunFromEndToEnd) {
  const auto all = read(kFriction +
                        "[[parameter]]\nkey = \"powder.work_of_adhesion\"\nfrom = \"0.001 J/m^2\"\n"
                        "to = \"100 mJ/m^2\"\nscale = \"logarithmic\"\n");
  ASSERT_EQ(all.size(), 2U);
  EXPECT_DOUBLE_EQ(all[0].value_at(0.25), 0.4);
  EXPECT_DOUBLE_EQ(all[0].place_of(0.4), 0.25);
  EXPECT_EQ(all[0].assignment(0.25), "powder.friction = 0.4\n");
  EXPECT_NEAR(all[1].value_at(0.5), 0.01, 1e-15);
  EXPECT_NEAR(all[1].place_of(0.01), 0.5, 1e-12);
  EXPECT_EQ(all[1].assignment(0.5), "powder.work_of_adhesion = \"0.01 J/m^2\"\n");
}

TEST(ParameterRange, FaultsAreNamedWithTheirPlace) {
  EXPECT_NE(message_of("").find("a [[parameter]] with key, from and to"), std::string::npos);
  EXPECT_NE(message_of("parameter = []\n").find("expected at least one [[parameter]]"), std::string::npos);
  EXPECT_NE(message_of("[[paramter]]\nkey = \"powder.friction\"\n").find("did you mean \"parameter\"?"),
            std::string::npos);
  EXPECT_NE(message_of(kFriction + kFriction).find("give each key once"), std::string::npos);
  EXPECT_NE(message_of(kFriction + "[[parameter]]\nkey = 'powder.\"friction\"'\nfrom = 0.2\nto = 1.0\n")
                .find("give each key once"),
            std::string::npos);
  EXPECT_NE(
      message_of("[[parameter]]\nkey = \"step.1.velocity\"\nfrom = 1\nto = 2\n").find("a key of [powder]"),
      std::string::npos);
  EXPECT_NE(
      message_of("[[parameter]]\nkey = \"powder.friction\"\nfrom = 1\nto = 1\n").find("more than \"from\""),
      std::string::npos);
  EXPECT_NE(
      message_of("[[parameter]]\nkey = \"powder.friction\"\nfrom = 0\nto = 1\nscale = \"logarithmic\"\n")
          .find("begins above 0"),
      std::string::npos);
  EXPECT_NE(message_of("[[parameter]]\nkey = \"powder.grain_mass\"\nfrom = \"1 mg\"\nto = \"2 mm\"\n")
                .find("does not have the dimension of"),
            std::string::npos);
  EXPECT_NE(message_of("[[parameter]]\nkey = \"powder.friction\"\nfrom = 0\nto = 1\nscale = \"logaritmic\"\n")
                .find("calibration.toml:5"),
            std::string::npos);
  EXPECT_NE(message_of("[[parameter]]\nkey = \"powder.friction\"\nfrom = 0\n").find("to"), std::string::npos);
}

TEST(ParameterRange, AKeyThatBringsAValueOrACommentAlongIsRefused) {
  for (const char* key : {"powder.friction = 3 #", "powder.friction #", "powder.friction, x", "powder."}) {
    const std::string message =
        message_of(std::string("[[parameter]]\nkey = \"") + key + "\"\nfrom = 0.2\nto = 1.0\n");
    EXPECT_NE(message.find("calibration.toml:2"), std::string::npos) << message;
    EXPECT_NE(message.find(std::string("found \"") + key + '"'), std::string::npos) << message;
    EXPECT_NE(message.find("the path of a key alone"), std::string::npos) << message;
  }
}

}  // namespace
}  // namespace diefill::process::calibration
