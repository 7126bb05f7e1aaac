// The experiments, one file each; registry.cpp lists them.
#pragma once

#include "process/laboratory/published/scene_experiment.h"

namespace diefill::process::laboratory {

/// Laws, grains, turning, flow above a slit and discharge against exact results.
LabPlan plan_closed_forms(const LabSetting& setting);
/// Collisions of model D grains of three sizes, parameters scaled with the size or one of them held
/// (Bierwisch 2009, section 3.1).
LabPlan plan_clump_collision(const LabSetting& setting);
/// Beds that form by falling: overlaps, contacts and solid fraction of two sizes (section 3.2.1).
LabPlan plan_bulk_formation(const LabSetting& setting);
/// Steady discharge over slit width and grain size (section 3.2.2).
LabPlan plan_slit_flow(const LabSetting& setting);
/// Discharge of the moving shoe over its speed, all powder models (sections 4.1.1 and 4.1.2).
LabPlan plan_shoe_discharge(const LabSetting& setting);
/// Speeds of grains near the slit while the shoe passes (section 4.1.8).
LabPlan plan_slit_fields(const LabSetting& setting);
/// Discharge of the moving shoe against the prediction from hopper flow (section 5.2.2).
LabPlan plan_moving_shoe(const LabSetting& setting);
LabPlan plan_long_shoe(const LabSetting& setting);
/// What Young's modulus changes (section 4.2.2), and damping (section 4.2.3).
LabPlan plan_youngs_modulus(const LabSetting& setting);
LabPlan plan_damping(const LabSetting& setting);
/// Solid fraction of adhesive beds over diameter and way of packing (Kottlan 2018, section 3.1).
LabPlan plan_packing(const LabSetting& setting);
/// Adhesive beds pressed in five cycles (Kottlan 2018, section 2.7.2).
LabPlan plan_confined_compression(const LabSetting& setting);
/// Compression of LH100 over the reference overlap that k_1 belongs to (Kottlan 2018, Eq. 3).
LabPlan plan_reference_overlap(const LabSetting& setting);
/// Yield loci of adhesive beds in a shear cell (Kottlan 2018, section 2.7.4), their friction on a turning
/// disc (section 2.7.5), and arching in a wedge hopper (section 3.4).
LabPlan plan_shear_tester(const LabSetting& setting);
LabPlan plan_disc_friction(const LabSetting& setting);
LabPlan plan_wedge_hopper(const LabSetting& setting);
/// Compression of the 33 beds of each published design: screening (Table 17), calibration over a large range
/// (Table 18) and over the ranges of LH100 and LH220 (Table 8).
LabPlan plan_lactose_screening(const LabSetting& setting);
LabPlan plan_lactose_large_range(const LabSetting& setting);
LabPlan plan_lh100_range(const LabSetting& setting);
LabPlan plan_lh220_range(const LabSetting& setting);
/// Shear tests of the same beds.
LabPlan plan_lactose_shear_screening(const LabSetting& setting);
LabPlan plan_lactose_shear_range(const LabSetting& setting);
LabPlan plan_lh100_shear_range(const LabSetting& setting);
LabPlan plan_lh220_shear_range(const LabSetting& setting);
/// Beds with Luding's rolling spring (Kottlan 2018, section 2.2.4).
LabPlan plan_rolling_model(const LabSetting& setting);
/// Half angle and slot of a wedge hopper from a shear test (Kottlan 2018, section 3.4).
LabPlan plan_hopper_design(const LabSetting& setting);
/// Angles of the heaps on slider and floor (sections 4.1.3 and 4.1.4).
LabPlan plan_angle_of_repose(const LabSetting& setting);
/// Toe and peak of these heaps over the grain size (section 3.2.3).
LabPlan plan_heap_sizes(const LabSetting& setting);
/// Mean solid fractions at rest and in the moving shoe (section 4.1.5).
LabPlan plan_mean_fractions(const LabSetting& setting);
/// Discharge over the depth of powder in the shoe (section 4.1.6).
LabPlan plan_fill_height(const LabSetting& setting);
/// Stress over strain of beds of enlarged spheres, three methods of scaling (Hu 2024, section 4.2).
LabPlan plan_uniaxial_compression(const LabSetting& setting);
/// A steel ball that falls into two beds (Dosta et al. 2024, case 3).
LabPlan plan_ball_impact(const LabSetting& setting);
/// Discharge of a silo through two openings (Dosta et al. 2024, case 1).
LabPlan plan_silo(const LabSetting& setting);
/// A rotating drum with two materials (Dosta et al. 2024, case 2).
LabPlan plan_drum(const LabSetting& setting);
/// Apparent density, flow, density after vibration, angles of repose and discharge of one powder: a data
/// sheet.
LabPlan plan_powder_sheet(const LabSetting& setting);
/// Beds of cohesive spheres: with rolling resistance, one setting at a time, of two sizes, of log-normal
/// sizes (Hu 2024, sections 5.2, 6.2 and 6.3).
LabPlan plan_mono_disperse_beds(const LabSetting& setting);
LabPlan plan_bed_variants(const LabSetting& setting);
LabPlan plan_bi_disperse_beds(const LabSetting& setting);
LabPlan plan_log_normal_beds(const LabSetting& setting);
LabPlan plan_log_normal_scaling(const LabSetting& setting);
/// Angle of repose of heaps on a plate (Hu 2024, section 5.3).
LabPlan plan_heap_on_plate(const LabSetting& setting);
/// Time step at which elastic spheres gain energy (Hu 2024, section 4.4).
LabPlan plan_critical_step(const LabSetting& setting);
/// Speeds of wet and adhesive spheres in a mixer (Hu 2024, section 4.3).
LabPlan plan_vertical_mixer(const LabSetting& setting);
/// Effective friction of walls of spheres, and what it changes in the discharge (Bierwisch 2009, section
/// 4.2.4).
LabPlan plan_wall_friction(const LabSetting& setting);
LabPlan plan_wall_discharge(const LabSetting& setting);
/// Filling level of a narrow ring over azimuth and grain size (Bierwisch 2009, section 6.1).
LabPlan plan_ring_levels(const LabSetting& setting);
LabPlan plan_ring_maps(const LabSetting& setting);
/// The same ring while it fills, and how deep later passages move its powder (section 6.4).
LabPlan plan_ring_transient(const LabSetting& setting);
LabPlan plan_ring_displacement(const LabSetting& setting);
/// Rotational oscillation of the filled ring, one setting varied at a time (section 6.5.2).
LabPlan plan_ring_oscillation(const LabSetting& setting);
/// Scatter of the discharge over packings (section 4.2.1).
LabPlan plan_packing_scatter(const LabSetting& setting);

}  // namespace diefill::process::laboratory
