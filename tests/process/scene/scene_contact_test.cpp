// [contact] as the reader understands it.
#include <gtest/gtest.h>

#include "engine/laws/bierwisch_law.h"
#include "process/powder/law_terms.h"
#include "process/powder/material.h"
#include "process/scene/contact/contact_parts.h"
#include "process/scene/contact/contact_spec.h"
#include "process/scene/variants.h"
#include "tests/process/scene_files.h"
#include "tests/process/wrong_scene.h"

namespace diefill::process {
namespace {

using namespace engine::laws;
using support::exchanged;

/// Read where its CAD files are.
Scene scene_of_text(const std::string& text) {
  const SceneFolder folder;
  return read_scene(folder.write(text));
}

/// The faultless scene with [contact] before its tools.
Scene with_contact(const std::string& tables, const std::string& powder = "") {
  const std::string tool = "[[tool]]\nname = \"die\"", size = "grain_diameter = \"1.88 mm\"";
  const std::string text = exchanged(faultless_scene(), tool, tables + "\n" + tool);
  return scene_of_text(exchanged(text, size, size + "\n" + powder));
}

constexpr const char* kHertz = "[contact]\nnormal = { law = \"Hertz-Mindlin\", modulus = \"5 MPa\" }\n";

TEST(SceneContact, IsNothingUnlessNamed) {
  const Scene scene = scene_of_text(faultless_scene());
  EXPECT_FALSE(scene.contact);
  const auto settings = engine_settings(scene, 1.0);
  EXPECT_TRUE(
      engine::laws::as_bierwisch(settings.contact.between(engine::kPowderMaterial, engine::kPowderMaterial)));
}

TEST(SceneContact, FollowsTheVariant) {
  const SceneFolder folder;
  const std::string tool = "[[tool]]\nname = \"die\"";
  const auto variants = read_variants(folder.write(
      exchanged(faultless_scene(), tool,
                std::string(kHertz) + "friction = { law = \"Bierwisch\", friction = 0.3 }\n\n" + tool) +
      "\n[[variant]]\nname = \"rough\"\ncontact.friction.friction = 0.6\n"));
  ASSERT_EQ(variants.size(), 1U);
  EXPECT_EQ(variants[0].scene.contact->grains.law.friction.largest_friction(), 0.6);
}

TEST(SceneContact, ReadsEveryPartInSiUnits) {
  const Scene scene = with_contact(R"([contact]
normal = { law = "JKR", modulus = "5 MPa", surface_energy = "10 mJ/m^2", load = "printed" }
damping = { law = "restitution", restitution = 0.4 }
friction = { law = "Mindlin", friction = 0.5, shear_modulus = "2 MPa", slip_test = "spring alone" }
rolling = { law = "EPSD2", rolling_friction = 0.2 }
attraction = { law = "capillary", surface_tension = "72 mN/m", contact_angle = "30 deg" }
)");
  const LawParameters law = scene.contact->grains.law;
  EXPECT_EQ(law.normal.of<JkrNormal>()->modulus, 5e6);
  EXPECT_NEAR(law.normal.of<JkrNormal>()->surface_energy, 0.01, 1e-15);
  EXPECT_EQ(law.normal.of<JkrNormal>()->load, JkrLoad::printed);
  EXPECT_EQ(law.damping.of<RestitutionDamping>()->restitution, 0.4);
  EXPECT_EQ(law.friction.of<MindlinFriction>()->slip_test, SlipTest::spring_alone);
  EXPECT_NEAR(law.attraction.of<CapillaryBridge>()->surface_tension, 0.072, 1e-15);
  EXPECT_NEAR(law.attraction.of<CapillaryBridge>()->contact_angle, 0.5235988, 1e-7);
  EXPECT_EQ(law.load_rule, LoadRule::without);
}

TEST(SceneContact, GivesOnceWhatPartsShare) {
  const Scene hertz =
      with_contact(std::string(kHertz) + R"(damping = { law = "restitution", restitution = 0.4 }
friction = { law = "Mindlin", friction = 0.5, shear_modulus = "2 MPa" }
rolling = { law = "EPSD2", rolling_friction = 0.2 }
)");
  const LawParameters law = hertz.contact->grains.law;
  EXPECT_EQ(law.damping.of<RestitutionDamping>()->modulus, 5e6);
  EXPECT_EQ(law.friction.of<MindlinFriction>()->restitution, 0.4);
  EXPECT_EQ(law.rolling.of<Epsd2Rolling>()->shear_modulus, 2e6);
  EXPECT_EQ(law.load_rule, LoadRule::with_damping);

  const Scene luding = with_contact(R"([contact]
normal = { law = "Luding", loading_stiffness = "150 N/m", unloading_stiffness = "750 N/m" }
damping = { law = "linear restitution", restitution = 0.4 }
friction = { law = "Luding", static_friction = 0.5, dynamic_friction = 0.4, stiffness = "60 N/m" }
rolling = { law = "Luding", rolling_friction = 0.2 }
)");
  const LawParameters rolls = luding.contact->grains.law;
  EXPECT_EQ(rolls.damping.of<LinearRestitutionDamping>()->stiffness, 150);
  EXPECT_EQ(rolls.rolling.of<LudingRolling>()->tangential_stiffness, 60);
}

/// Luding's spring with `keys`.
std::string luding(const std::string& keys) {
  return "[contact]\nnormal = { law = \"Luding\", " + keys + " }\n";
}

TEST(SceneContact, LudingsStiffnessesFollowFromAModulusAndRatios) {
  const Scene scene = with_contact(luding(
      "young_modulus = \"17 MPa\", reference_overlap = 0.04, unloading_ratio = 5.33, cohesion_ratio = 0.5"));
  const auto* given = scene.contact->grains.law.normal.of<LudingNormal>();
  ASSERT_NE(given, nullptr);
  const double k = 4.0 / 3 * 17e6 * scene.powder.sphere_radius * 0.2;
  EXPECT_NEAR(given->loading / k, 1, 1e-12);
  EXPECT_NEAR(given->unloading / k, 5.33, 1e-12);
  EXPECT_NEAR(given->cohesion / k, 0.5, 1e-12);
  const std::string modulus = "young_modulus = \"17 MPa\", ";
  for (const auto& [keys, word] : std::vector<std::pair<std::string, std::string>>{
           {modulus + "loading_stiffness = \"100 N/m\", unloading_ratio = 5",
            "loading_stiffness is given as well"},
           {modulus + "unloading_stiffness = \"1e6 N/m\", unloading_ratio = 5",
            "unloading_stiffness is given as well"},
           {"loading_stiffness = \"100 N/m\", reference_overlap = 0.01, unloading_ratio = 5", "unknown key"},
           {modulus + "unloading_ratio = 1", "unloading_ratio"}})
    try {
      with_contact(luding(keys));
      ADD_FAILURE() << "not refused: " << keys;
    } catch (const SceneError& error) {
      EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << error.what();
    }
}

/// The Edinburgh law with `keys` beside its ratio and its surface energy.
std::string edinburgh(const std::string& keys) {
  return "[contact]\nnormal = { law = \"Edinburgh\", plasticity_ratio = 0.6, surface_energy = \"2 J/m^2\", " +
         keys + " }\n";
}

TEST(SceneContact, ReadsBothBranchesOfTheEdinburghLaw) {
  const LawParameters curved =
      with_contact(edinburgh("modulus = \"5 MPa\", pull_off_force = \"1 uN\"")).contact->grains.law;
  const auto* given = curved.normal.of<EdinburghNormal>();
  ASSERT_NE(given, nullptr);
  EXPECT_TRUE(given->is_hertzian());
  EXPECT_EQ(given->modulus, 5e6);
  EXPECT_EQ(given->plasticity_ratio, 0.6);
  EXPECT_EQ(given->surface_energy, 2);
  EXPECT_NEAR(given->pull_off, 1e-6, 1e-18);
  const LawParameters straight =
      with_contact(edinburgh("branch = \"linear\", loading_stiffness = \"80 N/m\"") +
                   "damping = { law = \"linear restitution\", restitution = 0.5 }\n")
          .contact->grains.law;
  EXPECT_TRUE(straight.normal.of<EdinburghNormal>()->is_linear());
  EXPECT_EQ(straight.normal.of<EdinburghNormal>()->stiffness, 80);
  EXPECT_EQ(straight.damping.of<LinearRestitutionDamping>()->stiffness, 80);
}

TEST(SceneContact, RefusesTheKeyOfTheOtherEdinburghBranch) {
  for (const auto& [keys, word] : std::vector<std::pair<std::string, std::string>>{
           {"branch = \"linear\", loading_stiffness = \"80 N/m\", modulus = \"5 MPa\"", "loading_stiffness"},
           {"modulus = \"5 MPa\", loading_stiffness = \"80 N/m\"", "`modulus` in Pa"},
           {"branch = \"linear\"", "loading_stiffness"},
           {"branch = \"round\", modulus = \"5 MPa\"", "Hertzian"}})
    try {
      with_contact(edinburgh(keys));
      ADD_FAILURE() << "not refused: " << keys;
    } catch (const SceneError& error) {
      EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << error.what();
    }
}

TEST(SceneContact, LeavesToThePowderWhatBierwischsPartsDoNotSay) {
  const Scene scene = with_contact(R"([contact]
normal = { law = "Bierwisch" }
damping = { law = "Bierwisch" }
friction = { law = "Bierwisch" }
[contact.walls]
damping = { law = "none" }
)",
                                   "friction = 0.7\nreduced_modulus = \"8 MPa\"\n");
  const ContactSpec contact = *scene.contact;
  const auto &grains = contact.grains.law, &walls = contact.walls.law;
  const double radius = scene.powder.sphere_radius;
  EXPECT_EQ(grains.normal.of<BierwischNormal>()->reduced_modulus, 8e6);
  EXPECT_EQ(grains.normal.of<BierwischNormal>()->work_of_adhesion, 0.005);
  EXPECT_NEAR(grains.damping.of<BierwischDamping>()->damping, 1e6 * radius, 1e-9);
  EXPECT_NEAR(grains.friction.of<CundallFriction>()->tangential, 1e6 * radius, 1e-9);
  EXPECT_EQ(grains.friction.of<CundallFriction>()->friction, 0.7);
  EXPECT_EQ(walls.friction.of<CundallFriction>()->friction, 0.15);  // the default of [walls]
  EXPECT_EQ(walls.normal.of<BierwischNormal>()->work_of_adhesion, 0);
  EXPECT_NE(walls.damping.of<NoDamping>(), nullptr);
}

// The same numbers in the powder and in [contact]: the same coarse law and the same time step.
TEST(SceneContact, BierwischsPartsAreCoarsenedAsThePowderIs) {
  const Scene named = with_contact(R"([contact]
normal = { law = "Bierwisch" }
damping = { law = "Bierwisch" }
friction = { law = "Bierwisch" }
)");
  const Scene plain = scene_of_text(faultless_scene());
  const auto own = engine_settings(plain, 1.0), general = engine_settings(named, 1.0);
  const auto law_of = [](const engine::SimulationSettings& settings) {
    return engine::laws::as_bierwisch(
               settings.contact.between(engine::kPowderMaterial, engine::kPowderMaterial))
        .value()
        .parameters;
  };
  EXPECT_NEAR(law_of(general).work_of_adhesion, law_of(own).work_of_adhesion, 1e-12);
  EXPECT_NEAR(law_of(general).damping, law_of(own).damping, 1e-9);
  EXPECT_NEAR(law_of(general).tangential, law_of(own).tangential, 1e-9);
  EXPECT_EQ(own.shape().mass, general.shape().mass);
  EXPECT_NEAR(general.time_step, own.time_step, 1e-9 * own.time_step);
}

TEST(SceneContact, ScalesForcesByTheRuleOfItsName) {
  const Scene scene = with_contact(std::string(kHertz) + "coarse_graining = \"Chu\"\n");
  const auto settings = engine_settings(scene, 1.0);
  EXPECT_NEAR(settings.contact.scaling.scale, 4, 1e-12);
  EXPECT_EQ(settings.contact.scaling.torque_exponent, 3);
  const Scene plain = with_contact(std::string(kHertz) + "coarse_graining = \"none\"\n");
  EXPECT_EQ(engine_settings(plain, 1.0).contact.scaling.scale, 1);
}

TEST(SceneContact, TellsWhichLawsAreInUse) {
  const Scene scene =
      with_contact(std::string(kHertz) +
                   "friction = { law = \"Mindlin\", friction = 0.5, shear_modulus = \"2 MPa\" }\n"
                   "[contact.walls]\nfriction = { law = \"none\" }\n");
  const LawTerms terms = law_terms(scene, engine_settings(scene, 1.0));
  const std::string used = joined(terms.used), left_out = joined(terms.left_out);
  EXPECT_NE(used.find("normal Hertz-Mindlin (modulus 5e+06 Pa)"), std::string::npos) << used;
  EXPECT_NE(used.find("friction among grains Mindlin (friction 0.5"), std::string::npos) << used;
  EXPECT_NE(left_out.find("friction with tools"), std::string::npos) << left_out;
  EXPECT_NE(left_out.find("attraction"), std::string::npos) << left_out;
}

}  // namespace
}  // namespace diefill::process
