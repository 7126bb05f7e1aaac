// Faults in [powder].
#pragma once

#include <string>
#include <vector>

#include "tests/process/wrong_scene.h"

namespace diefill::process {

inline std::vector<WrongScene> wrong_powders() {
  const std::string preset = "preset = \"Distaloy AE\"", size = "grain_diameter = \"1.88 mm\"",
                    both = preset + '\n' + size;
  return {
      spoil("size_without_unit", size, "grain_diameter = @\"1.88\"",
            {"powder.grain_diameter", "found \"1.88\"", "expected a length with its unit",
             "such as \"0.94 mm\""}),
      spoil("size_as_number", size, "grain_diameter = @1.88",
            {"powder.grain_diameter", "found 1.88,", "a length with its unit", "\"0.94 mm\""}),
      spoil("size_in_kilograms", size, "grain_diameter = @\"3 kg\"",
            {"powder.grain_diameter", "found \"3 kg\"", "\"kg\" is not a unit of length", "\"0.94 mm\""}),
      spoil("size_unknown_unit", size, "grain_diameter = @\"1.88 milimeter\"",
            {"powder.grain_diameter", "found \"1.88 milimeter\"", "the unit \"milimeter\" is not known"}),
      spoil("size_decimal_comma", size, "grain_diameter = @\"1,88 mm\"",
            {"powder.grain_diameter", "found \"1,88 mm\"", "write a decimal point, not a comma"}),
      spoil("size_no_number", size, "grain_diameter = @\"coarse\"",
            {"powder.grain_diameter", "found \"coarse\"", "does not begin with a number", "\"0.94 mm\""}),
      spoil("size_empty", size, "grain_diameter = @\"\"",
            {"powder.grain_diameter", "found \"\"", "expected a length with its unit"}),
      spoil("size_zero", size, "grain_diameter = @\"0 mm\"",
            {"powder.grain_diameter", "found \"0 mm\"", "allowed: more than 0 mm"}),
      spoil("size_negative", size, "grain_diameter = @\"-1.88 mm\"",
            {"powder.grain_diameter", "found \"-1.88 mm\"", "more than 0 mm"}),
      spoil("size_not_a_number", size, "grain_diameter = @\"nan mm\"",
            {"powder.grain_diameter", "found \"nan mm\"", "not finite"}),
      spoil("size_infinite", size, "grain_diameter = @\"inf mm\"",
            {"powder.grain_diameter", "found \"inf mm\"", "not finite"}),
      spoil("size_beyond_range_of_numbers", size, "grain_diameter = @\"1e999 mm\"",
            {"powder.grain_diameter", "1e999", "not finite"}),
      spoil("size_too_coarse", size, "grain_diameter = @\"50 mm\"",
            {"powder.grain_diameter", "found \"50 mm\"", "allowed: 0.04704 mm to 9.408 mm",
             "coarse graining is not valid"}),
      spoil("size_too_fine", size, "grain_diameter = @\"0.01 mm\"",
            {"powder.grain_diameter", "found \"0.01 mm\"", "allowed: 0.04704 mm to 9.408 mm"}),
      spoil("size_a_list", size, "grain_diameter = @[1, 2]",
            {"powder.grain_diameter", "found [1, 2]", "expected a length with its unit"}),
      spoil("preset_unknown", preset, "preset = @\"ASC100.29 D3\"",
            {"powder.preset", "found \"ASC100.29 D3\"", "\"ASC100.29 initial A\"", "\"Distaloy AE\"",
             "did you mean \"ASC100.29 D2\"?"}),
      spoil("preset_not_a_text", preset, "preset = @7",
            {"powder.preset", "found 7", "expected a text in quotes"}),
      spoil("preset_missing", "[powder]\n" + both, "@[powder]\n" + size,
            {"powder.preset", "found nothing, a value is required", "\"Distaloy AE\"",
             "model, sphere_radius and grain_mass"}),
      spoil("custom_without_mass", "[powder]\n" + both,
            "@[powder]\nmodel = \"A\"\nsphere_radius = \"0.15 mm\"",
            {"powder.grain_mass", "found nothing", "\"0.0763 mg\""}),
      spoil("clump_in_pieces", both,
            "grain_mass = \"1e-7 kg\"\nspheres = @[{ centre = [\"0 mm\", \"0 mm\", \"0 mm\"], radius = \"0.1 "
            "mm\" }, { centre = [\"1 mm\", \"0 mm\", \"0 mm\"], radius = \"0.1 mm\" }, { centre = [\"0.19 "
            "mm\", \"0 mm\", \"0 mm\"], radius = \"0.1 mm\" }]",
            {"powder.spheres", "sphere 2 is 0.61 mm away from sphere 3, the nearest of the others",
             "let every sphere touch or overlap another one"}),
      spoil("custom_mass_in_wrong_unit", both,
            "model = \"A\"\nsphere_radius = \"0.15 mm\"\ngrain_mass = @\"76.3 mg\"",
            {"powder.grain_mass", "found \"76.3 mg\"", "5397.12 g/cm^3", "allowed: 0.1 to 25 g/cm^3",
             "check both units"}),
      spoil("model_unknown", preset, preset + "\nmodel = @\"E\"",
            {"powder.model", "found \"E\"", "allowed: \"A\", \"B\", \"C\" or \"D\""}),
      spoil("friction_negative", preset, preset + "\nfriction = @-0.1",
            {"powder.friction", "found -0.1", "allowed: at least 0 and at most 10"}),
      spoil("friction_too_large", preset, preset + "\nfriction = @11",
            {"powder.friction", "found 11", "allowed: at least 0 and at most 10"}),
      spoil("friction_not_a_number", preset, preset + "\nfriction = @nan",
            {"powder.friction", "found nan", "allowed: at least 0 and at most 10"}),
      spoil("friction_in_quotes", preset, preset + "\nfriction = @\"0.5\"",
            {"powder.friction", "found \"0.5\"", "expected a number without quotes", "such as 0.5"}),
      spoil("adhesion_negative", preset, preset + "\nwork_of_adhesion = @\"-0.01 J/m^2\"",
            {"powder.work_of_adhesion", "found \"-0.01 J/m^2\"", "at least 0 J/m^2"}),
      spoil(
          "adhesion_as_energy", preset, preset + "\nwork_of_adhesion = @\"0.01 J\"",
          {"powder.work_of_adhesion", "\"J\" is not a unit of work of adhesion per area", "\"0.005 J/m^2\""}),
      spoil("rolling_without_rotation", preset, preset + "\nrolling_friction = @\"0.01 mm\"",
            {"powder.rolling_friction", "found \"0.01 mm\"", "only model \"B\"", "choose model B"}),
      spoil("modulus_too_soft", preset, preset + "\nreduced_modulus = @\"10 Pa\"",
            {"powder.reduced_modulus", "found \"10 Pa\"", "at least 1e4 Pa"}),
      spoil(
          "damping_of_another_dimension", preset, preset + "\ndamping_over_radius = @\"1e6 Pa s\"",
          {"powder.damping_over_radius", "\"Pa s\" is not a unit of damping over radius", "\"1e6 Pa s/m\""}),
      spoil("coarse_graining_unknown", preset, preset + "\ncoarse_graining = @\"sakai\"",
            {"powder.coarse_graining", "found \"sakai\"", "allowed: \"bierwisch\""}),
      spoil("key_misspelt", size, "@grain_diamter = \"1.88 mm\"",
            {"powder.grain_diamter", "found \"1.88 mm\"", "unknown key", "did you mean \"grain_diameter\"?"}),
      spoil("key_unlike_any_other", size, "@colour = \"grey\"",
            {"powder.colour", "found \"grey\"", "the allowed keys are", "preset", "grain_diameter"}),
      spoil("powder_of_two_brackets", "[powder]\n" + both, "@[[powder]]\n" + both,
            {"powder", "found a list of 1 entry", "expected one table", "[powder]"}),
  };
}

}  // namespace diefill::process
