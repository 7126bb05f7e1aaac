// Checks that need more than one key: values that are each allowed but cannot work together.
#pragma once

#include "process/input/table_reader.h"
#include "process/scene/scene.h"

namespace diefill::process {

/// A grain's density must be that of some solid, 0.1 to 25 g/cm^3: catches slips of units in radius and mass.
void check_density(const TableReader& table, const PowderSpec& powder);

/// kg/m^3, of a grain's solid volume.
double grain_density(const PowderSpec& powder);

/// The wanted grain size must be within 0.1 to 20 times the powder's own: further away the parameters mean
/// nothing.
void check_coarsening(const TableReader& table, const PowderSpec& powder);

/// A basic sphere must not fit through the hole in the square grid of wall spheres of radius `sphere_radius`
/// (m) and distance `spacing` * `sphere_radius`.
void check_wall_is_tight(const TableReader& table, double sphere_radius, double spacing,
                         const PowderSpec& powder);

/// A period must be at least four grain diameters, or a grain meets its own image (Bierwisch 2009 uses 4.6
/// d).
void check_period(const TableReader& table, const std::string& key, double period, const PowderSpec& powder);

/// The pour box must not be empty, must hold a grain in each direction, must be as high as the fill and must
/// lie within the periods; the lattice must leave room for its random offsets.
void check_pour(const TableReader& table, const PourSpec& pour, const PowderSpec& powder,
                const NumericsSpec& numerics);

/// The Gaussian width of fields (m) must be a tenth of a grain or more. Its upper limit depends on the cavity
/// (process/setup/averaging_width_limit).
void check_averaging_width(const TableReader& table, double width, const PowderSpec& powder);

}  // namespace diefill::process
