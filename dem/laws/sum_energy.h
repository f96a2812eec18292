// Energies of laws that act side by side: they add.
#pragma once

#include "dem/contact_energy.h"
#include "dem/laws/sum.h"

namespace dem {

template <class A, class B>
Stored stored(const Sum<A, B>& law, const Seen<Sum<A, B>>& seen) {
  return stored(law.a, Seen<A>{seen.contact, seen.memory.a}) +
         stored(law.b, Seen<B>{seen.contact, seen.memory.b});
}

template <class A, class B>
Lost lost(const Sum<A, B>& law, const Seen<Sum<A, B>>& before, const Seen<Sum<A, B>>& now) {
  return lost(law.a, Seen<A>{before.contact, before.memory.a}, Seen<A>{now.contact, now.memory.a}) +
         lost(law.b, Seen<B>{before.contact, before.memory.b}, Seen<B>{now.contact, now.memory.b});
}

}  // namespace dem
