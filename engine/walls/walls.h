// Tools as the engine sees them: rigid bodies made of wall spheres (or of planes or triangles), carried by a
// prescribed motion. Their mass is infinite; forces on them are summed for measurement (Bierwisch 2009,
// section 2.3).
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "engine/laws/contact_parameters.h"
#include "engine/walls/triangle_cells.h"

namespace diefill::engine {

/// Pose and velocity of a body at one time: a body point p stands at rotation * p + translation.
struct BodyMotion {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();       ///< m
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();          ///< m/s, of the body frame's origin
  Eigen::Vector3d angular_velocity = Eigen::Vector3d::Zero();  ///< rad/s, laboratory frame

  Eigen::Vector3d point(const Eigen::Vector3d& body_point) const {
    return rotation * body_point + translation;
  }
  /// Velocity (m/s) of the material point that is at `lab_point` (m).
  Eigen::Vector3d velocity_at(const Eigen::Vector3d& lab_point) const {
    return velocity + angular_velocity.cross(lab_point - translation);
  }
};

/// A flat wall without end; powder is on the side its normal points to.
struct WallPlane {
  Eigen::Vector3d point;   ///< m, body frame
  Eigen::Vector3d normal;  ///< unit vector, body frame
};

/// A tool to be built into a simulation: of spheres, of planes, or of triangles.
struct WallBodySpec {
  std::string name;
  std::vector<Eigen::Vector3d> centres;  ///< m, wall sphere centres in the body frame
  double sphere_radius = 1.5e-4;         ///< m, R_w
  std::vector<WallPlane> planes;         ///< in place of spheres: R_eff is the grain sphere's radius
  /// In place of spheres: the surface itself, closed or with rims that no grain comes to.
  std::vector<WallTriangle> triangles;
  /// m, of the wall in the R_eff of triangles; infinite: flat, R_eff is the grain sphere's radius.
  double contact_radius = std::numeric_limits<double>::infinity();
  std::optional<ContactParameters> contact;  ///< with powder; nothing: SimulationSettings::wall_contact
  std::string material;                      ///< of the tool, where powders of several kinds need its laws
  /// Motion at time t (s); empty: the body stands still where its frame is the laboratory's.
  std::function<BodyMotion(double)> motion;
};

/// Wall spheres (or triangles) of one body in cells of its own frame, so that a search costs nothing where
/// the body is far.
class WallBody {
 public:
  /// `reach`: largest distance (m) from a wall sphere's centre at which a grain sphere's centre may ask for
  /// it. Throws std::invalid_argument when there are parts of two kinds, or a triangle without area.
  WallBody(WallBodySpec spec, double reach);

  const std::string& name() const { return spec_.name; }
  /// m, of the wall spheres; 0 for planes and triangles.
  double sphere_radius() const { return flat() || meshed() ? 0 : spec_.sphere_radius; }
  /// m, of the wall in the R_eff of its contacts; infinite for planes and flat triangles.
  double contact_radius() const {
    if (meshed()) return spec_.contact_radius;
    return flat() ? std::numeric_limits<double>::infinity() : spec_.sphere_radius;
  }
  const std::optional<ContactParameters>& contact() const { return spec_.contact; }
  const std::string& material() const { return spec_.material; }
  bool flat() const { return !spec_.planes.empty(); }
  bool meshed() const { return !spec_.triangles.empty(); }
  const std::vector<WallPlane>& planes() const { return spec_.planes; }
  const std::vector<WallTriangle>& triangles() const { return spec_.triangles; }
  const std::vector<Eigen::Vector3d>& triangle_normals() const { return normals_; }
  /// Number of wall spheres, planes or triangles.
  std::size_t size() const { return spec_.planes.size() + spec_.triangles.size() + spec_.centres.size(); }
  bool moves() const { return static_cast<bool>(spec_.motion); }
  void set_motion(std::function<BodyMotion(double)> motion) { spec_.motion = std::move(motion); }
  BodyMotion motion_at(double time) const { return spec_.motion ? spec_.motion(time) : BodyMotion{}; }
  const std::vector<Eigen::Vector3d>& centres() const { return spec_.centres; }
  /// m, distance of the farthest wall sphere centre or corner from the body frame's origin.
  double extent() const { return extent_; }
  Eigen::Vector3d lower() const { return lower_; }
  Eigen::Vector3d upper() const { return upper_; }

  /// Appends to `found` the wall spheres (index in centres()), planes or triangles no farther than `reach`
  /// (m, at most the constructor's) from `body_point` (m, body frame).
  void find(const Eigen::Vector3d& body_point, double reach, std::vector<std::uint32_t>& found) const;

 private:
  Eigen::Vector3i cell_of(const Eigen::Vector3d& body_point) const;
  std::size_t index_of(const Eigen::Vector3i& cell) const;
  void include(const Eigen::Vector3d& point);
  void take_in_triangles();
  void sort_into_cells();
  void mark_neighbourhoods();

  WallBodySpec spec_;
  double reach_ = 0, cell_size_ = 0, extent_ = 0;
  Eigen::Vector3d lower_, upper_;
  Eigen::Vector3i cells_ = Eigen::Vector3i::Zero();
  std::vector<std::uint32_t> first_;  ///< first wall sphere of a cell; centres are sorted by cell
  std::vector<std::uint8_t>
      neighbourhood_;  ///< 1 where a wall sphere is in a cell or within the constructor's reach of it
  std::vector<Eigen::Vector3d> normals_;  ///< of triangles, unit vectors towards the powder
  TriangleCells triangle_cells_;
};

}  // namespace diefill::engine
