// Faults in [contact].
#pragma once

#include <string>
#include <vector>

#include "tests/process/wrong_scene.h"

namespace diefill::process {

/// A fault in the tables of [contact], which stand before the tools.
inline WrongScene spoil_contact(const std::string& name, const std::string& tables,
                                const std::vector<std::string>& expected) {
  const std::string tool = "[[tool]]\nname = \"die\"";
  return spoil(name, tool, tables + "\n" + tool, expected);
}

inline std::vector<WrongScene> wrong_contacts() {
  const std::string hertz = "[contact]\nnormal = { law = \"Hertz-Mindlin\", modulus = \"5 MPa\" }\n",
                    luding =
                        "[contact]\nnormal = { law = \"Luding\", loading_stiffness = \"100 N/m\", "
                        "unloading_stiffness = \"300 N/m\" }\n",
                    jkr =
                        "[contact]\nnormal = { law = \"JKR\", modulus = \"5 MPa\", surface_energy = \"0.01 "
                        "J/m^2\" }\n";
  return {
      spoil_contact("contact_no_normal", "@[contact]\ndamping = { law = \"none\" }",
                    {"contact.normal", "found nothing, a value is required", "[contact.normal]"}),
      spoil_contact("contact_no_law", "[contact]\nnormal = @{ modulus = \"5 MPa\" }",
                    {"contact.normal.law", "a value is required", "\"Bierwisch\""}),
      spoil_contact("contact_law_misspelt", "[contact]\nnormal = { law = @\"Herz-Mindlin\" }",
                    {"contact.normal.law", "found \"Herz-Mindlin\"", "did you mean \"Hertz-Mindlin\"?"}),
      spoil_contact("contact_law_of_another_kind", hertz + "rolling = { law = @\"Mindlin\" }",
                    {"contact.rolling.law", "found \"Mindlin\"", "\"EPSD2\""}),
      spoil_contact("contact_kind_misspelt", hertz + "@roling = { law = \"none\" }",
                    {"contact.roling", "unknown key", "did you mean \"rolling\"?"}),
      spoil_contact(
          "contact_key_misspelt",
          "[contact]\nnormal = { law = \"Hertz-Mindlin\", modulus = \"5 MPa\", @modulu = \"5 MPa\" }",
          {"contact.normal.modulu", "unknown key", "did you mean \"modulus\"?"}),
      spoil_contact(
          "contact_key_of_another_law",
          "[contact]\nnormal = { law = \"Hertz-Mindlin\", modulus = \"5 MPa\", @surface_energy = \"1 "
          "J/m^2\" }",
          {"contact.normal.surface_energy", "unknown key", "law, modulus"}),
      spoil_contact("contact_modulus_missing", "[contact]\nnormal = @{ law = \"Hertz-Mindlin\" }",
                    {"contact.normal.modulus", "a value is required, such as \"5 MPa\""}),
      spoil_contact("contact_modulus_without_unit", "[contact]\nnormal = { law = \"JKR\", modulus = @5e6 }",
                    {"contact.normal.modulus", "expected a pressure with its unit"}),
      spoil_contact("contact_modulus_in_newton_per_metre",
                    "[contact]\nnormal = { law = \"JKR\", modulus = @\"5 N/m\" }",
                    {"contact.normal.modulus", "\"N/m\" is not a unit of pressure"}),
      spoil_contact("contact_restitution_above_one",
                    hertz + "damping = { law = \"restitution\", restitution = @1.5 }",
                    {"contact.damping.restitution", "found 1.5", "at least 0 and at most 1"}),
      spoil_contact("contact_unloading_too_soft",
                    "[contact]\nnormal = { law = @\"Luding\", loading_stiffness = \"300 N/m\", "
                    "unloading_stiffness = \"100 N/m\" }",
                    {"contact.normal.law", "k_2 must exceed the loading stiffness k_1"}),
      spoil_contact("contact_dynamic_friction_above_static",
                    luding + "friction = { law = @\"Luding\", static_friction = 0.2, dynamic_friction = 0.5, "
                             "stiffness = \"60 N/m\" }",
                    {"contact.friction.law", "dynamic friction coefficient is 0.5", "at most 0.2"}),
      spoil_contact("contact_restitution_of_hertz_with_luding",
                    luding + "damping = { law = @\"restitution\", restitution = 0.5 }",
                    {"contact.damping.law", "needs a Hertzian spring", "\"linear restitution\""}),
      spoil_contact("contact_linear_restitution_with_hertz",
                    hertz + "damping = { law = @\"linear restitution\", restitution = 0.5 }",
                    {"contact.damping.law", "needs a linear spring", "\"restitution\""}),
      spoil_contact("contact_adhesion_twice",
                    jkr + "attraction = { law = @\"van der Waals\", hamaker_constant = \"6.5e-20 J\" }",
                    {"contact.attraction.law", "repeats the adhesion of the normal force"}),
      spoil_contact("contact_epsd2_without_shear_modulus",
                    hertz + "rolling = @{ law = \"EPSD2\", rolling_friction = 0.2 }",
                    {"contact.rolling.shear_modulus", "a value is required, such as \"2 MPa\""}),
      spoil_contact("contact_gaps_the_wrong_way_round",
                    hertz + "attraction = { law = @\"van der Waals\", hamaker_constant = \"6.5e-20 J\", "
                            "smallest_gap = \"2 um\" }",
                    {"contact.attraction.law", "largest gap D_max is 1e-06"}),
      spoil_contact("contact_of_walls_misspelt", hertz + "[contact.walls]\n@frction = { law = \"none\" }",
                    {"contact.walls.frction", "did you mean \"friction\"?"}),
      spoil("contact_beside_a_powder_key", "grain_diameter = \"1.88 mm\"",
            "grain_diameter = \"1.88 mm\"\nfriction = @0.5\n" + hertz,
            {"powder.friction", "found 0.5", "[contact] in line 8 sets the laws", "remove it"}),
      spoil("contact_beside_walls_friction", "spacing = 1.6", "spacing = 1.6\nfriction = @0.2\n" + hertz,
            {"walls.friction", "none of them uses this key"}),
      spoil("contact_beside_the_spring_of_numerics", "max_time = \"5 s\"",
            "max_time = \"5 s\"\ntangential_spring = @\"free\"\n" + hertz,
            {"numerics.tangential_spring", "set `cut_back` in its friction"}),
      spoil("contact_rolling_of_model_a", "grain_diameter = \"1.88 mm\"",
            "grain_diameter = \"1.88 mm\"\nmodel = \"A\"\n" + hertz +
                "rolling = { law = @\"CDT\", rolling_friction = 0.1 }",
            {"contact.rolling.law", "grains of model A do not rotate"}),
      spoil_contact("contact_scaling_misspelt", hertz + "coarse_graining = @\"Chou\"",
                    {"contact.coarse_graining", "did you mean \"Chu\"?"}),
      spoil_contact("contact_stiffness_as_a_length",
                    "[contact]\nnormal = { law = \"linear\", stiffness = @\"5 mm\" }",
                    {"contact.normal.stiffness", "\"mm\" is not a unit of", "force per length", "100 N/m"}),
  };
}

}  // namespace diefill::process
