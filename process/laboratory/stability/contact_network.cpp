#include "process/laboratory/stability/contact_network.h"

#include <Eigen/Dense>
#include <cmath>

#include "engine/contact/pair_laws.h"
#include "engine/limits/law_probe.h"
#include "engine/powder/periodic_box.h"
#include "engine/powder/rigid_motion.h"
#include "engine/simulation/simulation.h"

namespace diefill::process::laboratory {

namespace {

using Eigen::Vector3d;
using Coordinates = Eigen::Matrix<double, 6, 1>;  // of a grain: translation, rotation in its body frame

/// One spring: how its length changes with the coordinates of its grains, over the roots of their masses.
struct Spring {
  std::size_t i = 0, j = 0;
  bool wall = false;
  Coordinates slope_i = Coordinates::Zero(), slope_j = Coordinates::Zero();
  double stiffness = 0;
};

struct Sphere {
  std::size_t grain;
  Vector3d place, arm;  // m, centre in the laboratory and from the grain's centre
};

class Network {
 public:
  explicit Network(const engine::Simulation& simulation)
      : settings_(simulation.settings()),
        shape_(settings_.shape()),
        among_grains_(engine::law_between(simulation.types(), settings_.contact, 0, 0)),
        with_floor_(engine::law_at_wall(simulation.types(), settings_.contact, 0, {})),
        box_(settings_.period) {
    const auto& grains = simulation.grains();
    for (std::size_t g = 0; g < grains.size(); ++g) {
      turn_.push_back(engine::rotation_matrix(grains.orientation_of(g)));
      for (const auto& offset : shape_.sphere_offsets) {
        const Vector3d arm = turn_.back() * offset;
        spheres_.push_back({g, grains.position[g] + arm, arm});
      }
    }
    find_contacts();
  }

  double largest_eigenvalue() const {
    constexpr int kIterations = 400;
    std::vector<Coordinates> shape(turn_.size());
    for (std::size_t g = 0; g < shape.size(); ++g)
      for (Eigen::Index k = 0; k < 6; ++k)
        shape[g][k] = std::sin(1.0 + 7.3 * static_cast<double>(g) + 2.1 * static_cast<double>(k));
    double eigenvalue = 0;
    for (int n = 0; n < kIterations && !found_.empty(); ++n) {
      double norm = 0;
      for (const auto& part : shape) norm += part.squaredNorm();
      for (auto& part : shape) part /= std::sqrt(norm);
      shape = pushed(shape);
      eigenvalue = 0;
      for (const auto& part : shape) eigenvalue += part.squaredNorm();
      eigenvalue = std::sqrt(eigenvalue);
    }
    return eigenvalue;
  }

 private:
  std::vector<Coordinates> pushed(const std::vector<Coordinates>& shape) const {
    std::vector<Coordinates> force(shape.size(), Coordinates::Zero());
    for (const auto& spring : found_) {
      double stretch = spring.slope_i.dot(shape[spring.i]);
      if (!spring.wall) stretch += spring.slope_j.dot(shape[spring.j]);
      force[spring.i] += spring.stiffness * stretch * spring.slope_i;
      if (!spring.wall) force[spring.j] += spring.stiffness * stretch * spring.slope_j;
    }
    return force;
  }

  void find_contacts() {
    const double radius = shape_.sphere_radius;
    for (std::size_t a = 0; a < spheres_.size(); ++a) {
      const double depth = radius - spheres_[a].place.z();
      if (depth > 0) add(spheres_[a], nullptr, Vector3d::UnitZ(), depth, with_floor_.springs(depth));
      for (std::size_t b = a + 1; b < spheres_.size(); ++b) {
        if (spheres_[a].grain == spheres_[b].grain) continue;
        const Vector3d between = box_.wrapped(spheres_[a].place - spheres_[b].place);
        const double overlap = 2 * radius - between.norm();
        if (overlap > 0)
          add(spheres_[a], &spheres_[b], between.normalized(), overlap, among_grains_.springs(overlap));
      }
    }
  }

  void add(const Sphere& a, const Sphere* b, const Vector3d& normal, double overlap,
           const engine::ContactSprings& springs) {
    add_spring(a, b, normal, normal, springs.normal, overlap);
    if (springs.tangential <= 0) return;
    const Vector3d across = normal.unitOrthogonal();
    add_spring(a, b, normal, across, springs.tangential, overlap);
    add_spring(a, b, normal, normal.cross(across), springs.tangential, overlap);
  }

  void add_spring(const Sphere& a, const Sphere* b, const Vector3d& normal, const Vector3d& direction,
                  double stiffness, double overlap) {
    const double to_contact = shape_.sphere_radius - (b != nullptr ? 0.5 : 1.0) * overlap;
    Spring spring;
    spring.i = a.grain;
    spring.stiffness = stiffness;
    spring.slope_i = slope(a, a.arm - to_contact * normal, direction);
    spring.wall = b == nullptr;
    if (b != nullptr) {
      spring.j = b->grain;
      spring.slope_j = -slope(*b, b->arm + to_contact * normal, direction);
    }
    found_.push_back(spring);
  }

  Coordinates slope(const Sphere& sphere, const Vector3d& lever, const Vector3d& direction) const {
    Coordinates change = Coordinates::Zero();
    change.head<3>() = direction / std::sqrt(shape_.mass);
    if (shape_.rotates)
      change.tail<3>() = (turn_[sphere.grain].transpose() * lever.cross(direction))
                             .cwiseQuotient(shape_.inertia.cwiseSqrt());
    return change;
  }

  const engine::SimulationSettings& settings_;
  const engine::GrainShape& shape_;
  engine::LawProbe among_grains_, with_floor_;
  engine::PeriodicBox box_;
  std::vector<Eigen::Matrix3d> turn_;
  std::vector<Sphere> spheres_;
  std::vector<Spring> found_;
};

}  // namespace

double largest_eigenfrequency(const engine::Simulation& simulation) {
  return std::sqrt(Network(simulation).largest_eigenvalue());
}

}  // namespace diefill::process::laboratory
