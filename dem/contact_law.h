// What a contact law is: a value with constants, a memory per contact made of nothing but numbers,
// and the force of one step. Add a law as one header in dem/laws/ and one line in apps/laws.h.
#pragma once

#include <concepts>
#include <type_traits>

#include "dem/contact.h"

namespace dem {

template <class Law>
concept ContactLaw = std::is_trivially_copyable_v<typename Law::template Memory<double>> &&
                         sizeof(typename Law::template Memory<Pack>) ==
                         lanes * sizeof(typename Law::template Memory<double>) &&
                     requires(Law law, const Law constant, Contact<double> contact,
                              typename Law::template Memory<double> memory) {
  // May a stone break under this law (then F / R0^2 of every contact is watched)?
  { Law::breaks } -> std::convertible_to<bool>;
  // Does the contact live on although its surfaces have parted?
  { Law::template holds<double>(memory) } -> std::convertible_to<bool>;
  // Coefficients that depend on the time step [s] only.
  law.set_time_step(1e-6);
  // The force of this step; all-zero memory means that the contact is new.
  { constant(contact, memory) } -> std::same_as<Response<double>>;
};

}  // namespace dem
