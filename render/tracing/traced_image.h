// Traces an image of spheres and triangles: soft shadow of one lamp, ambient light that gaps keep out.
#pragma once

#include <QImage>

#include "render/tracing/ray_scene.h"

namespace diefill::render {

/// A parallel view; lengths in the scene's unit.
struct TracedCamera {
  Eigen::Vector3f target = Eigen::Vector3f::Zero();  ///< centre of the image
  Eigen::Vector3f right = Eigen::Vector3f::UnitX(), up = Eigen::Vector3f::UnitZ(),
                  to_eye = -Eigen::Vector3f::UnitY();
  float height = 1;    ///< what the image spans
  float distance = 1;  ///< of the eye's plane from the target: beyond all bodies
};

/// How light falls.
struct TracedLight {
  float gap = 1;  ///< how far a body keeps ambient light away: a few grain diameters
};

/// On white, width x height pixels: 4 rays from the eye a pixel, each with 2 to the surroundings and 1 to the
/// lamp, smoothed over 16 rays of like surfaces. `translucent` is seen through, each surface with this
/// opacity, and casts no shadow. Directions are fixed, so that the same scene gives the same image on any
/// number of threads.
QImage trace_image(const RayScene& scene, const RayScene* translucent, float opacity,
                   const TracedCamera& camera, const TracedLight& light, int width, int height);

}  // namespace diefill::render
