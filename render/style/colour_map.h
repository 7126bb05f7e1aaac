// Colours for numbers: one perceptually even map (viridis), and the neutral grey of "no value".
#pragma once

#include <cstdint>

namespace diefill::render {

/// An sRGB colour, 8 bits a channel.
struct Rgb {
  std::uint8_t red = 0, green = 0, blue = 0;
  bool operator==(const Rgb&) const = default;
};

/// A colour in CIELAB (D65 white): lightness 0..100 and the two opponent axes.
struct Lab {
  double lightness = 0, a = 0, b = 0;
};

/// Where there is no powder, or no value: light neutral grey, a colour that the map does not contain.
inline constexpr Rgb kNoValueColour{217, 217, 217};

/// Viridis (van der Walt and Smith, public domain) at `fraction` of its length, clamped to 0..1; lightness
/// rises evenly from dark violet to yellow, so that it also reads in grey print. NaN gives kNoValueColour.
Rgb map_colour(double fraction);

/// Which colours a scale runs through.
enum class ColourScale {
  kSequential,  ///< viridis: from little to much
  kDiverging    ///< blue, white, red: less, the same, more
};

/// Colour at `fraction` of a scale, clamped to 0..1; NaN gives kNoValueColour. The diverging one is
/// ColorBrewer's RdBu, reversed: lightness rises evenly to the white middle and falls evenly from there.
Rgb scale_colour(ColourScale scale, double fraction);

/// map_colour of `value` on the scale lower..upper. Throws nothing; equal limits give the middle colour.
Rgb value_colour(double value, double lower, double upper);

/// Converts sRGB to CIELAB (IEC 61966-2-1 transfer curve, D65 white).
Lab to_lab(const Rgb& colour);

}  // namespace diefill::render
