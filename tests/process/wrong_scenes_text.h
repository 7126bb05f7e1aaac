// Faults at the top level of a scene, and texts that are no TOML at all.
#pragma once

#include <string>
#include <vector>

#include "tests/process/wrong_scene.h"

namespace diefill::process {

inline std::vector<WrongScene> wrong_documents() {
  const std::string title = "title = \"Narrow ring, one passage\"", seed = "seed = 1";
  const std::string powder = "[powder]\npreset = \"Distaloy AE\"\ngrain_diameter = \"1.88 mm\"\n";
  return {
      spoil("title_a_number", title, "title = @5", {"title", "found 5", "expected a text in quotes"}),
      spoil("seed_negative", seed, "seed = @-1", {"seed", "found -1", "a whole number from 0"}),
      spoil("seed_in_quotes", seed, "seed = @\"1\"", {"seed", "found \"1\"", "a whole number from 0"}),
      spoil("gravity_as_number", seed, "gravity = @9.81",
            {"gravity", "found 9.81", "expected an acceleration with its unit", "\"9.81 m/s^2\""}),
      spoil("table_misspelt", "[measure]", "[@mesure]",
            {"mesure", "found a table", "did you mean \"measure\"?"}),
      spoil("table_unknown", "[measure]", "[@colours]",
            {"colours", "found a table", "the allowed keys are title, seed"}),
      spoil("powder_missing", title + "\n" + seed + "\n\n" + powder, "@" + title + "\n" + seed + "\n",
            {"powder", "found nothing, a value is required", "[powder]"}),
  };
}

inline std::vector<WrongScene> wrong_syntax() {
  const std::string velocity = "velocity = \"0.2 m/s\"", seed = "seed = 1";
  return {
      spoil("quantity_without_quotes", velocity, "velocity = 0.2 @m/s",
            {"found `velocity = 0.2 m/s`", "not valid TOML", "in quotes, such as velocity = \"0.2 m/s\""}),
      spoil("text_without_quotes", "role = \"die\"", "role = @die",
            {"found `role = die`", "put text in quotes, such as role = \"die\""}),
      spoil("decimal_comma", "spacing = 1.6", "spacing = 1@,6",
            {"found `spacing = 1,6`", "write a decimal point"}),
      spoil("decimal_without_zero", "spacing = 1.6", "spacing = @.6",
            {"found `spacing = .6`", "write a digit before the decimal point, such as 0.6"}),
      spoil("key_given_twice", seed, "seed = 1\nseed = @2",
            {"found `seed = 2`", "cannot redefine", "'seed'", "already defined above, keep one of the two"}),
      spoil("quote_not_closed", velocity, "velocity = \"0.2 m/s@",
            {"found `velocity = \"0.2 m/s`", "not valid TOML", "close the quote"}),
      spoil("long_text_not_closed", velocity, "velocity = @\"\"\"0.2 m/s",
            {"found \"\"\", which begin a text that is never closed", "write \"\"\" where it ends"}),
      spoil("long_literal_text_not_closed", velocity, "velocity = @'''0.2 m/s",
            {"found '''", "never closed"}),
      spoil("comma_missing_in_a_list", "from = [\"19.4 mm\", ", "from = [\"19.4 mm\" @",
            {"not valid TOML", "write a comma between values"}),
      spoil("bracket_not_closed", "[pour]", "[pour@",
            {"found `[pour`", "not valid TOML", "close the bracket, such as [pour]"}),
      spoil("table_given_twice", "[measure]", "@[numerics]",
            {"found `[numerics]`", "cannot redefine", "keep one of the two"}),
      spoil("backslash_in_a_path", "file = \"die.stl\"", "file = \"C:\\@die.stl\"",
            {"unknown escape sequence", "use / instead of \\"}),
      spoil("prose", seed, "please @fill the die",
            {"found `please fill the die`", "each line is key = value, [table] or # comment"}),
      spoil("byte_that_is_not_utf8", seed, "seed = 1 # @\xE9", {"not UTF-8", "save the scene as UTF-8 text"}),
  };
}

inline std::vector<WrongScene> wrong_settings() {
  const std::string before = scene_up_to("seed = 1");
  const std::string to_diameter = scene_up_to("\"1.88 mm\"").substr(before.size());
  const std::string with_setting = "seed = 1\nsetting = \"working\"" + to_diameter.substr(8);
  return {
      spoil("setting_unknown", "seed = 1", "seed = 1\nsetting = @\"workin\"",
            {"setting: found \"workin\"", "did you mean \"working\"?"}),
      spoil("setting_and_grain_diameter", to_diameter, with_setting + "@",
            {"powder.grain_diameter: found \"1.88 mm\"", "the setting \"working\" sets it",
             "scene.toml:3:11: setting", "remove one of the two"}),
  };
}

}  // namespace diefill::process
