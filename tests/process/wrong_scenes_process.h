// Faults in [pour], [[step]], [numerics] and [measure].
#pragma once

#include <string>
#include <vector>

#include "tests/process/wrong_scene.h"

namespace diefill::process {

inline std::vector<WrongScene> wrong_pours() {
  const std::string before_pour = scene_up_to("[pour]");
  const std::string from = "from = [\"19.4 mm\", \"-14.5 mm\", \"0 mm\"]",
                    to = "to = [\"51.4 mm\", \"14.5 mm\", \"110 mm\"]";
  const std::string height = "fill_height = \"24 mm\"";
  const std::string rest = scene_up_to("[measure]").substr(scene_up_to("from =").size());
  return {
      spoil("pour_from_missing", "[pour]\n" + from, "@[pour]",
            {"pour.from", "found nothing, a value is required"}),
      spoil("pour_box_empty", to, "to = @[\"51.4 mm\", \"-14.5 mm\", \"110 mm\"]",
            {"pour.to", "found [\"51.4 mm\", \"-14.5 mm\", \"110 mm\"]", "empty along y",
             "must be greater than from (-14.5 mm)"}),
      spoil("pour_box_thinner_than_a_grain", to, "to = @[\"51.4 mm\", \"-14 mm\", \"110 mm\"]",
            {"pour.to", "along y the box is 0.5 mm wide", "less than one grain of 1.8816 mm", "widen it"}),
      spoil("pour_height_above_box", height, "fill_height = @\"240 mm\"",
            {"pour.fill_height", "found \"240 mm\"", "only 110 mm high"}),
      spoil("pour_height_zero", height, "fill_height = @\"0 mm\"",
            {"pour.fill_height", "found \"0 mm\"", "more than 0 mm"}),
      spoil("pour_height_misspelt", "[pour]\n" + from + "\n" + to + "\n" + height,
            "@[pour]\n" + from + "\n" + to + "\nfil_height = \"24 mm\"",
            {"pour.fill_height", "found nothing", "found \"fil_height\": did you mean \"fill_height\"?"}),
      spoil("pour_lattice_too_tight", height, height + "\nlattice_constant = @1.1",
            {"pour.lattice_constant", "found 1.1", "allowed: at least 1.2", "no grains overlap"}),
      spoil("pour_solid_fraction_above_densest", height, height + "\nsolid_fraction = @0.9",
            {"pour.solid_fraction", "found 0.9", "at least 0.05 and at most 0.74"}),
      spoil("pour_rim_speed_negative", height, height + "\nrim_speed = @\"-1 m/s\"",
            {"pour.rim_speed", "found \"-1 m/s\"", "at least 0 m/s"}),
      spoil(
          "pour_outside_the_period", rest, "from = @" + rest.substr(7) + "\nperiodic = { y = \"20 mm\" }\n\n",
          {"pour.from", "along y the box reaches -14.5 mm", "numerics.periodic allows only -10 mm to 10 mm"}),
      spoil("pour_missing", scene_up_to("[[step]]"), "@" + before_pour,
            {"pour", "found nothing, a value is required", "[pour]"}),
  };
}

inline std::vector<WrongScene> wrong_steps() {
  const std::string kind = "kind = \"passage\"", tool = "tool = \"shoe\"",
                    velocity = "velocity = \"0.2 m/s\"", direction = "direction = \"-x\"";
  const std::string header = "[[step]]\n" + kind + "\n";
  return {
      spoil("step_kind_unknown", kind, "kind = @\"pasage\"",
            {"step.kind", "found \"pasage\"", "allowed: \"passage\", \"settle\", \"wait\"",
             "did you mean \"passage\"?"}),
      spoil("step_kind_missing", header, "@[[step]]\n", {"step.kind", "found nothing", "\"passage\""}),
      spoil("step_until_its_own_end", header, header + "name = \"a\"\nuntil = @{ after = \"a\" }\n",
            {"step.until", "found \"a\"", "which is this step itself", "remove until"}),
      spoil("step_until_a_step_behind_it", header + tool + "\n" + velocity + "\n" + direction + "\n",
            header + tool + "\n" + velocity + "\n" + direction +
                "\nuntil = @{ after = \"b\" }\n[[step]]\nkind = \"wait\"\nname = \"b\"\nduration = \"1 s\"\n",
            {"step.until", "found \"b\"", "waits for the end of this step", "remove until"}),
      spoil("step_tool_unknown", tool, "tool = @\"feeder\"",
            {"step.tool", "found \"feeder\"", "allowed: \"die\" or \"shoe\""}),
      spoil("step_tool_missing", header + tool, "@[[step]]\n" + kind,
            {"step.tool", "found nothing", "such as \"shoe\""}),
      spoil("step_moves_the_die", tool, "tool = @\"die\"",
            {"step.tool", "found \"die\"", "its role is die", "moves a shoe or plate"}),
      spoil("step_velocity_zero", velocity, "velocity = @\"0 m/s\"",
            {"step.velocity", "found \"0 m/s\"", "more than 0 m/s and at most 10 m/s"}),
      spoil("step_velocity_negative", velocity, "velocity = @\"-0.2 m/s\"",
            {"step.velocity", "found \"-0.2 m/s\"", "more than 0 m/s"}),
      spoil("step_velocity_too_fast", velocity, "velocity = @\"200 m/s\"",
            {"step.velocity", "found \"200 m/s\"", "at most 10 m/s"}),
      spoil("step_velocity_as_length", velocity, "velocity = @\"200 mm\"",
            {"step.velocity", "found \"200 mm\"", "\"mm\" is not a unit of velocity", "\"0.2 m/s\""}),
      spoil("step_velocity_as_slowness", velocity, "velocity = @\"5 s/m\"",
            {"step.velocity", "found \"5 s/m\"", "\"s/m\" is not a unit of velocity"}),
      spoil("step_velocity_missing", header + tool + "\n" + velocity, "@" + header + tool,
            {"step.velocity", "found nothing", "\"0.2 m/s\""}),
      spoil("step_direction_unknown", direction, "direction = @\"left\"",
            {"step.direction", "found \"left\"",
             "an axis (\"x\", \"y\", \"z\", \"-x\", ...) or three numbers"}),
      spoil("step_direction_downward", direction, "direction = @\"-z\"",
            {"step.direction", "found \"-z\"", "a passage is horizontal", "[-1, 1, 0]"}),
      spoil("step_direction_too_short", direction, "direction = @[1e-320, 0, 0]",
            {"step.direction", "between 1e-100 and 1e+100", "has no direction", "[0, 1, 0]"}),
      spoil("step_passages_none", direction, direction + "\npassages = @0",
            {"step.passages", "found 0", "expected a whole number from 1 to 1000"}),
      spoil("step_passages_a_half", direction, direction + "\npassages = @1.5",
            {"step.passages", "found 1.5", "expected a whole number from 1 to 1000"}),
      spoil("step_acceleration_as_velocity", direction, direction + "\nacceleration = @\"10 m/s\"",
            {"step.acceleration", "\"m/s\" is not a unit of acceleration", "\"10 m/s^2\""}),
      spoil("step_pause_as_frequency", direction, direction + "\npause = @\"20 Hz\"",
            {"step.pause", "found \"20 Hz\"", "\"Hz\" is not a unit of time", "\"50 ms\""}),
      spoil("step_travel_zero", direction, direction + "\ntravel = @\"0 mm\"",
            {"step.travel", "found \"0 mm\"", "more than 0 mm"}),
      spoil("step_key_misspelt", direction, direction + "\n@passage = 2",
            {"step.passage", "found 2", "did you mean \"passages\"?"}),
      spoil(
          "step_vibration_without_end", "[[step]]",
          "@[[step]]\nkind = \"vibration\"\ntool = \"shoe\"\naxis = \"x\"\namplitude = \"1 mm\"\nfrequency = "
          "\"32 Hz\"\n[[step]]",
          {"step.until", "this step has no end", "duration = \"1 s\""}),
      spoil(
          "step_vibration_shorter_than_its_ramps", "[[step]]",
          "[[step]]\nkind = \"vibration\"\ntool = \"shoe\"\naxis = \"x\"\namplitude = \"1 mm\"\nfrequency = "
          "\"2 Hz\"\nduration = @\"0.5 s\"\n[[step]]",
          {"step.duration", "found \"0.5 s\"", "its two ramps take 1 s", "shorter ramp"}),
      spoil(
          "step_frequency_as_time", "[[step]]",
          "[[step]]\nkind = \"vibration\"\ntool = \"shoe\"\naxis = \"x\"\namplitude = \"1 mm\"\nfrequency = "
          "@\"32 s\"\n[[step]]",
          {"step.frequency", "found \"32 s\"", "not a unit of frequency", "\"32 Hz\""}),
      spoil("step_tools_unknown", "[[step]]",
            "[[step]]\nkind = \"move\"\ntools = @[\"die\", \"core\"]\ndirection = \"z\"\n[[step]]",
            {"step.tools", "there is no \"core\"", "\"die\", \"shoe\""}),
      spoil("step_stations_twice_the_same", "[[step]]",
            "[[step]]\nkind = \"move\"\ntool = \"shoe\"\ndirection = \"z\"\nvelocity = \"1 m/s\"\nstations = "
            "@[\"1 mm\", \"1 mm\"]\n[[step]]",
            {"step.stations", "the same"}),
      spoil("step_starts_after_nobody", direction, direction + "\nstart = @{ after = \"first\" }",
            {"step.start", "found \"first\"", "no step has a name"}),
      spoil("step_waits_for_itself", kind,
            "kind = @\"passage\"\nname = \"pass\"\nstart = { after = \"pass\" }",
            {"step.kind", "depends on itself through other steps"}),
      spoil("step_condition_key_misspelt", direction, direction + "\nstart = { @aftr = \"first\" }",
            {"step.start.aftr", "did you mean \"after\"?"}),
      spoil("step_condition_empty", direction, direction + "\nstart = @{ }",
            {"step.start", "the condition is empty", "after, with, at"}),
      spoil("step_force_on_nobody", direction, direction + "\nuntil = @{ force = \"1 N\" }",
            {"step.until.on", "found nothing"}),
      spoil("step_wait_without_duration", "[[step]]", "@[[step]]\nkind = \"wait\"\n[[step]]",
            {"step.duration", "found nothing", "\"50 ms\""}),
      spoil("step_rotor_freed_of_torque_in_place", "[[step]]",
            "[[step]]\nkind = \"rotor\"\ntool = \"shoe\"\nspeed_limit = \"1 rpm\"\ntorques = @[\"0 N "
            "m\"]\n[[step]]",
            {"step.torques", "turn back", "back = \"5 deg\""}),
      spoil("step_rotor_at_speed_with_gain", "[[step]]",
            "[[step]]\nkind = \"rotor\"\ntool = \"shoe\"\nspeed_limit = \"1 rpm\"\nangle = \"90 "
            "deg\"\ngain = @2\n[[step]]",
            {"step.gain", "found 2", "turns at its speed_limit", "add a torque"}),
      spoil("step_rotor_without_end", "[[step]]",
            "@[[step]]\nkind = \"rotor\"\ntool = \"shoe\"\nspeed_limit = \"1 rpm\"\n[[step]]",
            {"step.until", "this step has no end"}),
      spoil("step_rotor_steady_over_nothing", "[[step]]",
            "[[step]]\nkind = \"rotor\"\ntool = \"shoe\"\nspeed_limit = \"1 rpm\"\nsteady = { within = "
            "0.05, over = @\"0 deg\" }\n[[step]]",
            {"step.steady.over", "found \"0 deg\"", "more than 0 deg"}),
      spoil("step_rotor_torques_and_angle", "[[step]]",
            "[[step]]\nkind = \"rotor\"\ntool = \"shoe\"\nspeed_limit = \"1 rpm\"\ntorques = [\"1 N "
            "m\"]\nangle = @\"90 deg\"\n[[step]]",
            {"step.angle", "ends by itself", "remove the key"}),
      spoil("step_settle_key_unknown", "[[step]]", "[[step]]\nkind = \"settle\"\n@speed = \"rest\"\n[[step]]",
            {"step.speed", "unknown key", "kind, duration"}),
  };
}

inline std::vector<WrongScene> wrong_numerics() {
  const std::string time = "max_time = \"5 s\"";
  return {
      spoil("time_step_given_twice", time, "time_step_fraction = 0.1\ntime_step = @\"2 us\"",
            {"numerics.time_step", "found \"2 us\"", "time_step_fraction is given as well", "remove one"}),
      spoil("time_step_too_long", time, "time_step = @\"2 s\"",
            {"numerics.time_step", "found \"2 s\"", "at most 1 ms"}),
      spoil("time_step_fraction_above_one", time, "time_step_fraction = @1.5",
            {"numerics.time_step_fraction", "found 1.5", "more than 0 and at most 1"}),
      spoil("lever_arm_unknown", time, "lever_arm = @\"centre\"",
            {"numerics.lever_arm", "found \"centre\"", "allowed: \"center\" or \"contact\"",
             "did you mean \"center\"?"}),
      spoil("tangential_spring_unknown", time, "tangential_spring = @\"cut_back\"",
            {"numerics.tangential_spring", "allowed: \"cut back\" or \"free\""}),
      spoil("opening_unknown", time, "opening = @\"walls\"",
            {"numerics.opening", "found \"walls\"", "allowed: \"surfaces\" or \"centres\""}),
      spoil("most_sheared_a_half", time, "most_sheared = @0.5",
            {"numerics.most_sheared", "found 0.5", "at most 0.1"}),
      spoil("most_sheared_of_none", time, "pinched_grains = \"stop\"\nmost_sheared = @0.01",
            {"numerics.most_sheared", "found 0.01", "remove one of the two"}),
      spoil("period_too_short", time, "periodic = { y = @\"2.16 mm\" }",
            {"numerics.periodic.y", "found \"2.16 mm\"", "allowed: at least 7.5264 mm",
             "four grain diameters"}),
      spoil("period_along_w", time, "periodic = { @w = \"10 mm\" }",
            {"numerics.periodic.w", "unknown key", "x, y, z"}),
      spoil("skin_too_wide", time, "skin = @\"1 m\"",
            {"numerics.skin", "found \"1 m\"", "more than 0 mm and at most 10 mm"}),
      spoil("max_time_negative", time, "max_time = @\"-5 s\"",
            {"numerics.max_time", "found \"-5 s\"", "more than 0 s"}),
      spoil("checkpoint_interval_too_short", time, "checkpoint_interval = @\"1 ms\"",
            {"numerics.checkpoint_interval", "found \"1 ms\"", "at least 1 s"}),
      spoil("numerics_key_unknown", time, "@threads = 4",
            {"numerics.threads", "found 4", "unknown key", "the allowed keys are time_step_fraction"}),
  };
}

inline std::vector<WrongScene> wrong_economies() {
  const std::string measure = "[measure]", time = "max_time = \"5 s\"",
                    from = "from = [\"19.4 mm\", \"-14.5 mm\", \"0 mm\"]", step = "[[step]]";
  const std::string shaking =
      "[[step]]\nkind = \"vibration\"\ntool = \"die\"\naxis = \"x\"\namplitude = \"1 mm\"\n"
      "frequency = \"30 Hz\"\nduration = \"1 s\"\n\n";
  const auto spoil_two = [&](const std::string& name, const std::string& old, const std::string& other,
                             const std::string& economy, const std::vector<std::string>& expected) {
    WrongScene scene = spoil(name, measure, economy + "\n\n" + measure, expected);
    scene.text = support::exchanged(scene.text, old, other);
    // Lines above the marked place have come or gone.
    scene.expected.erase(scene.expected.begin());
    return scene;
  };
  return {
      spoil("economy_key_unknown", measure, "[economy]\n@sleeping = true\n\n" + measure,
            {"economy.sleeping", "unknown key", "sleep"}),
      spoil("economy_mirror_unknown", measure, "[economy]\nmirror = @\"z\"\n\n" + measure,
            {"economy.mirror", "found \"z\"", "allowed: \"x\" or \"y\""}),
      spoil("economy_mirror_beside_the_pour", measure, "[economy]\nmirror = @\"x\"\n\n" + measure,
            {"economy.mirror", "found \"x\"", "the box of [pour] reaches from 19.4 to 51.4 mm along x",
             "the same extent on both sides of 0"}),
      spoil("economy_wake_force_of_a_whole_weight", measure,
            "[economy]\nsleep = true\nwake_force = @1\n\n" + measure,
            {"economy.wake_force", "found 1", "at most 0.9"}),
      spoil("economy_sleep_after_no_time", measure,
            "[economy]\nsleep = true\nsleep_after = @\"0 s\"\n\n" + measure,
            {"economy.sleep_after", "found \"0 s\"", "more than 0 s"}),
      spoil_two("economy_sleep_while_shaken", step, shaking + step, "[economy]\nsleep = @true",
                {"economy.sleep", "found true", "vibration", "would not move with it", "remove"}),
      spoil("economy_carry_beyond_without_unit", measure, "[economy]\ncarry_beyond = @10\n\n" + measure,
            {"economy.carry_beyond", "found 10", "20 mm"}),
      spoil("economy_carry_and_sleep", measure,
            "[economy]\nsleep = true\ncarry_beyond = @\"10 mm\"\n\n" + measure,
            {"economy.carry_beyond", "economy.sleep, which is on", "remove one"}),
      spoil_two("economy_carry_while_shaken", step, shaking + step, "[economy]\ncarry_beyond = @\"10 mm\"",
                {"economy.carry_beyond", "vibration", "would not move with it", "remove"}),
      spoil("economy_drop_spilled_in_quotes", measure, "[economy]\ndrop_spilled = @\"true\"\n\n" + measure,
            {"economy.drop_spilled", "found \"true\"", "true or false without quotes"}),
      spoil_two("economy_mirror_across_a_period", time, time + "\nperiodic = { y = \"29 mm\" }",
                "[economy]\nmirror = @\"y\"",
                {"economy.mirror", "numerics.periodic repeats the scene along y", "remove one"}),
      spoil_two("economy_mirror_with_a_lopsided_pour", from, "from = [\"19.4 mm\", \"-12 mm\", \"0 mm\"]",
                "[economy]\nmirror = @\"y\"", {"economy.mirror", "from -12 to 14.5 mm along y"}),
  };
}

inline std::vector<WrongScene> wrong_suctions() {
  const std::string plane = "fill_plane = \"0 mm\"\n", size = "particle_diameter = \"0.1 mm\"\n";
  return {
      spoil("suction_tool_unknown", plane, plane + "[suction]\n" + size + "tool = @\"shoo\"\n",
            {"suction.tool", "found \"shoo\"", "did you mean \"shoe\"?"}),
      spoil("suction_without_particles", plane, plane + "@[suction]\ntool = \"shoe\"\n",
            {"suction.particle_diameter", "found nothing", "0.1 mm"}),
      spoil("suction_through_a_block", plane,
            plane + "[suction]\ntool = \"shoe\"\n" + size + "solid_fraction = @1\n",
            {"suction.solid_fraction", "found 1", "at most 0.74"}),
      spoil("suction_of_sleepers", plane,
            plane + "[suction]\n" + size + "tool = @\"shoe\"\n\n[economy]\nsleep = true\n",
            {"suction.tool", "economy.sleep", "remove one"}),
  };
}

inline std::vector<WrongScene> wrong_measures() {
  const std::string plane = "fill_plane = \"0 mm\"\n";
  const std::string corners = "from = [\"0 mm\", \"0 mm\", \"0 mm\"]\nto = [\"9 mm\", \"9 mm\", \"5 mm\"]\n";
  return {
      spoil("averaging_width_zero", plane, "averaging_width = @\"0 mm\"\n",
            {"measure.averaging_width", "found \"0 mm\"", "more than 0 mm"}),
      spoil("averaging_width_below_a_tenth_of_a_grain", plane, "averaging_width = @\"1 um\"\n",
            {"measure.averaging_width", "found \"1 um\"", "at least", "a tenth of a grain"}),
      spoil("azimuth_bins_too_few", plane, "azimuth_bins = @1\n",
            {"measure.azimuth_bins", "found 1", "a whole number from 4 to 360"}),
      spoil("section_normal_zero", plane, plane + "[[measure.section]]\nname = \"a\"\nnormal = @[0, 0, 0]\n",
            {"measure.section.normal", "found [0, 0, 0]", "not all zero", "[0, 1, 0]"}),
      spoil("section_normal_too_short", plane,
            plane + "[[measure.section]]\nname = \"a\"\nnormal = @[1e-320, 0, 0]\n",
            {"measure.section.normal", "between 1e-100 and 1e+100", "has no direction", "[0, 1, 0]"}),
      spoil("section_normal_too_long", plane,
            plane + "[[measure.section]]\nname = \"a\"\nnormal = @[1e308, 1e308, 1e308]\n",
            {"measure.section.normal", "between 1e-100 and 1e+100", "has no direction"}),
      spoil("section_normal_of_texts", plane,
            plane + "[[measure.section]]\nname = \"a\"\nnormal = @[\"0\", \"1\", \"0\"]\n",
            {"measure.section.normal", "three numbers"}),
      spoil("section_without_name", plane, plane + "@[[measure.section]]\nnormal = \"x\"\n",
            {"measure.section.name", "found nothing"}),
      spoil("section_name_twice", plane,
            plane + "[[measure.section]]\nname = \"a\"\n[[measure.section]]\nname = @\"a\"\n",
            {"measure.section.name", "found \"a\"", "an earlier section already has this name"}),
      spoil("heap_without_box", plane, plane + "@[[measure.heap]]\nname = \"a\"\n",
            {"measure.heap.from", "found nothing"}),
      spoil("heap_box_empty", plane,
            plane + "[[measure.heap]]\nname = \"a\"\nfrom = [\"0 mm\", \"0 mm\", \"5 mm\"]\n" +
                "to = @[\"9 mm\", \"9 mm\", \"5 mm\"]\n",
            {"measure.heap.to", "the box is empty along z", "to must be greater than from"}),
      spoil("heap_of_the_same_figure", plane,
            plane + "[[measure.heap]]\nname = \"a b\"\n" + corners + "[[measure.heap]]\nname = @\"a-b\"\n" +
                corners,
            {"measure.heap.name", "found \"a-b\"", "an earlier heap, \"a b\"", "slope_of_a_b_deg"}),
      spoil("zone_of_the_same_figures", plane,
            plane + "[[measure.zone]]\nname = \"a b\"\ninner_radius = \"1 mm\"\n" +
                "[[measure.zone]]\nname = @\"a-b\"\ninner_radius = \"2 mm\"\n",
            {"measure.zone.name", "found \"a-b\"", "an earlier zone", "\"a b\""}),
      spoil("section_of_one_bracket", plane, plane + "@[measure.section]\nname = \"a\"\n",
            {"measure.section", "found a table", "write [[measure.section]] with double brackets"}),
  };
}

}  // namespace diefill::process
