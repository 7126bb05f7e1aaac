#include "render/style/colour_map.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace diefill::render {
namespace {

// Viridis at sixteen even stops; between them the channels are interpolated linearly.
constexpr std::array<Rgb, 16> kStops{{{0x44, 0x01, 0x54},
                                      {0x48, 0x1A, 0x6C},
                                      {0x47, 0x2F, 0x7D},
                                      {0x41, 0x44, 0x87},
                                      {0x39, 0x56, 0x8C},
                                      {0x31, 0x68, 0x8E},
                                      {0x2A, 0x78, 0x8E},
                                      {0x23, 0x88, 0x8E},
                                      {0x1F, 0x98, 0x8B},
                                      {0x22, 0xA8, 0x84},
                                      {0x35, 0xB7, 0x79},
                                      {0x54, 0xC5, 0x68},
                                      {0x7A, 0xD1, 0x51},
                                      {0xA5, 0xDB, 0x36},
                                      {0xD2, 0xE2, 0x1B},
                                      {0xFD, 0xE7, 0x25}}};

// ColorBrewer's RdBu of eleven classes (Brewer, Harrower and others, Apache licence), from blue to red.
constexpr std::array<Rgb, 11> kDivergingStops{{{0x05, 0x30, 0x61},
                                               {0x21, 0x66, 0xAC},
                                               {0x43, 0x93, 0xC3},
                                               {0x92, 0xC5, 0xDE},
                                               {0xD1, 0xE5, 0xF0},
                                               {0xF7, 0xF7, 0xF7},
                                               {0xFD, 0xDB, 0xC7},
                                               {0xF4, 0xA5, 0x82},
                                               {0xD6, 0x60, 0x4D},
                                               {0xB2, 0x18, 0x2B},
                                               {0x67, 0x00, 0x1F}}};

std::uint8_t mix(std::uint8_t from, std::uint8_t to, double weight) {
  return static_cast<std::uint8_t>(std::lround(from + weight * (to - from)));
}

double linear_light(std::uint8_t channel) {
  const double value = channel / 255.0;
  return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

double lab_curve(double ratio) {
  constexpr double kKnee = 6.0 / 29.0;
  return ratio > kKnee * kKnee * kKnee ? std::cbrt(ratio) : ratio / (3 * kKnee * kKnee) + 4.0 / 29.0;
}

template <std::size_t N>
Rgb between_stops(const std::array<Rgb, N>& stops, double fraction) {
  if (std::isnan(fraction)) return kNoValueColour;
  const double place = std::clamp(fraction, 0.0, 1.0) * (N - 1);
  const auto below = std::min(static_cast<std::size_t>(place), N - 2);
  const double weight = place - static_cast<double>(below);
  const Rgb &from = stops[below], &to = stops[below + 1];
  return {mix(from.red, to.red, weight), mix(from.green, to.green, weight), mix(from.blue, to.blue, weight)};
}

}  // namespace

Rgb map_colour(double fraction) {
  return between_stops(kStops, fraction);
}

Rgb scale_colour(ColourScale scale, double fraction) {
  return scale == ColourScale::kDiverging ? between_stops(kDivergingStops, fraction) : map_colour(fraction);
}

Rgb value_colour(double value, double lower, double upper) {
  if (std::isnan(value)) return kNoValueColour;
  return map_colour(upper > lower ? (value - lower) / (upper - lower) : 0.5);
}

Lab to_lab(const Rgb& colour) {
  const double red = linear_light(colour.red), green = linear_light(colour.green),
               blue = linear_light(colour.blue);
  const double x = lab_curve((0.4124564 * red + 0.3575761 * green + 0.1804375 * blue) / 0.95047);
  const double y = lab_curve(0.2126729 * red + 0.7151522 * green + 0.0721750 * blue);
  const double z = lab_curve((0.0193339 * red + 0.1191920 * green + 0.9503041 * blue) / 1.08883);
  return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

}  // namespace diefill::render
