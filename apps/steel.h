// The elastic steel of a gyratory scene, as the run sees it. What the scene names is meshed,
// reduced and coupled by the program gyratory_elastic, which is linked with the finite elements; a
// scene whose steel is all rigid runs in the program gyratory, which is not.
#pragma once

#include <Eigen/Dense>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "apps/archive.h"
#include "apps/machine.h"
#include "dem/wall.h"

namespace apps {

// One elastic body behind one wall of the run.
class SteelPart {
 public:
  virtual ~SteelPart() = default;

  // After every time step: what the stones left in the letterbox, and how the face moves.
  virtual void exchange(dem::Wall& wall, dem::Steps steps) = 0;
  virtual void visit_state(Archive& item, const std::string& in) = 0;  // see dem/state.h

  struct Outline {
    int unknowns;             // of the full body
    double mass;              // [kg]
    double gain;              // bed stiffness / modal stiffness, at most [-]
    double truncation;        // first compliance that the modes leave out / largest [-]
    int swinging, following;  // modes
    double lowest_frequency;  // of those that swing, by their scaled mass [Hz]
  };
  virtual Outline outline() const = 0;

  // Static answer of the head's face to a unit moment about y and a unit force along x, both at the
  // centre of the face: rotation about y [rad/(N m)], [rad/N], by the full body.
  struct Tilt {
    double per_moment, per_force;
  };
  virtual Tilt tilt() const = 0;

  // Of a mould, by the full body, see steel_answers.h: forces at the nodes of its letterbox (3
  // each) [N] to the strain of a gauge [1/N], and to the hoop stress of its inner face there [Pa].
  virtual Eigen::VectorXd gauge_influence(const dem::SurfaceField& field,
                                          const GaugeScene& gauge) const = 0;
  virtual std::vector<double> hoop_stress(const dem::SurfaceField& field,
                                          const Eigen::VectorXd& forces) const = 0;

  // The deformed body in the laboratory with displacement and stress (displacement not magnified).
  virtual void draw(const std::string& vtu, const dem::Frame& frame) const = 0;
};

using Steel = std::unique_ptr<SteelPart>;  // none: rigid

// Gives `wall` its letterbox and reduces the body to the scene's modes; nothing of a body that the
// scene has not. Throws InputError where the body has not as many modes.
Steel make_steel(const std::optional<ElasticHeadScene>& scene, const Machine& machine,
                 const NumericsScene& numerics, dem::Wall& wall);
Steel make_steel(const std::optional<ElasticMouldScene>& scene, const Machine& machine,
                 const NumericsScene& numerics, dem::Wall& wall);

// Goes on, with that command line, as the program that knows the steel of the scene, if this one
// does not. Throws InputError where there is none.
void use_program_of(const GyratoryScene& scene, const std::vector<std::string>& command_line);

}  // namespace apps
