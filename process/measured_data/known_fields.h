// The profiles and maps that results can have: what measured columns may be called, in which unit, and which
// values are possible.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "process/measured_data/measured_table.h"

namespace diefill::process {

/// Values that a quantity can have, in `unit`; `most` may be infinite, and `least`, too.
struct PossibleValues {
  std::string unit;
  double least = 0, most = 0;
};

/// Of the quantity of a profile or map, such as "fill level", "fill level over azimuth" or "fill level,
/// cavity 2"; nothing for names that are none, such as those of sections.
std::optional<PossibleValues> possible_values(const std::string& quantity);

/// Of a section, whose values are solid fractions.
PossibleValues possible_in_sections();

/// Names of columns of places, such as "azimuth": those of maps in the order of their axes.
const std::vector<std::string>& place_names();

/// All profiles that a result may have: "fill level", "fill level over azimuth".
std::vector<std::string> possible_profiles();

/// All maps that a result may have.
std::vector<std::string> possible_maps();

/// The places that a profile of the quantity runs over, and those of a map or section; empty for profiles
/// that there are not.
std::vector<std::string> places_of_profile(const std::string& quantity);
std::vector<std::string> places_of_map(const std::string& quantity);

/// Throws SceneError for a column of places that is none of those, or has a unit of another dimension. Places
/// without a name (kUnnamedPlaces) need the dimension of one of them.
void refuse_other_places(const MeasuredTable& table, const std::vector<std::string>& allowed);

/// Whether a column of places holds azimuths: by its name, or without one (kUnnamedPlaces) by its unit.
bool holds_azimuths(const MeasuredColumn& place);

/// The azimuth (deg) from 0 to below 360 of the same direction, to 1e-9 deg.
double azimuth_in_circle(double azimuth);

/// Whether the two names are the same but for capitals, blanks and dashes.
bool same_name(const std::string& one, const std::string& other);

/// Throws SceneError, with the line, for values that the quantity cannot have, and for a unit of another
/// dimension.
void refuse_impossible(const MeasuredTable& table, const PossibleValues& possible);

/// The message that `found` is none of `allowed`, with the nearest of them.
std::string not_among(const std::string& found, const std::vector<std::string>& allowed);

}  // namespace diefill::process
