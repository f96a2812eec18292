// The elastic steel of a gyratory scene: what the scene names is meshed, reduced and coupled; what
// it does not name does not exist.
#pragma once

#include <optional>

#include "apps/machine.h"
#include "apps/pictures.h"
#include "coupling/elastic_wall.h"
#include "dem/material.h"

namespace apps {

// One elastic body behind one wall of the run.
class SteelPart {
 public:
  // Gives `wall` its letterbox and reduces the body to the scene's modes. Throws InputError where
  // the body has not as many.
  SteelPart(const ElasticHeadScene& scene, const Machine& machine, const NumericsScene& numerics,
            dem::Wall& wall);
  SteelPart(const ElasticMouldScene& scene, const Machine& machine, const NumericsScene& numerics,
            dem::Wall& wall);

  void exchange(dem::Wall& wall, dem::Steps steps) { coupled_->exchange(wall, steps); }

  // See dem/state.h.
  template <class Visit>
  void visit_state(Visit& visit, const std::string& in) {
    coupled_->visit_state(visit, in);
  }

  double mass() const { return body_.mass(); }  // [kg]
  const coupling::ElasticWall& coupled() const { return *coupled_; }
  const fem::ElasticBody& body() const { return body_; }

  // Static answer of the head's face to a unit moment about y and a unit force along x, both at the
  // centre of the face: rotation about y [rad/(N m)], [rad/N], by the full body.
  struct Tilt {
    double per_moment, per_force;
  };
  Tilt tilt() const;

  // The deformed body in the laboratory with displacement and stress (displacement not magnified).
  void draw(const std::string& vtu, const dem::Frame& frame) const;

 private:
  template <class ElasticScene>
  void couple(const ElasticScene& scene, const std::string& section, const NumericsScene& numerics,
              dem::Wall& wall);

  fem::ElasticBody body_;
  std::optional<coupling::ElasticWall> coupled_;
  double face_radius_;  // [m]
};

}  // namespace apps
