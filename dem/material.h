// Elastic constants of what meets in a contact.
#pragma once

namespace dem {

struct Material {
  double young;    // E [Pa]
  double poisson;  // nu [-]
};

inline double shear_modulus(const Material& m) {
  return m.young / (2 * (1 + m.poisson));
}

// Compliance of one body against normal approach, (1 - nu^2) / E [1/Pa] (Hertz 1882).
inline double normal_compliance(const Material& m) {
  return (1 - m.poisson * m.poisson) / m.young;
}

// Compliance of one body against tangential displacement, (2 - nu) / G [1/Pa] (Mindlin 1949).
inline double shear_compliance(const Material& m) {
  return (2 - m.poisson) / shear_modulus(m);
}

}  // namespace dem
