// What surrounds the powder on pictures of a result: tools, cavities, fill plane; and the position of a
// section.
#pragma once

#include "process/results/fill_result.h"
#include "render/fields/field_style.h"

namespace diefill::render {

/// Adds to `style` what a section of `result` shows besides powder: the tools' outlines, which places lie in
/// a cavity, and the fill plane where the section is upright.
void add_section_places(FieldStyle& style, const results::FillResult& result,
                        const results::SectionPlane& plane);

/// The same for a map of the result's cavity: over azimuth and height, over x and y, or over x or y and
/// height. Maps over x and y have the tools' outlines at half the cavity's depth.
void add_map_places(FieldStyle& style, const results::FillResult& result, const results::Field2D& map);

/// "section y = 12 mm", with the plane's name in brackets where it has one of its own; a plane along no axis
/// by its normal and its distance from the laboratory's origin.
std::string section_text(const results::SectionPlane& plane);

}  // namespace diefill::render
