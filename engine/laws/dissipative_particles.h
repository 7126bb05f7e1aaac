// Dissipative particle dynamics (DPD): a fluid of soft points that repel each other by their density, slow
// each other down and push each other at random (Bierwisch 2009, appendix A). In any consistent units: those
// below are SI; reduced ones have reach, mass and thermal energy 1.
#pragma once

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace diefill::engine::laws {

/// Constants of the fluid and of solids in it. The source's, in reduced units (Table C.7), where it has them.
struct DpdParameters {
  double reach = 1;              ///< m, r_c: particles farther apart do not act on each other
  double density = 4.15;         ///< 1/m^3, rho: denser fluid repels, thinner one attracts
  double repulsion = 0.5;        ///< N m^9, K of Eq. A.1
  double noise = 3;              ///< N s^(1/2), sigma_R of Eq. A.3
  double thermal_energy = 1;     ///< J, k_B T'
  double grain_stiffness = 1e3;  ///< N, kappa of Eq. A.5, between grains
  double tool_stiffness = 1e3;   ///< N, the same between grains and tools: Eq. 2.3 of points
  double tool_damping = 10;      ///< kg/s, Eq. 2.6 of points: over sqrt(w)
  /// Share of a solid's particle in the density of the fluid about it. Above 1 no fluid enters a solid.
  double solid_share = 1.5;
  /// Noise between fluid and solids over that within the fluid.
  double grip = 1;

  /// Throws std::invalid_argument for constants with which there is no fluid.
  void check() const {
    const auto require = [](bool holds, const char* reason) {
      if (!holds) throw std::invalid_argument(reason);
    };
    require(reach > 0 && density > 0, "a DPD fluid needs a cut-off radius and a density above 0");
    require(repulsion >= 0 && noise >= 0, "repulsion and noise of a DPD fluid cannot be below 0");
    require(thermal_energy > 0,
            "a DPD fluid needs a thermal energy above 0: it sets the damping for the given noise");
    require(grain_stiffness >= 0 && tool_stiffness >= 0 && tool_damping >= 0,
            "stiffness and damping of grains in a DPD fluid cannot be below 0");
    require(solid_share > 0 && grip >= 0, "solids in a DPD fluid need a share in its density above 0");
  }
};

/// Forces between two particles along the line between them, positive: apart.
class DissipativeParticles {
 public:
  /// Throws what DpdParameters::check() throws.
  DissipativeParticles(const DpdParameters& parameters, double time_step)
      : given_(parameters),
        damping_(parameters.noise * parameters.noise / (2 * parameters.thermal_energy)),
        kick_(parameters.noise / std::sqrt(time_step)),
        kernel_(15 / (2 * std::numbers::pi * parameters.reach * parameters.reach * parameters.reach)) {
    parameters.check();
  }

  const DpdParameters& given() const { return given_; }
  double reach() const { return given_.reach; }
  /// w(r) = 1 - r/r_c at the distance r (m) within the reach (Eq. A.4).
  double weight(double distance) const { return 1 - distance / given_.reach; }
  /// 1/m^3: what a fluid particle adds to the density about one at weight w. Its slope is in proportion to w,
  /// as Eq. A.1 asks for, and it adds up to 1 over space (OP-15). A particle is not in its own density.
  double density_of(double w) const { return kernel_ * w * w; }
  /// 1/m^3: the same of a solid's particle.
  double density_of_solid(double w) const { return given_.solid_share * density_of(w); }
  /// N: a fluid particle's part of Eq. A.1, of the density (1/m^3) about it.
  double push(double density) const {
    const double excess = density - given_.density;
    return 2 * given_.repulsion * density * excess * (density + excess);
  }
  /// gamma_D = sigma_R^2 / (2 k_B T') (kg/s): what keeps the temperature.
  double damping() const { return damping_; }

  /// N, Eqs. A.1 and A.2 between two particles of the fluid at weight w: `pushes` of both (N) together, and
  /// the speed of their separation (m/s).
  double between_fluid(double w, double pushes, double separation_speed) const {
    return w * (pushes - damping_ * w * separation_speed);
  }
  /// N, the same of fluid and a solid. A solid has no density of its own to keep.
  double at_solid(double w, double push, double separation_speed) const {
    const double held = given_.grip * w;
    return given_.solid_share * push * w - damping_ * held * held * separation_speed;
  }
  /// N, Eq. A.3: of a random number of mean 0 and variance 1 that stays for a time step.
  double kick_in_fluid(double w, double random) const { return kick_ * w * random; }
  double kick_at_solid(double w, double random) const { return kick_ * given_.grip * w * random; }
  /// N, Eq. A.5: elastic force of grains on each other.
  double between_grains(double w) const { return given_.grain_stiffness * w * std::sqrt(w); }
  /// N, of grains and tools: Hertz with damping, of points (Eqs. 2.3, 2.6). Never pulls.
  double at_tool(double w, double separation_speed) const {
    const double root = std::sqrt(w);
    const double force = root * (given_.tool_stiffness * w - given_.tool_damping * separation_speed);
    return force > 0 ? force : 0;
  }
  /// J: energy of the fluid per particle whose force Eq. A.1 is, psi(rho) = K rho^2 (rho - rho_0)^2 over the
  /// slope of the kernel.
  double energy(double density) const {
    const double excess = density - given_.density;
    return given_.repulsion * density * density * excess * excess * given_.reach / (2 * kernel_);
  }

 private:
  DpdParameters given_;
  double damping_, kick_, kernel_;
};

}  // namespace diefill::engine::laws
